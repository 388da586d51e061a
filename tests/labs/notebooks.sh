#!/usr/bin/env bash
# The notebooks of the labs: every cell runs, with the solutions; with the gaps open they name the first one.
exec "$PYTHON" tests/labs/notebooks.py
