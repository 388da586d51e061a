#!/usr/bin/env bash
# Upsetting, coarse: numbers against upsetting.json, the force without friction against the formula by the case itself.
exec "$PYTHON" tests/regression/case.py upsetting
