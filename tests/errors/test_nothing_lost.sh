#!/usr/bin/env bash
# A run that ends early leaves whole results of its last accepted state and says how it ended: step floor (exit code 3),
# Ctrl-C and SIGTERM (130), errors of the program, of the forces within a step and of FreeFEM itself (20).
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
whole() { PYTHONDONTWRITEBYTECODE=1 "${PYTHON:-/usr/bin/python3}" tests/errors/whole.py "$@" || failures=$((failures + 1)); }
coarse=(-element P2 -inner 4 -outer 40 -sides 6 -pictures 0 -series 2)
# finish NAME CODE "words": the status and the last words of a run whose output is in $SCRATCH/NAME.log
finish() {
  [ "$status" = "$2" ] || { report "$1: exit status $status instead of $2"; tail -n 5 "$SCRATCH/$1.log"; }
  grep -qF -- "$3" "$SCRATCH/$1.log" || { report "$1: the output lacks \"$3\""; tail -n 5 "$SCRATCH/$1.log"; }
}

# 1. A load that nothing bears: elements are inverted
"$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -F0 1e9 -out "$SCRATCH/floor" >"$SCRATCH/floor.log" 2>&1
status=$?
finish floor 3 ', stopped by a self-check: an element is inverted'
whole "$SCRATCH/floor" 'stopped by a self-check' '' 20 15e-3

# 2. Ctrl-C and SIGTERM after some steps, in both integrators
for run in INT:implicit TERM:implicit INT:event; do
  signal=${run%:*} name=${run/:/-}
  "$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -steps 5000 -scheme "${run#*:}" -out "$SCRATCH/$name" \
    >"$SCRATCH/$name.log" 2>&1 &
  process=$!
  for _ in {1..300}; do
    [ "$(cat "$SCRATCH/$name/history.csv" 2>/dev/null | wc -l)" -lt 20 ] || break
    sleep 0.05
  done
  kill -s "$signal" "$process"
  wait "$process"
  status=$?
  finish "$name" 130 ', interrupted'
  whole "$SCRATCH/$name" interrupted interrupted 10 15e-3
done

# 2b. Scripts without a case have no files of their own: the last accepted state is in out/SCRIPT/stopped.vtu. A law of the script by
# FreeFEM's solver: Ctrl-C is heard, an error of the law ends the run as one; a law of the core
# kept NAME FIELD LEAST MOST: the largest component of a field of that file
kept() {
  "${PYTHON:-/usr/bin/python3}" -c 'import sys, meshio
name, least, most = sys.argv[2], *map(float, sys.argv[3:])
value = abs(meshio.read(sys.argv[1]).point_data[name]).max()
sys.exit(None if least < value < most else f"FAILED: {sys.argv[1]}: {name} {value}, expected {least} to {most}")' \
    "$SCRATCH/out/$1/stopped.vtu" "${@:2}" || failures=$((failures + 1))
  grep -q "burnish: the last accepted state, t = .*, is in out/$1/stopped.vtu" "$SCRATCH/$1.log" || report "$1: no word of stopped.vtu"
}
sed 's/1., 0.05, program/1., 5e-4, program/; s/^func int record(real t) {/& cout << "at " << t << endl;/' edp/manual/examples/law-j2.edp >"$SCRATCH/law.edp"
(cd "$SCRATCH" && exec "$BURNISH" law.edp) >"$SCRATCH/law.log" 2>&1 &
process=$!
for _ in {1..300}; do
  [ "$(grep -c '^at ' "$SCRATCH/law.log")" -lt 5 ] || break
  sleep 0.05
done
kill -s INT "$process"
wait "$process"
status=$?
finish law 130 ', interrupted'
kept law displacement 1e-5 1
sed 's/^func int lawStress(real\[int\] & d, real dt) {/& rcCheck(ep[].max < 0.004, "the law ends at a plastic strain of 0.004");/' \
  edp/manual/examples/law-j2.edp >"$SCRATCH/law-error.edp"
(cd "$SCRATCH" && "$BURNISH" law-error.edp) >"$SCRATCH/law-error.log" 2>&1
status=$?
finish law-error 20 'error: the law ends at a plastic strain of 0.004'
kept law-error displacement 0.004 0.02
awk '/^```freefem/ { inside = 1; next } /^```/ { inside = 0 } inside' README.md |
  sed 's/^func int record(real t) {/& rcCheck(t < 0.5, "enough");/' >"$SCRATCH/core.edp"
(cd "$SCRATCH" && "$BURNISH" core.edp) >"$SCRATCH/core.log" 2>&1
status=$?
finish core 20 'error: enough'
kept core plastic_strain_eq 1e-4 0.02
# where the file cannot be written the run ends as it would
(cd "$SCRATCH" && rm -r out && touch out && "$BURNISH" core.edp) >"$SCRATCH/core.log" 2>&1
status=$?
finish core 20 'the last accepted state is lost: file "out/core/stopped.vtu" cannot be written'
rm "$SCRATCH/out"

# 3. Errors on the way: copies of the case with one line more
# broken NAME SED-COMMAND
broken() {
  mkdir -p "$SCRATCH/$1.case"
  sed "$2" cases/rolling/rolling.edp >"$SCRATCH/$1.case/rolling.edp"
  ! cmp -s cases/rolling/rolling.edp "$SCRATCH/$1.case/rolling.edp" || report "$1: the case could not be changed"
  "$BURNISH" "$SCRATCH/$1.case/rolling.edp" "${coarse[@]}" -out "$SCRATCH/$1" >"$SCRATCH/$1.log" 2>&1
  status=$?
}
at='func int program(real t) {'
broken drive "s/^$at/$at rcCheck(t < 0.5, \"the drive gives up at t = \" + t);/"
finish drive 20 ', error: the drive gives up at t = 0.5'
whole "$SCRATCH/drive" error 'the drive gives up at t = 0.5' 20 15e-3

broken motion "s/^$at/$at if (t > 0.5) roller.move(\"psi\", 0);/"
finish motion 20 'has no coordinate "psi"'
whole "$SCRATCH/motion" error 'has no coordinate "psi", expected one of r, phi, theta' 20 15e-3

# a load that goes back while the moment stays: no step is short enough
broken floor2 's/-F0\*t);/-F0*min(t, 1.6 - 2*t));/'
finish floor2 3 ', step below its floor'
whole "$SCRATCH/floor2" 'step below its floor' 'too little to balance a coordinate under force' 20 15e-3

# within a step, when the displacements are those of the predictor already
broken force "s/^$at/$at if (t > 0.5) { real[int] f(Vh.ndof); f = 0; f[0] = sqrt(-1.); C.external(f); }/"
finish force 20 ', error: contact.external: value '
whole "$SCRATCH/force" error 'contact.external: value ' 20 15e-3

broken record 's/^func int record(real t) {/& int[int] two(2); if (t > 0.5) two[7] = 1;/'
finish record 20 'Out of bound in operator []'
whole "$SCRATCH/record" error 'an error of the script or of FreeFEM, reported above' 20 15e-3

# a formula of the roller's coordinates that ends at phi = 1.6, on the way
broken formula 's|^roller.coordinates(.*|roller.coordinates("r, phi, theta", x="r*cos(phi)+1e-30*sqrt(phi-1.6)", y="r*sin(phi)", angle="theta");|'
finish formula 20 'x of tool "roller" "r*cos(phi)+1e-30*sqrt(phi-1.6)": sqrt(-'
whole "$SCRATCH/formula" error 'is no finite real number, at r = 0.0' 20 15e-3

# external forces of another size are refused, not left out
broken external 's/^rcContactAngles = /real[int] three(3); three = 0; C.external(three); &/'
finish external 20 'contact.external: size of the values = 3, expected '

# 4. Names and numbers that JSON does not take as they are
odd="$SCRATCH/a \"quoted\" \\name"
"$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -nu 0.3200000001 -out "$odd" >"$SCRATCH/odd.log" 2>&1
status=$?
finish odd 0 'rolling: finished at t = 1'
whole "$odd" finished '' 20 15e-3
"${PYTHON:-/usr/bin/python3}" - "$odd" <<'END' || report "the options of the summary"
import json, sys
options = json.load(open(sys.argv[1] + "/summary.json"))["options"]
assert options["out"] == sys.argv[1], options["out"]
assert options["nu"] == 0.3200000001, options["nu"]
END

echo "$failures failed"
[ "$failures" = 0 ]
