#!/usr/bin/env bash
# A script keeps values of every type that a checkpoint takes, and is killed once; a matrix is told. SIGTERM comes in a step that
# is too long to wait for: the run ends, and goes on from the last states, which are in memory, to the same bytes. Two runs of one
# script add to one file: killed in the first one and in the second, the file is that of a script that was left alone.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
cd "$SCRATCH" || exit 1

cat >values.edp <<'END'
include "burnish.idp"
rcQuiet = true;
mesh Th = square(3, 3, [10*x, 10*y]), before = Th;
fespace Vh(Th, [P2, P2]);
fespace Ph(Th, P1);
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
stepcontrol S(1., dtmax=0.1);

complex z = 0;
complex[int] list(2);
complex[int,int] table(2, 2);
real[int][int] lists(2);
real[string] numbers;
int[string] counts;
string[string] words;
string said = "";
Ph<complex> wave = 0;
Ph[int] series(1);
Vh[int] [a, b](2);
mesh[int] all(1);
matrix A = [[1., 0.], [0., 1.]];
int programs = 0, meshes = 0;
list = 0; table = 0; series[0] = 0; [a[0], b[0]] = [0, 0]; [a[1], b[1]] = [0, 0];
lists[0].resize(1); lists[0] = 0;
numbers["sum"] = 0;

func int program(real t) {
  ++programs;
  platen.move("x", 0); platen.move("angle", 0); platen.move("y", 10.01 - t);
  if (t > 0.7) exec("test -e waits && rm waits && kill -TERM $PPID && sleep 5.2");
  return 0;
}
func int record(real t) {
  if (meshes == 0 && t > 0.35) {
    rcRemesh(S, C, M, Th, Vh, u, v, lines, 0.)
    ++meshes;
  }
  z += t*1i; list[1] += z; table(0, 1) += z;
  lists[0].resize(lists[0].n + 1); lists[0][lists[0].n - 1] = t; lists[1].resize(2); lists[1] = t;
  numbers["sum"] = numbers["sum"] + t; counts["steps"] = counts["steps"] + 1; said = said + counts["steps"]; words["said"] = said;
  all.resize(counts["steps"]); all[counts["steps"] - 1] = Th;
  wave = wave + 1i*t*x;
  series.resize(programs); series[programs - 1] = t*x;   // early ones stay on the first mesh
  [a[1], b[1]] = [a[1] + t*x, b[1] + y];
  A(0, 0) = A(0, 0) + t;
  if (t > 0.55) exec("test -e dies && rm dies && kill -9 $PPID");
  return 0;
}
rcRun(C, M, u[], S, program, record)
real early = 0, late = 0, areas = 0;
for (int i = 0; i < counts["steps"]; ++i) areas += all[i].area*all[i].nv;
for (int i = 0; i < programs; ++i) { early += series[i][].sum; late += series[i][].n; }
ofstream last("last.txt");
last.precision(17);
last << z << " " << list[1] << " " << table(0, 1) << " " << lists[0].n << " " << lists[0].sum << " " << lists[1].sum << " " << numbers["sum"] << " " << counts["steps"] << " "
     << words["said"] << " " << imag(wave(5, 5)) << " " << early << " " << late << " " << a[1][].sum << " " << areas << " " << programs << " " << platen.force("y") << endl;
END
# run FOLDER STATUS OPTIONS...
run() {
  local folder=$1 expected=$2 status
  mkdir -p "$folder"
  cp values.edp "$folder"
  (cd "$folder" && "$BURNISH" values.edp "${@:3}") >log 2>&1
  status=$?
  [ "$status" = "$expected" ] || { report "$folder ${*:3}: exit status $status instead of $expected"; tail -n 4 log; }
}
run whole 0
run killed 0 -checkpoint 0 # makes the folder
touch killed/dies
run killed 137 -checkpoint 1e-9
run killed 0 -resume 1
grep -q 'burnish: goes on from' log || report "killed: does not go on"
grep -q 'warning: the run had changed matrix A of the script, which no checkpoint holds' log || report "killed: no word of the matrix"
cmp whole/last.txt killed/last.txt || { report "killed: other values"; cat whole/last.txt killed/last.txt; }

mkdir given-up
touch given-up/waits
run given-up 130
grep -q 'burnish: the step was given up; .*values/run-1.checkpoint is of t = 0\.[0-9]*$' log || { report "given up: no word of it"; tail -n 4 log; }
run given-up 0 -resume 1
grep -q 'burnish: goes on from .*, t = 0\.[0-9]* of 1' log || report "given up: does not go on"
cmp whole/last.txt given-up/last.txt || { report "given up: other values"; cat whole/last.txt given-up/last.txt; }
touch given-up/waits
rm -rf given-up/out
run given-up 130 -checkpoint 0
[ ! -e given-up/out/values/run-1.checkpoint ] || report "given up: a checkpoint with -checkpoint 0"

cat >two.edp <<'END'
include "burnish.idp"
rcQuiet = true;
mesh Th = square(3, 3, [10*x, 10*y]);
fespace Vh(Th, [P2, P2]);
Vh [u, v] = [0, 0], [a, b] = [0, 0];
varf lines([u, v], [p, q]) = on(4, u=1) + on(1, v=1);
real[int] held = lines(0, Vh, tgv=1);
int[int] surface = [2, 3];
tool platen(line=[40, 0, -10, 0], name="platen");
platen.coordinates("cartesian");
int runs = 0;
func int program(real t) { platen.move("x", 0); platen.move("angle", 0); platen.move("y", 10.01 - t); return 0; }
func int record(real t) {
  { ofstream f("own.csv", append); f.precision(17); f << runs << "," << t << "," << platen.force("y") << endl; rcAppended(f, "own.csv"); }
  if (t > 0.45) exec("test -e dies" + runs + " && rm dies" + runs + " && kill -9 $PPID");
  return 0;
}
NewMacro run(d, yield)
{
  material M = rcMaterial(Vh, E=2e5, nu=0.3, sigY=yield, H=500);
  contact C = rcContact(Vh, labels=surface, fixed=held);
  platen.place("y", 10.01);
  C.add(platen, friction=0.2);
  stepcontrol S(1., dtmax=0.1);
  ++runs;
  rcRun(C, M, d, S, program, record)
}
EndMacro
run(u[], 200)
run(a[], 300)
ofstream last("last.txt");
last.precision(17);
last << u[].l2 << " " << a[].l2 << " " << runs << endl;
END
# two FOLDER STATUS OPTIONS...
two() {
  mkdir -p "$1"
  cp two.edp "$1"
  (cd "$1" && "$BURNISH" two.edp "${@:3}") >>two.log 2>&1
  [ $? = "$2" ] || { report "$1 ${*:3}: another exit status than $2"; tail -n 4 two.log; }
}
two alone 0
mkdir two-kills
touch two-kills/dies1 two-kills/dies2
two two-kills 137 -checkpoint 1e-9
two two-kills 137 -checkpoint 1e-9 -resume 1
two two-kills 0 -checkpoint 1e-9 -resume 1
[ "$(grep -c 'burnish: goes on from' two.log)" = 3 ] || report "two runs: $(grep 'goes on' two.log)"
for file in own.csv last.txt; do cmp alone/$file two-kills/$file || report "two runs: $file differs"; done
two two-kills 0 -resume 2
grep -q 'goes on from .*run-2.checkpoint.old' two.log || report "two runs: -resume 2 is not of the last run"
for file in own.csv last.txt; do cmp alone/$file two-kills/$file || report "two runs: -resume 2: $file differs"; done
rm two-kills/own.csv
touch two-kills/dies1
two two-kills 137 -checkpoint 1e-9 # begins anew: what was of the second run makes way
ls two-kills/out/two/run-2.* 2>/dev/null && report "two runs: a checkpoint of the second one is left over"
two two-kills 0 -checkpoint 1e-9 -resume 1
for file in own.csv last.txt; do cmp alone/$file two-kills/$file || report "two runs: begun anew: $file differs"; done
exit $((failures > 0))
