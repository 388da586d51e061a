#!/usr/bin/env bash
# Case hertz, coarse, against Hertz, with the order of the pressure in the mesh size, and against stored numbers.
exec "$PYTHON" tests/regression/case.py hertz
