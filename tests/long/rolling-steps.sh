#!/usr/bin/env bash
# Example 1: error of its steps at every quarter of the program against four to five times finer ones on the same mesh: the default
# mesh, and one graded to the path; and the error of both against a mesh graded four times as fine with finer steps. Prints the tables.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
out=$SCRATCH
run() { name=$1; shift; "$BURNISH" cases/rolling/rolling.edp -pictures 0 -series 4 -out "$out/$name" "$@" >"$out/$name.log" || { tail -20 "$out/$name.log"; exit 1; }; }
graded="-inner 10 -outer 60 -sides 10 -graded 1.2e-4"
for mesh in default graded; do
  options=; [ $mesh = default ] || options=$graded
  run $mesh-fine $options -steps 800 -width 80
  run $mesh-half $options -steps 200 -width 40
  run $mesh $options
done
run graded-lean $graded -steps 60 -width 15
run graded-least -inner 6 -outer 40 -sides 8 -graded 1.1e-4 -steps 60 -width 10 -tolerance 1e-3
run reference ${graded/1.2e-4/3e-5} -steps 400 -width 60
PYTHONPATH="$here/../regression" "$PYTHON" "$here/rolling_steps.py" "$out"
