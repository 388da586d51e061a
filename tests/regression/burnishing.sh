#!/usr/bin/env bash
# Ball burnishing, coarse: numbers against burnishing.json.
exec "$PYTHON" tests/regression/case.py burnishing
