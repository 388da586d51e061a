#!/usr/bin/env bash
# Tilted punch in space, coarse: the turned scene by the case itself, numbers against tilted-punch.json.
exec "$PYTHON" tests/regression/case.py tilted-punch
