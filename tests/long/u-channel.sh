#!/usr/bin/env bash
# U-channel, coarse: punch force, springback and thickness against u-channel.json, balance by the case itself.
exec "$PYTHON" tests/regression/case.py u-channel
