#!/usr/bin/env bash
# Files for ParaView and the movie of a small run: what tests/shell/movie.py says of them; and what -movie refuses.
set -eu
fail() { echo "FAILED: $1"; tail -n 20 "$SCRATCH/log.txt"; exit 1; }
status=0
"$BURNISH" tests/support/press.edp -out "$SCRATCH/run" -movie 1 -pictures 0 >"$SCRATCH/log.txt" 2>&1 || status=$?
[ "$status" = 0 ] || fail "exit status $status"
! grep -q "burnish: warning: no movie" "$SCRATCH/log.txt" || fail "a warning"
"$PYTHON" tests/shell/movie.py "$SCRATCH/run"

status=0
"$BURNISH" tests/support/press.edp -out "$SCRATCH/none" -movie 1 -series 0 >"$SCRATCH/log.txt" 2>&1 || status=$?
[ "$status" = 20 ] || fail "-series 0: exit status $status instead of 20"
grep -q "option -movie 1 needs field files on the way, expected -series >= 1" "$SCRATCH/log.txt" || fail "-series 0: no reason"
