#!/usr/bin/env bash
# Case partial-slip, coarse, against Cattaneo and Mindlin, with its duality, and against stored numbers.
exec "$PYTHON" tests/regression/case.py partial-slip
