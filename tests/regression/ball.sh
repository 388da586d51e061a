#!/usr/bin/env bash
# Ball on a block in space, coarse: numbers against ball.json, closed forms by the case itself.
exec "$PYTHON" tests/regression/case.py ball
