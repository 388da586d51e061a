#!/usr/bin/env bash
# Drawing and ironing of a cup, coarse: numbers against cup.json; balance, volume, Siebel's force and the clearance by the case itself.
exec "$PYTHON" tests/regression/case.py cup
