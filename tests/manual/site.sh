#!/usr/bin/env bash
# The manual becomes a site without a warning: formulas, references, tables of contents.
exec make docs
