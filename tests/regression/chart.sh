#!/usr/bin/env bash
# Scenes of the chart, coarse: other methods against our own, ours against the stored references.
exec "$PYTHON" tests/chart/check.py
