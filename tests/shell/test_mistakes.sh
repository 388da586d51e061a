#!/usr/bin/env bash
# One mistake each in README.md's script: the run says why it did not reach its end and leaves with a status, though the
# script holds nothing for it; no progress, carriage return, empty line or report of FreeFEM's in the log.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
awk '/^```freefem/ { inside = 1; next } /^```/ && inside { exit } inside' README.md | sed 's/square(60, 20,/square(20, 6,/' >"$SCRATCH/base.edp"
# made NAME SED-COMMAND: the script with the mistake
made() {
  sed -e "$2" "$SCRATCH/base.edp" >"$SCRATCH/$1.edp"
  ! cmp -s "$SCRATCH/base.edp" "$SCRATCH/$1.edp" || report "$1: the script could not be changed"
}
# judge NAME STATUS "words|more words": what the run printed
judge() {
  local log="$SCRATCH/$1.log" word
  [ "$status" = "$2" ] || { report "$1: exit status $status instead of $2"; tail -n 5 "$log"; }
  while IFS= read -r word; do
    grep -qF -- "$word" "$log" || { report "$1: the output lacks \"$word\""; tail -n 5 "$log"; }
  done <<<"${3//|/$'\n'}"
  ! grep -q $'\r' "$log" || report "$1: carriage returns in a log"
  ! grep -q '^ *$' "$log" || report "$1: empty lines"
}
# wrong NAME SED-COMMAND STATUS "words|more words"
wrong() {
  made "$1" "$2"
  (cd "$SCRATCH" && exec "$BURNISH" "$1.edp" >"$1.log" 2>&1 </dev/null)
  status=$?
  judge "$1" "$3" "$4"
  ! sed '1,/stopped early/d' "$SCRATCH/$1.log" | grep -q . || report "$1: the reason is not the last line"
}
early='burnish: stopped early at t = '

wrong misspelled 's/force("angle", 0)/force("theta", 0)/' 20 "$early|tool \"roller\" has no coordinate \"theta\", expected one of x, y, angle"
wrong forgotten '/force("angle", 0)/d' 20 "$early|coordinate \"angle\" of tool \"roller\" has neither motion nor force"
wrong unadded 's/^contact C/tool spare(circle=1e-3, name="spare");\nspare.coordinates("cartesian");\n&/; s/roller.force("angle", 0);/&\n  spare.move("x", 0);/' \
  0 'tool "spare" is moved or loaded, but belongs to no contact'
wrong apart '/^C.approach/d' 20 "$early|is under force but the tool touches nothing"
wrong pulling 's/-4e5\*t/4e5*t/' 3 "$early|step below its floor"
wrong free 's/ fixed=held,//' 20 "$early"
wrong overload 's/-4e5\*t/-4e10*t/' 3 "$early|stopped by a self-check: an element is inverted"
wrong infinite 's|-4e5\*t|1/0.*t|' 20 "Div by 0|$early|an error of the script or of FreeFEM, reported above"
wrong nodes 's/^func int record(real t) {/& if (t > 0.5) rcCheck(false, "enough");/' 20 "$early|error: enough"

# a script that goes on after a failed run, and one that leaves out the runs after it
made further 's/-4e5\*t/-4e10*t/; s/^rcRun(.*/rcKeepGoing = true;\n&\ncout << "went on, status " << rcStatus << endl;/'
(cd "$SCRATCH" && exec "$BURNISH" further.edp >further.log 2>&1 </dev/null)
status=$?
judge further 0 "$early|went on, status 5"

# Ctrl-C
made interrupted 's/dtmax=0.05/dtmax=1e-4/'
: >"$SCRATCH/interrupted.log" # there before it is looked into
(cd "$SCRATCH" && exec "$BURNISH" interrupted.edp >interrupted.log 2>&1 </dev/null) &
process=$!
for _ in {1..300}; do
  [ "$(grep -c '^t ' "$SCRATCH/interrupted.log" 2>/dev/null)" -lt 3 ] || break
  sleep 0.05
done
kill -s INT "$process" $(pgrep -P "$process") 2>/dev/null
wait "$process"
status=$?
judge interrupted 130 "$early|interrupted"
# timeout(1) signals a program twice at once, itself and its group: that is one request
(cd "$SCRATCH" && timeout 3 "$BURNISH" interrupted.edp >interrupted.log 2>&1 </dev/null)
status=$?
judge interrupted 124 "$early|interrupted"

# a run that violates a self-check ends with its own status; the script goes on to its last line and writes its files
made overlap 's/"x", -1e-3)/"x", 26e-3)/; s/"y", 16e-3/"y", -5e-3/; /^C.approach/d; s/force("y", -4e5\*t)/move("y", -5e-3)/
  s/-1e-3 + 2e-3\*t/26e-3 - 2e-3*t/; s/force("angle", 0)/move("angle", 0)/; s/dtmax=0.05/dtmax=0.2/'
echo 'rcSummaryWrite(C, M, S, "overlap.json"); cout << "went on" << endl;' >>"$SCRATCH/overlap.edp"
(cd "$SCRATCH" && exec "$BURNISH" overlap.edp >overlap.log 2>&1 </dev/null)
status=$?
judge overlap 4 'burnish: finished, not to be trusted: overlap: tool "roller" overlaps the workpiece|went on'
for word in '"status": "finished, not to be trusted"' '{"check":"overlap","severity":"untrusted"' '"measured": {"' '"checks": '; do
  grep -qF "$word" "$SCRATCH/overlap.json" || report "overlap: the summary lacks $word"
done
"$PYTHON" -m json.tool "$SCRATCH/overlap.json" >/dev/null || report "overlap: the summary is no JSON"

# the end of a case without its run; results without a case are printed at once; a sweep whose variants would share one folder
made ending '$s/$/\nrcResult("depth", 15e-3 - roller.value("y"), "m");\nrcCaseEnd(C, M, S);/; s/dtmax=0.05/dtmax=0.5/'
(cd "$SCRATCH" && exec "$BURNISH" ending.edp >ending.log 2>&1 </dev/null)
status=$?
judge ending 20 "  depth   |burnish: rcCaseEnd: no rcCase was run, which writes the files; expected rcCase("
printf 'include "burnish.idp"\nreal R = rcReal("-R", 1);\nrcOptionsEnd();\n// rcCaseEnd(C, M, S)\n' >"$SCRATCH/shared.edp"
(cd "$SCRATCH" && exec "$BURNISH" sweep shared.edp R=1,2 >shared.log 2>&1 </dev/null)
status=$?
judge shared 20 'shared.edp has no option -out, by which each variant gets a folder of its own, expected rcCaseOptions("shared");'

# warnings come with rcQuiet too, and into the summary: a roller tighter than the mesh
made quiet 's/circle=15e-3/circle=1e-4/; s/"y", 16e-3/"y", 1e-3/; s/force("y", -4e5\*t)/move("y", 1e-4 - 1e-6*t)/
  s/-1e-3 + 2e-3\*t/-1e-3/; s/force("angle", 0)/move("angle", 0)/; s/^rcRun(/rcQuiet = true;\n&/; s/dtmax=0.05/dtmax=0.5/'
echo 'rcSummaryWrite(C, M, S, "quiet.json");' >>"$SCRATCH/quiet.edp"
(cd "$SCRATCH" && exec "$BURNISH" quiet.edp >quiet.log 2>&1 </dev/null)
status=$?
judge quiet 0 'burnish: warnings:|tool "roller"'
grep -q '"warnings": \["' "$SCRATCH/quiet.json" || report "quiet: no warnings in the summary"
grep -q '"last_rejection"' "$SCRATCH/quiet.json" && grep -q '"last_dt"' "$SCRATCH/quiet.json" \
  || report "quiet: dt and the last rejection are not in the summary"

echo "$failures failed"
[ "$failures" = 0 ]
