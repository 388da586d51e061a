#!/usr/bin/env bash
# Files of several processes are those of one, written once, whatever the processes divide; so is what stands on the screen. A
# checkpoint of 2 processes goes on with 1 and with 3, to the same files.
. tests/support/mpi.sh
left_out='summary.json|.*checkpoint.*|.*\.png|own.txt'
files() { (cd "$1" && find . -type f | grep -vE "$left_out" | sort | xargs cksum); }
compare() { # WHAT FOLDER
  [ "$(files "$SCRATCH/one")" = "$(files "$2")" ] || { report "$1: other files than of one process"; diff <(files "$SCRATCH/one") <(files "$2"); }
}

"$BURNISH" "${plane[@]}" -out "$SCRATCH/one" >"$SCRATCH/one.log" 2>&1 || report "one process: status $?"
"$BURNISH" -np 2 "${plane[@]}" -out "$SCRATCH/two" >"$SCRATCH/two.log" 2>&1 || report "two processes: status $?"
compare "two processes" "$SCRATCH/two"
[ "$(cat "$SCRATCH/two/own.txt")" = once ] || report "a file of the script: $(cat "$SCRATCH/two/own.txt")"
screen() { sed -E 's/[0-9.]+ s$//; /files in/d' "$1"; }
diff <(screen "$SCRATCH/one.log") <(screen "$SCRATCH/two.log") || report "the screen of two processes is not that of one"

# killed in the middle, with a checkpoint after every step
resumed() { # PROCESSES
  local folder="$SCRATCH/from-2-with-$1"
  "$BURNISH" -np 2 "${plane[@]}" -fail 3 -out "$folder" -checkpoint 1e-9 >"$folder.log" 2>&1 &
  local run=$!
  for _ in $(seq 200); do [ -s "$folder/run-1.checkpoint.old" ] && break; sleep 0.1; done
  kill -KILL $run
  wait $run 2>/dev/null
  for _ in $(seq 50); do pgrep -f -- "-out $folder -" >/dev/null || break; sleep 0.1; done
  ! pgrep -f -- "-out $folder -" >/dev/null || report "processes of a killed run are still there"
  local several=()
  [ "$1" = 1 ] || several=(-np "$1")
  "$BURNISH" "${several[@]}" "${plane[@]}" -fail 3 -out "$folder" -checkpoint 1e-9 -resume 1 >>"$folder.log" 2>&1 || report "resumed by $1: status $?"
  grep -q "burnish: goes on from" "$folder.log" || report "resumed by $1: does not go on: $(tail -3 "$folder.log")"
  compare "a checkpoint of 2 processes resumed by $1" "$folder"
}
resumed 1
resumed 3
exit $((failures > 0))
