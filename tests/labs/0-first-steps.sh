#!/usr/bin/env bash
# Lab 0: open gaps, the broken scripts and their messages, the mended ones, answers and plot of the solution.
exec "$PYTHON" tests/labs/lab.py 0-first-steps
