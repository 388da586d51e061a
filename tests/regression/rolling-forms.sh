#!/usr/bin/env bash
# Example 1 coarse with one return per step: law of the core, of the script assembled by the core, and forms of the script
# give the same events and the same numbers, with the solver of the core and with FreeFEM's on the condensed matrix.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
run() { name=$1; shift; "$BURNISH" cases/rolling/rolling.edp -pictures 0 -series 1 -out "$SCRATCH/$name" "$@" >"$SCRATCH/$name.log" || { tail -20 "$SCRATCH/$name.log"; exit 1; }; }
coarse="-inner 4 -outer 40 -sides 8 -update single"
exact="-tolerance 1e-10" # the core damps tangents of its own law, so iterates differ
run implicit $coarse $exact
run implicit-law $coarse $exact -forms 1 -assembly core
run implicit-forms $coarse $exact -forms 1
run event $coarse $exact -scheme event -turn 3
run event-law $coarse $exact -scheme event -turn 3 -forms 1 -assembly core
small="-inner 3 -outer 24 -sides 5 -update single -steps 40 -turn 2 -tolerance 1e-9"
run umfpack $small -solver UMFPACK
run umfpack-law $small -forms 1 -assembly core -solver UMFPACK
run umfpack-forms $small -forms 1 -solver UMFPACK
run burnish-forms $small -forms 1 -solver BURNISH
"$PYTHON" "$here/rolling_forms.py" "$SCRATCH"
