#!/usr/bin/env bash
# The pictures show the parts that symmetry leaves out where the script says so, rcSymmetry, and nowhere else: ends that are only held make
# no mirror. A word that it does not take, and a workpiece on both sides of the line, are errors.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
cat >"$SCRATCH/block.edp" <<'END'
include "burnish.idp"
rcCaseOptions("block");
rcSymmetry = rcText("-lines", "", "", "");
real x0 = rcReal("-from", 0, "mm", "");
rcOptionsEnd();
mesh Th = square(4, 4, [x0 + 10*x, 10*y]);
fespace Vh(Th, [P2, P2]);
Vh [u, v] = [0, 0];
varf ends([u, v], [p, q]) = on(1, v=1) + on(4, u=1);
real[int] held = ends(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool plate(line=[40, 0, -40, 0], name="plate");
plate.coordinates("cartesian");
plate.place("y", 10);
contact C = rcContact(Vh, label=3, fixed=held);
C.add(plate);
func int program(real t) { plate.move("x", 0); plate.move("y", 10 - 0.01*t); plate.move("angle", 0); return 0; }
func int record(real t) { return 0; }
stepcontrol S(1., dtmax=0.5);
rcCase(C, M, u[], S, program, record)
rcCaseEnd(C, M, S);
END
run() { "$BURNISH" "$SCRATCH/block.edp" -series 0 -out "$SCRATCH/out" "$@" >"$SCRATCH/log.txt" 2>&1; }

for lines in '' x y xy; do
  run ${lines:+-lines "$lines"} -pictures $([ "$lines" = xy ] && echo 1 || echo 0) || { report "lines \"$lines\": exit status $?"; tail -n 5 "$SCRATCH/log.txt"; }
  PYTHONPATH=cases "$PYTHON" -B -c "
from plotting.run import Run
signs = {'': [], 'x': [(-1, 1)], 'y': [(1, -1)], 'xy': [(-1, 1), (1, -1), (-1, -1)]}
mirrors = Run('$SCRATCH/out').mirrors
assert mirrors == signs['$lines'], mirrors" || report "lines \"$lines\""
done
[ -s "$SCRATCH/out/final.png" ] || report "no picture"
# refused WORDS OPTION...
refused() {
  local words=$1 status
  shift
  run -pictures 0 "$@"
  status=$?
  [ "$status" = 20 ] && grep -qF "$words" "$SCRATCH/log.txt" || { report "$*: exit status $status"; tail -n 3 "$SCRATCH/log.txt"; }
}
refused 'rcSymmetry is "left", expected "", "x", "y" or "xy"' -lines left
refused 'rcSymmetry is "x", but the workpiece reaches from x = -5 to 5, expected an end at x = 0' -lines x -from -5

# in space: planes, all three
cat >"$SCRATCH/cube.edp" <<'END'
include "burnish.idp"
load "msh3"
rcCaseOptions("cube");
rcSymmetry = rcText("-lines", "", "", "");
real y0 = rcReal("-from", 0, "mm", "");
rcOptionsEnd();
mesh3 Th = cube(2, 2, 2, [x, y0 + y, z]);
fespace Vh(Th, [P2, P2, P2]);
Vh [u, v, w] = [0, 0, 0];
varf ends([u, v, w], [p, q, r]) = on(4, u=1) + on(1, v=1) + on(5, w=1);
real[int] held = ends(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool plate(plane=[0, 0, 0, 0, 0, -1], name="plate");
plate.coordinates("cartesian");
plate.place("z", 1);
contact C = rcContact(Vh, label=6, fixed=held);
C.add(plate);
func int program(real t) { plate.move("x", 0); plate.move("y", 0); plate.move("z", 1 - 0.001*t); plate.move("spinx", 0); plate.move("spiny", 0);
  plate.move("spinz", 0); return 0; }
func int record(real t) { return 0; }
stepcontrol S(1., dtmax=0.5);
rcCase(C, M, u[], S, program, record)
rcCaseEnd(C, M, S);
END
run() { "$BURNISH" "$SCRATCH/cube.edp" -series 1 -out "$SCRATCH/out" "$@" >"$SCRATCH/log.txt" 2>&1; }
run -lines xyz -pictures 1 || { report "xyz: exit status $?"; tail -n 5 "$SCRATCH/log.txt"; }
[ -s "$SCRATCH/out/final.png" ] || report "no picture in space"
refused 'rcSymmetry is "yx", expected some of x, y, z in this order' -lines yx
refused 'rcSymmetry is "y", but the workpiece reaches from y = -0.5 to 0.5, expected an end at y = 0' -lines y -from -0.5

echo "$failures failed"
[ "$failures" = 0 ]
