#!/usr/bin/env bash
# Example 1 on the default mesh: what must hold of it (see rolling_default.py), with the steps halved beside it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
run() { name=$1; shift; "$BURNISH" cases/rolling/rolling.edp -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }; }
run default
run halved -steps 400 -width 28 -pictures 0 -series 1
"$PYTHON" "$here/rolling_default.py" "$SCRATCH/default" "$SCRATCH/halved"
