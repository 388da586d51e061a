#!/usr/bin/env bash
# Case punch, coarse, against the closed forms of full and partial contact and stored numbers.
exec "$PYTHON" tests/regression/case.py punch
