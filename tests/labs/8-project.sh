#!/usr/bin/env bash
# Lab 8: a wedge from a .geo file is pressed into a block and lifted.
exec "$PYTHON" tests/labs/lab.py 8-project
