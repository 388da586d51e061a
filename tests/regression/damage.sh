#!/usr/bin/env bash
# Case damage, coarse: crumbles, heals, is pressed again; both schemes, both elements, without healing.
exec "$PYTHON" tests/regression/case.py damage
