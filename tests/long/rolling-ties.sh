#!/usr/bin/env bash
# Example 1 with and without tied edges (METHOD.md 3.19), in implicit and in event steps: stick zone, events, results.
# rolling-ties.sh [INNER OUTER SIDES [STEPS]]: on another mesh or with other steps; the checks are those of 10 150 20 (default).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
inner=${1:-10} outer=${2:-150} sides=${3:-20} steps=${4:-200}
run() {
  name=$1; shift
  "$BURNISH" cases/rolling/rolling.edp -inner "$inner" -outer "$outer" -sides "$sides" -steps "$steps" -width $((14*steps/200)) -pictures 0 \
    -series "$steps" -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }
}
run plain -tied 0
run tied -tied 1
if [ "${EVENT:-1}" = 1 ]; then run event -tied 1 -scheme event; fi
PYTHONPATH="$here/../regression:$here/../../cases" "$PYTHON" "$here/rolling_ties.py" "$SCRATCH"
