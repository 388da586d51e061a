#!/usr/bin/env bash
# Lab 5: springback of a bent sheet, grip and curl of a rolled strip.
exec "$PYTHON" tests/labs/lab.py 5-forming
