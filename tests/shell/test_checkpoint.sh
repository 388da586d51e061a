#!/usr/bin/env bash
# A run that is killed goes on by -resume 1 to the same bytes in all its files, one that is interrupted too: a case, and a script with a law and variables of its own,
# which calls nothing for it. What does not belong to a checkpoint is refused with what differs, status 20, and no file changes.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
kills() { "$PYTHON" -B tests/support/kills.py "$@" || failures=$((failures + 1)); }
coarse=(-element P1 -inner 4 -outer 40 -sides 6 -steps 40 -width 3 -check 0 -series 5)

# 1. a case of several tools, with friction and field series; a script that keeps its own history
kills rolling 3 cases/rolling/rolling.edp "${coarse[@]}"
mkdir -p "$SCRATCH/scripts"
sed 's/^func int record(real t) {.*/real turned = 0; string said = ""; real[int] angles(1); angles = 0; int steps = 0;\
func int record(real t) {\
  if (steps == 0) { ofstream head(rcNewName("own.csv")); head << "t,turned,said" << endl; rcReplaced(head, "own.csv"); }\
  ++steps; turned += roller.value("angle"); said = said + steps%7; angles.resize(steps); angles[steps - 1] = turned;\
  ofstream f("own.csv", append); f.precision(17);\
  f << t << "," << turned << "," << said << "," << angles.sum << endl; rcAppended(f, "own.csv"); return 0; }/
  s/1., 0.05, program/1., 0.04, program/
  $ a ofstream last("last.txt"); last.precision(17); last << turned << " " << said << " " << angles.l2 << " " << ep[].l2 << endl;' \
  edp/manual/examples/law-j2.edp >"$SCRATCH/scripts/own.edp"
kills own 2 "$SCRATCH/scripts/own.edp"
# a tool of which a number follows a formula of t
kills mandrel 1 edp/manual/examples/mandrel.edp -series 5
# a run on new meshes of its body: its mesh goes with the checkpoint
kills remeshed 3 cases/upsetting/upsetting.edp -n 4 -steps 20 -reduction 0.7 -remesh 1 -series 1 -check 0
grep -q 'burnish: new mesh at t = ' "$SCRATCH/remeshed/whole/log" || report "no new mesh in the run that is killed"

# 2. a run of which the last checkpoint is the one before its end
folder="$SCRATCH/refused"
run() { "$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -pictures 0 -out "$folder" "$@" >"$SCRATCH/log" 2>&1; }
(ulimit -t 1000; run -checkpoint 1e-9)
[ -s "$folder/run-1.checkpoint" ] && [ -s "$folder/run-1.checkpoint.old" ] || report "no two checkpoints: $(ls "$folder")"
content() { (cd "$folder" && cat history.csv events.csv tools.csv fields.pvd final.vtu run-1.checkpoint) | cksum; }
before=$(content)
# refused "words" OPTIONS...
refused() {
  local words=$1 status
  shift
  run -resume 1 "$@"
  status=$?
  [ "$status" = 20 ] || report "$*: exit status $status instead of 20"
  grep -qF -- "$words" "$SCRATCH/log" || { report "$*: no \"$words\""; tail -n 4 "$SCRATCH/log"; }
}
refused 'option -mu = 0.3, expected 0.2' -mu 0.3
refused 'tool "roller" = coordinates r phi theta, surface of mark' -R 14e-3
refused 'mesh = ' -outer 44
refused 'material = ' -H 9e8
refused 'steps = to t = 1, at most 0.02' -steps 50
refused 'option: -resume = 3, expected 0, 1 or 2' -resume 3
[ "$(content)" = "$before" ] || report "a refused run has changed files"

# 3. damaged, short; the older one is named and serves
cp "$folder/run-1.checkpoint" "$SCRATCH/whole"
head -c 5000 "$SCRATCH/whole" >"$folder/run-1.checkpoint"
refused 'it is cut off; the one before it, "'"$folder"'/run-1.checkpoint.old", of t = '
run -resume 2 || report "-resume 2: exit status $?"
grep -q 'burnish: goes on from .*run-1.checkpoint.old' "$SCRATCH/log" || report "-resume 2 does not go on from the older one"
cp "$SCRATCH/whole" "$folder/run-1.checkpoint"
truncate -s -20 "$folder/history.csv"
refused 'history.csv": has '
rm -f "$folder"/run-1.checkpoint*
run -resume 1 || report "without a checkpoint: exit status $?"
grep -q 'burnish: there is no .*run-1.checkpoint: the run begins at its start' "$SCRATCH/log" || report "no word that there is none"

# 4. another text of the script
sed 's/0.5\*R\*/&/' "$SCRATCH/scripts/own.edp" >"$SCRATCH/scripts/text.edp"
(cd "$SCRATCH/scripts" && "$BURNISH" text.edp -checkpoint 1e-9) >"$SCRATCH/log" 2>&1 || report "text: exit status $?"
sed -i 's/-400\*min/-401*min/; s/^real E/\/\/ a comment may change\n&/' "$SCRATCH/scripts/text.edp"
(cd "$SCRATCH/scripts" && "$BURNISH" text.edp -resume 1) >"$SCRATCH/log" 2>&1
[ $? = 20 ] || report "another text is not refused"
grep -qF 'script "text.edp" says `roller.force("y", -401*min(1., 2*t));' "$SCRATCH/log" || { report "no word of the text"; tail -n 4 "$SCRATCH/log"; }

# 4b. formulas that the text does not tell: of friction, of a tool's place, of hardening, of a point event
cat >"$SCRATCH/scripts/formulas.edp" <<'END'
include "burnish.idp"
string friction, rise, hardening, happens; // laws that the text of the script does not tell
{ ifstream f("formulas.txt"); getline(f, friction); getline(f, rise); getline(f, hardening); getline(f, happens); }
mesh Th = square(12, 4, [20*x - 10, 8*(y - 1)]);
fespace Vh(Th, [P2, P2]);
Vh [u, v] = [0, 0];
varf bottom([u, v], [p, r]) = on(1, u=1, v=1);
real[int] held = bottom(0, Vh, tgv=1);
material M = rcMaterial(Vh, E=7e4, nu=0.33, hardening=hardening);
M.event("flows", happens);
M.damage("flows", integrity=0.9);
tool roller(circle=15, name="roller");
roller.coordinates("s, h, a", x="s", y=rise, angle="a");
contact C = rcContact(Vh, label=3, fixed=held);
C.add(roller, frictionlaw=friction);
roller.place("h", 15.01);
func int program(real t) { roller.move("h", 15.01 - 0.05*t); roller.move("s", 0); roller.move("a", 0); return 0; }
func int record(real t) { return 0; }
stepcontrol S(1., dtmax=0.2);
rcRun(C, M, u[], S, program, record)
END
# formulas STATUS FRICTION PLACE HARDENING EVENT OPTIONS...
formulas() {
  local expected=$1 status
  printf '%s\n' "${@:2:4}" >"$SCRATCH/scripts/formulas.txt"
  (cd "$SCRATCH/scripts" && "$BURNISH" formulas.edp "${@:6}") >"$SCRATCH/log" 2>&1
  status=$?
  [ "$status" = "$expected" ] || { report "formulas ${*:2:4}: exit status $status instead of $expected"; tail -n 4 "$SCRATCH/log"; }
}
formulas 0 '0.3*p' h '150 + 500*ep' 'ep - 1e-3' -checkpoint 1e-9
formulas 20 '0.31*p' h '150 + 500*ep' 'ep - 1e-3' -resume 1
grep -qF 'by "0.31*p" 0.31 0.62, expected ' "$SCRATCH/log" || report "no word of the friction"
formulas 20 '0.3*p' 'h + 0.001*sin(s)' '150 + 500*ep' 'ep - 1e-3' -resume 1
grep -qF 'poses of mark ' "$SCRATCH/log" || report "no word of the place"
formulas 20 '0.3*p' h '150 + 500*ep + ep*(ep - 0.01)*(ep - 0.1)*(ep - 1)' 'ep - 1e-3' -resume 1
grep -qF 'hardening of mark ' "$SCRATCH/log" || report "no word of the hardening"
formulas 20 '0.3*p' h '150 + 500*ep' 'ep - 2e-3' -resume 1
grep -qF 'event "flows" = "ep - 2e-3" -> 0.9' "$SCRATCH/log" && grep -qF 'expected "ep - 1e-3" -> 0.9' "$SCRATCH/log" || report "no word of the event"
formulas 0 '0.3*p' h '150 + 500*ep' 'ep - 1e-3' -resume 1

# 5. Ctrl-C ends the step, writes a checkpoint and leaves; the run goes on from there to the same bytes
files() { (cd "$1" && cat history.csv events.csv tools.csv fields.pvd final.vtu) | cksum; }
interrupt() { # FOLDER OPTIONS...: interrupts the run when it has made some steps
  local at=$1 lines=0
  shift
  setsid "$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -pictures 0 -out "$at" "$@" >"$SCRATCH/log" 2>&1 &
  local process=$!
  while kill -0 $process 2>/dev/null && [ "${lines:-0}" -lt 6 ]; do
    sleep 0.02
    lines=$(grep -c . "$at/history.csv" 2>/dev/null)
  done
  kill -INT -- -$process
  wait $process
}
interrupt "$SCRATCH/stopped"
status=$?
[ $status = 130 ] || report "Ctrl-C: exit status $status instead of 130"
[ -s "$SCRATCH/stopped/run-1.checkpoint" ] || report "Ctrl-C writes no checkpoint: $(ls "$SCRATCH/stopped")"
"$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -pictures 0 -out "$SCRATCH/stopped" -resume 1 >"$SCRATCH/log" 2>&1 || report "after Ctrl-C: exit status $?"
grep -q 'burnish: goes on from .*run-1.checkpoint' "$SCRATCH/log" || report "after Ctrl-C the run does not go on"
"$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -pictures 0 -out "$SCRATCH/alone" >"$SCRATCH/log" 2>&1
[ "$(files "$SCRATCH/stopped")" = "$(files "$SCRATCH/alone")" ] || report "after Ctrl-C the files differ"
interrupt "$SCRATCH/bare" -checkpoint 0
[ -e "$SCRATCH/bare/run-1.checkpoint" ] && report "Ctrl-C writes a checkpoint with -checkpoint 0"

# 6. a checkpoint that cannot be written ends no run
"$BURNISH" cases/rolling/rolling.edp "${coarse[@]}" -pictures 0 -out "$SCRATCH/kept" -checkpoint -1 >"$SCRATCH/log" 2>&1
[ $? = 20 ] && grep -qF 'option: -checkpoint = -1, expected >= 0' "$SCRATCH/log" || report "-checkpoint -1 is taken"
exit $((failures > 0))
