#!/usr/bin/env bash
# However one process ends, all end, with a reason and a status: an error on all, on one alone, a killed process, Ctrl-C, a wrong -np.
. tests/support/mpi.sh
run() { timeout 60 "$BURNISH" "$@" >"$SCRATCH/log" 2>&1; }
ended() { # STATUS "words" WHAT
  local status=$?
  [ "$status" = "$1" ] || report "$3: exit status $status instead of $1"
  grep -qF -- "$2" "$SCRATCH/log" || { report "$3: no \"$2\""; tail -n 4 "$SCRATCH/log"; }
}
run -np 2 "${plane[@]}" -fail 2 -out "$SCRATCH/all"; ended 20 'all have had enough' "an error on all"
[ "$(grep -c 'all have had enough' "$SCRATCH/log")" = "$("$BURNISH" "${plane[@]}" -fail 2 -out "$SCRATCH/alone" 2>&1 | grep -c 'all have had enough')" ] ||
  report "an error on all is not said once"
[ -s "$SCRATCH/all/final.vtu" ] || report "an error on all: what there is was not written"
run -np 2 "${plane[@]}" -fail 1 -out "$SCRATCH/one"; ended 20 'process 1 has had enough' "an error on one process"
run -np 2 "${plane[@]}" -nonsense 1; ended 20 'nonsense' "an option that there is not"
run -np two "${plane[@]}"; ended 20 'burnish: -np = "two", expected' "-np two"

# a process that is killed; Ctrl-C
begin() {
  "$BURNISH" -np 2 "${plane[@]}" -fail 3 -out "$SCRATCH/$1" >"$SCRATCH/log" 2>&1 &
  run=$!
  for _ in $(seq 200); do [ "$(wc -l 2>/dev/null <"$SCRATCH/$1/history.csv")" -gt 2 ] 2>/dev/null && break; sleep 0.1; done
}
begin killed
kill -KILL "$(pgrep -f "^FreeFem\+\+-mpi.*-out $SCRATCH/killed" | tail -n 1)"
wait $run; ended 137 'was killed by signal 9; all are ended' "a killed process"
begin interrupted
kill -INT $run 2>/dev/null; kill -TERM $run
wait $run; ended 130 'interrupted at t = ' "an interrupted run"
[ -s "$SCRATCH/interrupted/final.vtu" ] || report "an interrupted run: what there is was not written"
! pgrep -f -- "-out $SCRATCH/" >/dev/null || report "processes are still there"
exit $((failures > 0))
