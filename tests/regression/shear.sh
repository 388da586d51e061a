#!/usr/bin/env bash
# Case shear with fewer steps: closed forms by the case itself, numbers against shear.json.
exec "$PYTHON" tests/regression/case.py shear
