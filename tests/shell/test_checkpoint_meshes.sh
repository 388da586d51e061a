#!/usr/bin/env bash
# A run on new meshes of its body is killed twice and goes on to the same bytes, with the functions, meshes and arrays that its script keeps on them, in the
# plane and in space; and its end is the start of another script, on the mesh of the end.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
cd "$SCRATCH" || exit 1

cat >plane.edp <<'END'
load "msh3"
include "burnish.idp"
rcQuiet = true;
mesh Th = square(5, 5, [10*x, 10*y]), first = Th, before = Th;
fespace Vh(Th, [P2, P2]);
fespace Ph(Th, P1);
fespace Fh(first, P1);
Vh [u, v] = [0, 0], [g, h] = [0, 0];
Ph height = y, early = x^2;
Fh kept = x*y;
real[int] nodes(0), held(0);
string said = "";
int meshes = 0, records = 0;
varf lines([u, v], [p, q]) = on(4, u=1) + on(1, v=1);
held.resize(Vh.ndof); held = lines(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool platen(line=[40, 0, -10, 0], name="platen");
platen.coordinates("cartesian");
int[int] surface = [2, 3];
contact C = rcContact(Vh, labels=surface, fixed=held);
platen.place("y", 10.01);
C.add(platen, friction=0.2);
func int program(real t) { platen.move("x", 0); platen.move("angle", 0); platen.move("y", 10.01 - 3*t); return 0; }
stepcontrol S(1., dtmax=0.05);
func int record(real t) {
  if (records == 0) { ofstream f(rcNewName("own.csv")); f << "t" << endl; rcReplaced(f, "own.csv"); }
  ++records;
  if (meshes < 2 && t > 0.25 + 0.3*meshes) {
    before = Th;
    rcRemesh(S, C, M, Th, Vh, u, v, lines, 0.)
    ++meshes;
    height = y + meshes;
    nodes.resize(Th.nv); for (int i = 0; i < Th.nv; ++i) nodes[i] = Th(i).x*Th(i).y;
  }
  [g, h] = [u*t, v];
  kept = kept + t*x;
  said = said + meshes;
  { ofstream f("own.csv", append); f.precision(17); f << t << "," << g[].l2 << "," << height[].sum << "," << kept[].sum << "," << nodes.sum << endl; rcAppended(f, "own.csv"); }
  if (t > 0.45 + 0.3*(meshes - 1)) { string dies = "die" + meshes; exec("test -e " + dies + " && rm " + dies + " && kill -9 $PPID"); }
  return 0;
}
rcRun(C, M, u[], S, program, record)
ofstream last("last.txt");
last.precision(17);
last << g[].l2 << " " << height[].sum << " " << early[].n << " " << early[].sum << " " << kept[].sum << " " << nodes.sum << " " << said << " " << records << " "
     << before.nv << " " << before.area << " " << first.nv << " " << Th.nv << " " << Th.area << " " << platen.force("y") << " " << u[].l2 << " " << M.shape << endl;
END
cat >space.edp <<'END'
load "msh3"
include "burnish.idp"
rcQuiet = true;
mesh3 Th = cube(2, 2, 2, [x, y, z]), first = Th;
fespace Wh(Th, [P2, P2, P2]);
fespace Ph(Th, P1);
fespace Fh(first, P1);
Wh [u, v, w] = [0, 0, 0], [a, b, c] = [0, 0, 0];
Ph height = z;
Fh kept = x*y;
int meshes = 0, records = 0;
varf planes([u1, v1, w1], [p, q, r]) = on(4, u1=1) + on(1, v1=1) + on(5, w1=1);
real[int] held = planes(0, Wh, tgv=1);
material M = rcMaterial(Wh, E=2e5, nu=0.3, sigY=200, H=500);
tool plate(plane=[0, 0, 0, 0, 0, -1], size=1, name="plate");
plate.coordinates("z", x="0", y="0", z="z");
plate.place("z", 1.001);
contact C = rcContact(Wh, label=6, fixed=held);
C.add(plate, friction=0.1);
func int program(real t) { plate.move("z", 1.001 - 0.2*t); return 0; }
stepcontrol S(1., dtmax=0.1);
func int record(real t) {
  if (records == 0) { ofstream f(rcNewName("own.csv")); f << "t" << endl; rcReplaced(f, "own.csv"); }
  ++records;
  if (meshes == 0 && t > 0.35) {
    rcRemesh3(S, C, M, Th, Wh, u, v, w, planes, 0.)
    ++meshes;
    height = z + meshes;
  }
  [a, b, c] = [u*t, v, w];
  kept = kept + t*x;
  { ofstream f("own.csv", append); f.precision(17); f << t << "," << a[].l2 << "," << height[].sum << "," << kept[].sum << endl; rcAppended(f, "own.csv"); }
  if (t > 0.5) { string dies = "die" + meshes; exec("test -e " + dies + " && rm " + dies + " && kill -9 $PPID"); }
  return 0;
}
rcRun(C, M, u[], S, program, record)
ofstream last("last.txt");
last.precision(17);
last << a[].l2 << " " << height[].sum << " " << kept[].sum << " " << records << " " << first.nv << " " << Th.nv << " " << Th.measure << " " << plate.force("z") << " "
     << u[].l2 << " " << M.shape << " " << S.remeshings << endl;
END
# killed NAME TIMES: the script kills itself where a file die1, die2 is, after checkpoints on the first, the second new mesh
killed() {
  local status
  mkdir -p "$1/whole" "$1/killed"
  for folder in whole killed; do cp "$1.edp" "$1/$folder"; done
  (cd "$1/whole" && "$BURNISH" "$1.edp" -checkpoint 0 >log 2>&1) || report "$1: $(tail -n 3 "$1/whole/log")"
  cd "$1/killed" || exit 1
  for ((k = 1; k <= $2; ++k)); do touch "die$k"; done
  for ((k = 0; k <= $2; ++k)); do
    "$BURNISH" "$1.edp" -checkpoint 1e-9 -resume 1 >>log 2>&1
    status=$?
    [ "$status" = "$([ "$k" = "$2" ] && echo 0 || echo 137)" ] || report "$1: exit status $status of run $k: $(tail -n 3 log)"
  done
  [ "$(grep -c 'burnish: goes on from' log)" = "$2" ] || report "$1: goes on $(grep -c 'burnish: goes on from' log) times instead of $2"
  [ "$(grep -c 'burnish: new mesh at t = ' log)" = "$2" ] || report "$1: $(grep -c 'burnish: new mesh at t = ' log) new meshes instead of $2"
  cd ../..
  for file in own.csv last.txt; do
    cmp "$1/whole/$file" "$1/killed/$file" || { report "$1: $file differs"; cat "$1/whole/last.txt" "$1/killed/last.txt"; }
  done
}
killed plane 2
killed space 1

# a stage
cat >press.edp <<'END'
// Formed on two meshes; its end is the beginning of the next script, on the mesh of the end
include "burnish.idp"
rcQuiet = true;
mesh Th = square(5, 5, [10*x, 10*y]);
fespace Vh(Th, [P2, P2]);
Vh [u, v] = [0, 0];
varf lines([u, v], [p, q]) = on(4, u=1) + on(1, v=1);
real[int] held = lines(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool platen(line=[40, 0, -10, 0], name="platen");
platen.coordinates("cartesian");
int[int] surface = [2, 3];
contact C = rcContact(Vh, labels=surface, fixed=held);
platen.place("y", 10.01);
C.add(platen, friction=0.2);
func int program(real t) { platen.move("x", 0); platen.move("angle", 0); platen.move("y", 10.01 - 2*t); return 0; }
stepcontrol S(1., dtmax=0.1);
func int record(real t) {
  if (S.remeshings == 0 && t > 0.5) rcRemesh(S, C, M, Th, Vh, u, v, lines, 0.)
  return 0;
}
rcRun(C, M, u[], S, program, record)
S.checkpoint("press.checkpoint");
savemesh(Th, "press.msh");
real[int] sxx = M.stress(0), ep = M.plasticstraineq;
ofstream f("pressed.txt");
f.precision(17);
f << u[].l2 << " " << sxx.l2 << " " << ep.l2 << endl;
END
cat >service.edp <<'END'
include "burnish.idp"
rcQuiet = true;
string file;
{ ifstream f("mesh.txt"); getline(f, file); }
mesh Th = square(5, 5, [10*x, 10*y]);
if (file.length > 0) Th = readmesh(file);
fespace Vh(Th, [P2, P2]);
Vh [u, v] = [0, 0];
varf lines([u, v], [p, q]) = on(4, u=1) + on(1, v=1);
real[int] held = lines(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=200, H=500);
tool away(circle=3, name="away");
away.coordinates("cartesian");
away.place("y", 30);
int[int] surface = [2, 3];
contact C = rcContact(Vh, labels=surface, fixed=held);
C.add(away);
real unbalanced = rcStart(C, M, u[], "press.checkpoint");
real[int] sxx = M.stress(0), ep = M.plasticstraineq;
ofstream f("started.txt");
f.precision(17);
f << u[].l2 << " " << sxx.l2 << " " << ep.l2 << endl;
func int program(real t) { away.move("x", 0); away.move("angle", 0); away.move("y", 30); return 0; }
func int record(real t) { return 0; }
stepcontrol S(1., dtmax=0.5);
rcRun(C, M, u[], S, program, record)
END
"$BURNISH" press.edp >log 2>&1 || report "press: $(tail -n 3 log)"
grep -q 'burnish: new mesh at t = ' log || report "press: no new mesh"
echo press.msh >mesh.txt
"$BURNISH" service.edp >log 2>&1 || report "service: $(tail -n 3 log)"
cmp pressed.txt started.txt || report "the stage starts elsewhere: $(cat pressed.txt started.txt)"
echo >mesh.txt
"$BURNISH" service.edp >log 2>&1
[ $? = 20 ] && grep -q 'press.checkpoint": is of another run: mesh = ' log || report "a stage on the first mesh is taken: $(tail -n 3 log)"
exit $((failures > 0))
