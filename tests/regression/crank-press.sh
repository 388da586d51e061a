#!/usr/bin/env bash
# The crank press, coarse: numbers against crank-press.json, duality and virtual work by the case itself.
exec "$PYTHON" tests/regression/case.py crank-press
