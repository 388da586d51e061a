#!/usr/bin/env bash
# The laws of the manual's page own-laws.md on a uniform block against exact answers, one of them not associated.
exec "$PYTHON" tests/verification/own_laws.py "$SCRATCH"
