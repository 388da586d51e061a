#!/usr/bin/env bash
# Lab 3: open gaps of both scripts, the crank, answers and plot of the solution.
exec "$PYTHON" tests/labs/lab.py 3-rolling
