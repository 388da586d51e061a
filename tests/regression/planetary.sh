#!/usr/bin/env bash
# Example 2, coarse: P2 with pictures, P1 on the mesh where roller 1 leaves no plastic strain, the printed loads.
set -eu
exec "$PYTHON" tests/regression/case.py planetary
