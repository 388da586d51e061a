#!/usr/bin/env bash
# All commands that the manual prints, the long ones, too.
exec "$PYTHON" tests/shell/snippets.py all
