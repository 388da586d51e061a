#!/usr/bin/env bash
# Lab 1: open gaps, answers and plot of the solution.
exec "$PYTHON" tests/labs/lab.py 1-contact
