#!/usr/bin/env bash
# Two passes over a plate, coarse: numbers against plate-rolling.json.
exec "$PYTHON" tests/regression/case.py plate-rolling
