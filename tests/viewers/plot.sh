#!/usr/bin/env bash
# rcPlot in FreeFEM's window, on a display of its own: the field is seen on the deformed body, in the plane and in space, and the window waits.
set -u
failures=0
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
Xvfb -displayfd 5 -screen 0 1100x800x24 -nolisten tcp 5>"$SCRATCH/display" 2>/dev/null &
server=$!
trap 'kill $server' EXIT
for _ in $(seq 100); do [ -s "$SCRATCH/display" ] && break; sleep 0.2; done
DISPLAY=:$(cat "$SCRATCH/display")
export DISPLAY

cat >"$SCRATCH/plane.edp" <<'END_OF_SCENE'
include "burnish.idp"
mesh Th = square(8, 4, [2*x - 1, y - 1]);
fespace Vh(Th, [P1, P1]);
Vh [u, v] = [0, 0];
varf bottom([a, b], [p, q]) = on(1, a=1, b=1);
real[int] held = bottom(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool roller(circle=2, name="roller");
roller.coordinates("cartesian");
roller.place("y", 2.1);
contact C = rcContact(Vh, label=3, fixed=held);
C.add(roller);
C.approach(roller, "y", u[]);
func int program(real t) { roller.move("x", 0); roller.move("y", 2 - 0.2*t); roller.move("angle", 0); return 0; }
func int record(real t) { rcPlot(C, M, u[]) return 0; }
stepcontrol S(1., dtmax=1.);
rcRun(C, M, u[], S, program, record)
END_OF_SCENE
sed -e 's/^mesh Th.*/load "msh3"\nmesh3 Th = cube(4, 4, 2, [2*x - 1, 2*y - 1, z - 1]);/' -e 's/\[P1, P1\]/[P1, P1, P1]/; s/\[u, v\] = \[0, 0\]/[u, v, w] = [0, 0, 0]/' \
  -e 's/\[a, b\], \[p, q\]) = on(1, a=1, b=1)/[a, b, c], [p, q, r]) = on(5, a=1, b=1, c=1)/; s/circle=/sphere=/; s/label=3/label=6/' \
  -e 's/place("y"/place("z"/; s/approach(roller, "y"/approach(roller, "z"/; s/move("y", 2 - /move("z", 2 - /' \
  -e 's/roller.move("angle", 0);/roller.move("y", 0); roller.move("spinx", 0); roller.move("spiny", 0); roller.move("spinz", 0);/' \
  "$SCRATCH/plane.edp" >"$SCRATCH/space.edp"

for scene in plane space; do
  setsid "$BURNISH" -wg "$SCRATCH/$scene.edp" >"$SCRATCH/$scene.log" 2>&1 </dev/null &
  run=$!
  "$PYTHON" - "$SCRATCH/$scene.png" $run <<'END' || fail "$scene: $(tail -n 3 "$SCRATCH/$scene.log")"
import os, sys, time
import numpy as np
from PIL import ImageGrab
for _ in range(120):       # seconds, as long as the run is there
    time.sleep(1)
    picture = ImageGrab.grab()
    seen = np.asarray(picture.convert("RGB")).astype(int)
    window = max((seen.sum(axis=2) > 0).sum(), 1)
    colors, number = np.unique(seen[np.ptp(seen, axis=2) > 100], axis=0, return_counts=True)
    bands = (number > 0.005 * window).sum()      # those of the key are smaller
    if bands > 2 or not os.path.exists("/proc/" + sys.argv[2]):
        break
picture.save(sys.argv[1])
print(f"{bands} colors of the field are seen, expected at least 3")
sys.exit(not bands > 2)
END
  kill -0 $run 2>/dev/null || fail "$scene: the window does not wait"
  kill -- -$run 2>/dev/null
done
[ $failures = 0 ]
