#!/usr/bin/env bash
# Cases in mm, N, MPa and in m, N, Pa, coarse: the same events, the same numbers.
exec "$PYTHON" tests/verification/units_cases.py
