#!/usr/bin/env bash
# Case cyclic, coarse, with each law: shakedown or ratchetting by the case itself, numbers against cyclic.json.
exec "$PYTHON" tests/regression/case.py cyclic
