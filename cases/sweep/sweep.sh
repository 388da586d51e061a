#!/usr/bin/env bash
# Runs a case for every combination of some of its options, in parallel:
#   make sweep CASE=rolling VARY="R=14e-3:20e-3:4 mu=0.2,0.3" [OPTIONS="-outer 80"] [RESULT="depth,Q_phi"] [JOBS=4]
#   make sweep CASE=rolling TARGET="depth=85" BY=R=14e-3:20e-3 [TOLERANCE=1e-3]     the option for a result: target.py
#     CASE     name of a case, or path of a script of one's own that reads its options as cases do
#     VARY     name=first:last:number (equally spaced), name=first:last:number:log, name=value,value,... (numbers or words),
#              name=first:last:random or name=first:last:latin (SAMPLES=20 points, SEED=1) for each option: values.py
#     OPTIONS  options of all variants;  RESULT: names in "results" or "final" of summary.json to draw
#     JOBS     runs at a time, default one for each core
#     EXPLORE  1, as make explore sets it: every variant draws its pictures, and explore.html shows them beside sliders
#     SSH      other machines, "host1,host2" (":" is this one): ssh without a password, GNU parallel here, and there the same
#              folder under the same path (a network folder) with the same system, so that build/ runs
# Each variant has its folder out/sweep/CASE/R=0.01,mu=0.1/ with log.txt. Variants that finished with the same options and the
# same script are not run again; the others are. At the end sweep.csv, sweep.png, histories.png and index.html; exit status 1
# if a variant failed.
set -u
cd "$(dirname "$0")/../.." || exit 1
: "${EXPLORE:=}" "${CASE:=rolling}" "${BURNISH:=build/burnish}" "${PYTHON:=/usr/bin/python3}" "${JOBS:=$(nproc)}" "${SSH:=}"
case " ${OPTIONS-} " in *" -pictures "*) ;; *) [ -z "$EXPLORE" ] || OPTIONS="-pictures 2 ${OPTIONS-}" ;; esac
export CASE BURNISH PYTHON VARY="${VARY-}" OPTIONS="${OPTIONS-}" RESULT="${RESULT-}" TARGET="${TARGET-}"
top=out/sweep/$(basename "$CASE" .edp)

if [ -n "$TARGET" ]; then exec "$PYTHON" cases/sweep/target.py; fi
"$PYTHON" cases/sweep/grid.py || exit
if [ -s "$top/commands.txt" ]; then
  run=(parallel --will-cite --joblog "$top/joblog.txt")
  [ ! -t 2 ] || run+=(--bar)
  if [ -n "$SSH" ]; then run+=(--sshlogin "$SSH" --workdir "$PWD"); fi
  if [ -z "$SSH" ] || [ "$JOBS" != "$(nproc)" ]; then run+=(--jobs "$JOBS"); fi
  "${run[@]}" <"$top/commands.txt"
  status=$? # up to 100: the number of failed jobs; 101: more; above: parallel itself, or a signal
  if [ "$status" -gt 101 ]; then
    echo "sweep: stopped (GNU parallel: exit status $status); the same command runs the rest" >&2
    exit "$status"
  fi
fi
"$PYTHON" cases/sweep/gather.py
status=$?
"$PYTHON" cases/sweep/plot.py || status=1
if [ -n "$EXPLORE" ]; then "$PYTHON" cases/sweep/explore.py || status=1; fi
exit "$status"
