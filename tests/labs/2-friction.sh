#!/usr/bin/env bash
# Lab 2: the incline, open gaps, answers and plot of the solution.
exec "$PYTHON" tests/labs/lab.py 2-friction
