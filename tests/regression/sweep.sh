#!/usr/bin/env bash
# make sweep's script on a coarse rolling case: grid, folders, table, picture; finished variants are not run again; a failed one
# is listed, makes the exit status 1 and is run again; what cannot be run is refused before anything runs.
set -u
picture=$PWD/tests/support/picture.py
page=$PWD/tests/regression/explore.py
work=$SCRATCH/top # links to the cases, so that out/ is our own
mkdir -p "$work" && ln -s "$PWD/cases" "$work" && cd "$work" || exit 1
coarse="-inner 3 -outer 16 -sides 3 -steps 4 -width 2 -tolerance 1e-3"
export CASE=rolling JOBS=2 VARY RESULT= SSH= OPTIONS=$coarse
top=out/sweep/rolling failures=0
fail() { echo "FAILED: $1"; sed 's/^/  | /' log; failures=$((failures + 1)); }
# sweep STATUS NAME VARY: runs it; output in the file log
sweep() { local s; VARY=$3; bash cases/sweep/sweep.sh >log 2>&1; s=$?; [ "$s" = "$1" ] || fail "$2: exit status $s instead of $1"; }
holds() { grep -qF -- "$2" "${3:-log}" || fail "$1: ${3:-the output} lacks '$2'"; }
ran() { local n; n=$(($(wc -l <$top/joblog.txt) - 1)); [ "$n" = "$2" ] || fail "$1: $n variants ran instead of $2"; }
lines() { local n; n=$(wc -l <$top/sweep.csv); [ "$n" = "$2" ] || fail "$1: sweep.csv has $n lines instead of $2"; }
# refused NAME VARY WORDS
refused() { sweep 2 "$1" "$2"; holds "$1" "$3"; }

# 1. Two by two
sweep 0 grid "R=14e-3:16e-3:2 mu=0.25,0.3"
holds grid "rolling: 4 variants"
holds grid "$top/sweep.png"
ran grid 4
lines grid 5
holds grid "R,mu,status,t,r,Q_r,phi,Q_phi,theta,Q_theta," $top/sweep.csv
holds grid ",depth,rotation," $top/sweep.csv
"${PYTHON:-python3}" "$picture" $top/sweep.png >>log || fail "grid: the picture"
[ -s "$top/R=0.016,mu=0.3/log.txt" ] || fail "grid: no log of a variant"
grep -q "^0.016,0.3,finished,1.0," $top/sweep.csv || fail "grid: the row of a variant"

# 2. Two more, one of which fails: the four are not run again
cp "$top/R=0.014,mu=0.3/summary.json" before.json
sweep 1 more "R=14e-3,16e-3,-1 mu=0.25,0.3"
holds more "2 of 6 variants failed"
holds more "R=-1,mu=0.3: exit code 20: burnish: option -R is -1, expected > 0"
lines more 7
ran more 2
holds more "rolling: 6 variants, 4 finished before"
cmp -s before.json "$top/R=0.014,mu=0.3/summary.json" || fail "more: a finished variant was run again"
"${PYTHON:-python3}" cases/sweep/explore.py >log 2>&1 && "${PYTHON:-python3}" "$page" $top "option -R is -1" >>log 2>&1 || fail "explore: its page"

# 3. The same again: only the failed ones run; a word that is varied; other options or another script: all run
sweep 1 again "R=14e-3,16e-3,-1 mu=0.25,0.3"
ran again 2
OPTIONS="$coarse -M0 1500" sweep 0 options "mu=0.25,0.3"
OPTIONS="$coarse -M0 1600" sweep 0 options "mu=0.25,0.3"
holds options "rolling: 2 variants"
ran options 2
RESULT="depth,Q_phi" sweep 0 words "element=P1,P2"
holds words "P2,finished" $top/sweep.csv
RESULT="depht" sweep 1 result "element=P1,P2"
holds result "RESULT: no quantity depht; there are: r, Q_r,"

# 4. Equal ratios; a Latin hypercube: one value in each third; a script of one's own; histories and the table
sweep 0 log "M0=1000:2000:3:log"
holds log "1414.21,finished" $top/sweep.csv
[ -s $top/histories.png ] && [ ! -e $top/cost.png ] || fail "log: histories.png, and no cost.png of a moment"
grep -q '<a href="M0=1414.21/log.txt">' $top/index.html || fail "log: index.html"
mkdir -p own && cp cases/rolling/rolling.edp own/press.edp
CASE=own/press.edp SAMPLES=3 sweep 0 latin "mu=0.2:0.5:latin R=14e-3:16e-3:random"
awk -F, 'NR > 1 && $3 == "finished" && $2 > 0.014 && $2 < 0.016 {n[int(10*$1)]++} END {exit !(n[2] == 1 && n[3] == 1 && n[4] == 1)}' \
  out/sweep/press/sweep.csv || { cut -d, -f1-3 out/sweep/press/sweep.csv; fail "latin: values"; }

# 5. The radius for a depth: within 0.1 %, and out of reach
TARGET="depth=85" BY=R=14e-3:20e-3 sweep 0 target ""
awk -F, 'NR > 1 && $2 > 84.915 && $2 < 85.085 {found = 1} END {exit !found}' $top/target.csv || fail "target: no run within 0.1 %"
"${PYTHON:-python3}" "$picture" $top/target.png >>log || fail "target: the picture"
TARGET="depth=120" BY=R=14e-3:20e-3 sweep 1 far ""
holds far "depth = 120 is not between "
TARGET="depht=85" BY=R=14e-3:20e-3 sweep 2 name ""
holds name 'no result "depht"; there are: t, r,'
TARGET="depth" BY=R sweep 2 form ""
holds form '"depth" is not name=value'

# 6. Refused before anything runs
rm -f $top/joblog.txt
refused unknown "Rad=1,2" "burnish: unknown option -Rad, expected one of"
refused word "element=P3,P1" 'option -element is "P3", expected P1 or P2'
refused equals "R" '"R" is not name=values'
refused parts "R=1:2" '"1:2" has 2 parts, expected first:last:number'
refused number "R=1:x:3" '"x" is not a number'
refused count "R=1:2:1" "expected a whole number from 2 to 10000"
refused value "R=1,,2" '"" is not a value'
refused twice "R=1e-2,0.01" "R has a value twice"
refused again "R=1,2 R=3" "R is given twice"
refused out "out=a,b" "out cannot be varied"
refused empty "" "VARY is empty"
OPTIONS="-R 1" refused fixed "R=1,2" "-R is varied by VARY"
CASE=nothing refused case "R=1,2" 'no case "nothing"; there are:'
refused ratio "R=-1:2:3:log" "-1 and 2 with log, expected two numbers of one sign"
refused range "R=2:1:latin" "2 to 1, expected an ascending range"
echo 'cout << 1;' >own/plain.edp
CASE=own/plain.edp refused script "R=1,2" "own/plain.edp has no rcCaseEnd"
[ ! -e $top/joblog.txt ] || fail "refused: something ran"

echo "$failures failed"
[ "$failures" = 0 ]
