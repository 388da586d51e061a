#!/usr/bin/env bash
# Case rolling-contact, coarse, against Carter, with its duality, and against stored numbers.
exec "$PYTHON" tests/regression/case.py rolling-contact
