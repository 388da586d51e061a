#!/usr/bin/env bash
# Scenes of the chart, coarse: rivals against our own method, ours against the stored references.
exec "$PYTHON" tests/chart/check.py
