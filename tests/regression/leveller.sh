#!/usr/bin/env bash
# A bent strip between five idle and three driven rolls, coarse: numbers against leveller.json; balance and the plastic moment by the case.
exec "$PYTHON" tests/regression/case.py leveller
