#!/usr/bin/env bash
# Case incline against Coulomb's law and stored numbers.
exec "$PYTHON" tests/regression/case.py incline
