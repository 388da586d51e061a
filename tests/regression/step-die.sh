#!/usr/bin/env bash
# Grooved die from a STEP file, coarse: numbers against step-die.json, the chain and the joints by the case itself.
exec "$PYTHON" tests/regression/case.py step-die
