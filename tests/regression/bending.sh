#!/usr/bin/env bash
# V-bending, coarse: numbers against bending.json, springback and balance by the case itself.
exec "$PYTHON" tests/regression/case.py bending
