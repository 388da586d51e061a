#!/usr/bin/env bash
# Lab 4: upsetting, open gaps, answers and plot of the solution.
exec "$PYTHON" tests/labs/lab.py 4-plasticity
