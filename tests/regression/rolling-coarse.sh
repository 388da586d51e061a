#!/usr/bin/env bash
# Example 1 coarse, both integrators, P2 and P1, against stored numbers (rolling-coarse.json, with tolerances).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
run() { name=$1; shift; "$BURNISH" cases/rolling/rolling.edp -pictures 0 -series 1 -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }; }
run p2 -inner 6 -outer 60 -sides 10
run p1 -element P1 -inner 6 -outer 90 -sides 12
run event -inner 4 -outer 40 -sides 8 -scheme event -tied 0
"$PYTHON" "$here/rolling_coarse.py" "$SCRATCH" "$here/rolling-coarse.json"
