#!/usr/bin/env bash
# Pictures and page of a run in space: tests/shell/space_pictures.py.
set -eu
"$PYTHON" tests/shell/space_pictures.py "$SCRATCH"
