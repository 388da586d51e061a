#!/usr/bin/env bash
# A strip wound round a form, coarse: by motion, by force; numbers against roll-bending.json; balance and the work of bending by the case.
exec "$PYTHON" tests/regression/case.py roll-bending
