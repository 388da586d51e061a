#!/usr/bin/env bash
# Spline cam, coarse: numbers against cam.json, the rigid rolling by the case itself.
exec "$PYTHON" tests/regression/case.py cam
