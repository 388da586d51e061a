#!/usr/bin/env bash
# Bending, drawing and deep drawing of sheets: steps, forces and shapes; the same in metres and turned by 30 degrees.
exec "$PYTHON" tests/support/forming/check.py test
