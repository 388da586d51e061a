#!/usr/bin/env bash
# The notebooks of labs 1, 4 and 6: every cell runs, with the solutions; with the gaps open they name the first one.
exec "$PYTHON" tests/labs/notebooks.py
