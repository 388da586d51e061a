#!/usr/bin/env bash
# Upsetting of a block in space, P2 and P1: the case's own formulas, and numbers against block-upsetting.json.
exec "$PYTHON" tests/regression/case.py block-upsetting
