#!/usr/bin/env bash
# Example 1 on the default mesh with the steps halved: the numbers that the default run is compared with, and its balance.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$BURNISH" cases/rolling/rolling.edp -out "$SCRATCH/halved" -steps 200 -width 40 -pictures 0 -series 1 >"$SCRATCH/halved.log" || { tail -20 "$SCRATCH/halved.log"; exit 1; }
PYTHONPATH="$here/../regression" "$PYTHON" "$here/rolling_halved.py" "$SCRATCH/halved" ${1:+"$1"}
