#!/usr/bin/env bash
# A law of the script under a roller, coarse: numbers against rubber.json; work and energy by the case itself.
exec "$PYTHON" tests/regression/case.py rubber
