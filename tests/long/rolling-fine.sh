#!/usr/bin/env bash
# Example 1 on fine meshes and with a tight tolerance: minutes. Compared with the numbers of cases/rolling/README.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
run() { name=$1; shift; "$BURNISH" cases/rolling/rolling.edp -pictures 0 -series 1 -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }; }
run p2 -inner 20 -outer 300 -sides 40
run p1 -element P1 -inner 40 -outer 1200 -sides 80
run tight -tolerance 1e-8
run tight-event -scheme event -tolerance 1e-8
PYTHONPATH="$here/../regression" "$PYTHON" "$here/rolling_fine.py" "$SCRATCH"
