#!/usr/bin/env bash
# Cases and their copies, renumbered and turned by 30 degrees, take the same steps and reject the same ones: no step is decided by rounding.
# The table in cxx/ALGORITHMS.md 5.11 is what it prints.
exec "$PYTHON" tests/long/copies.py "$SCRATCH"
