#!/usr/bin/env bash
# The indentation, coarse: numbers against indentation.json, Hertz before the first yield by the case itself.
exec "$PYTHON" tests/regression/case.py indentation
