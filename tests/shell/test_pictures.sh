#!/usr/bin/env bash
# rcCaseEnd's pictures for a script outside the tree: final.png, with -pictures 2 those of any scene, also of a run that stopped early; a plot.py
# beside the script goes first; one that fails only warns. Then each picture, and what is refused as one: pictures.py,
# and the parts: picture_parts.py.
set -eu
fail() { echo "FAILED: $1"; tail -n 30 "$SCRATCH/log.txt"; exit 1; }
# run STATUS NAME OPTIONS: the scene into the folder NAME; output in log.txt
run() {
  local wanted=$1 name=$2 status=0
  shift 2
  "$BURNISH" "$scene/press.edp" -out "$SCRATCH/$name" "$@" >"$SCRATCH/log.txt" 2>&1 || status=$?
  [ "$status" = "$wanted" ] || fail "$name: exit status $status instead of $wanted"
  [ -s "$SCRATCH/$name/history.csv" ] && [ -s "$SCRATCH/$name/final.vtu" ] || fail "$name: the files of the run"
}
# drawn NAME PICTURE...: these and no other; pictures.py looks at them
drawn() {
  local name=$1 found
  shift
  found=$(cd "$SCRATCH/$name" && find . -name '*.png' -printf '%f\n' | sort | xargs)
  [ "$found" = "$*" ] || fail "$name: drawn are \"$found\", expected \"$*\""
}
warned() { grep -q "burnish: warning: the pictures could not be drawn (exit status $1)" "$SCRATCH/log.txt"; }

scene="$SCRATCH/own scene" # a folder with a space in its name
mkdir "$scene"
cat >"$scene/press.edp" <<'END_OF_SCENE'
include "burnish.idp"
rcLeastSteps = 4; rcSeries = 3;
rcCaseOptions("press");
int fails = rcInt("-fails", 0);
rcOptionsEnd();
mesh Th = square(16, 8, [0.02*x - 0.01, 0.01*(y - 1)]);
NewMacro scene(Pk)
fespace Vh(Th, [Pk, Pk]);
Vh [u, v] = [0, 0];
varf bottom([u, v], [p, q]) = on(1, u=1, v=1);
real[int] held = bottom(0, Vh, tgv=1);
material M = rcMaterial(Vh, G=2.7e10, nu=0.32, sigY=1.93e8, H=9.62e8);
tool roller(circle=15e-3, name="roller");
roller.coordinates("cartesian");
roller.place("x", 0);
roller.place("y", 16e-3);
contact C = rcContact(Vh, label=3, fixed=held, friction=0.2, tolerance=rcTolerance);
C.add(roller);
C.approach(roller, "y", u[]);
func int program(real t) {
  roller.force("y", -4e5*t);
  if (fails && t > 0.3) roller.force("y", -4e9);
  roller.move("x", 0);
  roller.force("angle", 0);
  return 0;
}
func int record(real t) { return rcColumn("depth", 15e-3 - roller.value("y")); }
stepcontrol S(1., dtmax=1/rcLeastSteps, dtmin=1e-2);
rcCase(C, M, u[], S, program, record)
rcResult("depth", 15e-3 - roller.value("y"), "m");
rcCaseEnd(C, M, S);
EndMacro
if (rcElement == "P1") { scene(P1) } else { scene(P2) }
END_OF_SCENE

run 0 alone -series 0
drawn alone final.png
run 0 finished -pictures 2
drawn finished final.png history.png plastic-strain.png pressure.png scene.png sequence.png stress-error.png stress.png
! grep -q "burnish: warning: " "$SCRATCH/log.txt" || fail "finished: a warning"
run 3 stopped -fails 1 -series 0 -pictures 2
drawn stopped final.png history.png pressure.png scene.png stress-error.png stress.png

echo 'import sys; open(sys.argv[1] + "/own.txt", "w").write("drawn")' >"$scene/plot.py"
run 0 own -element P1 -series 0 -pictures 2
drawn own
[ -s "$SCRATCH/own/own.txt" ] || fail "own: the plot.py beside the script did not run"
echo 'raise SystemExit(7)' >"$scene/plot.py"
run 0 failing -element P1 -series 0 -pictures 2
warned 7 || fail "failing: no warning"
drawn failing
PYTHON=$SCRATCH/nothing run 0 without -element P1 -series 0
warned -1 || fail "without a Python: no warning"

# a script that reads no options: results in the folder out, not in the root of the file system
sed '/rcCaseOptions/d; /rcInt/d; /rcOptionsEnd/d; /fails/d; s/^rcLeastSteps/rcElement = "P1"; &/' "$scene/press.edp" \
  >"$SCRATCH/plain.edp"
(cd "$SCRATCH" && PYTHON=true "$BURNISH" plain.edp) >"$SCRATCH/log.txt" 2>&1 || fail "plain: exit status $?"
[ -s "$SCRATCH/out/final.vtu" ] || fail "plain: no results in out"

"$PYTHON" tests/shell/pictures.py "$SCRATCH"
"$PYTHON" tests/shell/picture_parts.py "$SCRATCH"
