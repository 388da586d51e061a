#!/usr/bin/env bash
# Ball that rolls on a block in space, too coarse for the case's own checks: numbers against ball-rolling.json.
exec "$PYTHON" tests/regression/case.py ball-rolling
