#!/usr/bin/env bash
# Lab 6: Hertz by three methods of contact; a nearly incompressible block, a roller braked beyond its friction.
exec "$PYTHON" tests/labs/lab.py 6-accuracy-and-failure
