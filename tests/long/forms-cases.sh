#!/usr/bin/env bash
# Cases with the law of the script (-forms 1): rings, several tools, event steps with events of elements, P1, FreeFEM's solvers.
# Each fulfills its own expectations, and its forces are those of the core's law, whose return takes smaller steps.
set -eu
here=$(cd "$(dirname "$0")/../regression" && pwd)
run() { name=$1; shift; case=$1; shift; "$BURNISH" "cases/$case/$case.edp" -pictures 0 -series 1 -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }; }
both() { name=$1; shift; case=$1; shift; shared=$1; shift; run "$name" "$case" $shared; run "$name-forms" "$case" $shared -forms 1 "$@"; }
both ring upsetting "-n 8 -steps 40 -axisymmetric 1"
both ring-p1 upsetting "-n 8 -steps 40 -axisymmetric 1 -element P1" -assembly core
both planetary planetary "-element P1 -fine 0.8e-3 -coarse 0.8e-3 -inner 98" -assembly core
both punch punch "-n 8 -scheme event" -solver UMFPACK
both rolling rolling "-inner 4 -outer 40 -sides 8 -events log -update single"
"$PYTHON" "$here/forms_cases.py" "$SCRATCH" ring ring-p1 planetary punch rolling
