#!/usr/bin/env bash
# The flat punch on finer and finer meshes: all errors are of the first order, since the pressure is singular at the edges.
set -eu
order() { "$PYTHON" tests/verification/case_order.py punch "$@" "tilt, e = a/4" 1 0.1 "e/a at the first release" 1 0.1; }
order "-element P1" "8 16 32" "p inside 0.9 a, e = 0: L2 error" 1 0.2 "p in partial contact: L2 error" 1 0.3
order "-element P2" "8 16"
