#!/usr/bin/env bash
# Slab in space: beside the plane's run by the case itself, numbers against slab.json.
exec "$PYTHON" tests/regression/case.py slab
