#!/usr/bin/env bash
# Idle roller on a spring, coarse: numbers against spring-roller.json, formula and duality by the case itself.
exec "$PYTHON" tests/regression/case.py spring-roller
