#!/usr/bin/env bash
# Strip rolling, coarse: gripped and refused by the rolls; numbers against strip-rolling.json, the verdict by the case itself.
exec "$PYTHON" tests/regression/case.py strip-rolling
