#!/usr/bin/env bash
# A ring between roll, mandrel, cones and guides, coarse: numbers against ring-rolling.json.
exec "$PYTHON" tests/regression/case.py ring-rolling
