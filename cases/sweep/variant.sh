#!/usr/bin/env bash
# One variant of a study:  variant.sh FOLDER BURNISH SCRIPT OPTIONS...
# Leaves in FOLDER log.txt and, once the run has ended by itself, exit.txt with its exit code, beside the files of the run. A run that
# was killed together with its sweep has no exit.txt; it goes on from its last checkpoint, if it has written one.
folder=$1
shift
mkdir -p "$folder" && rm -f "$folder"/summary.json "$folder"/exit.txt || exit 1
trap 'kill -KILL $run; exit 143' TERM
OPENBLAS_NUM_THREADS=1 "$@" -out "$folder" >"$folder/log.txt" 2>&1 </dev/null &
run=$!
wait $run
code=$?
echo "$code" >"$folder/exit.txt"
exit "$code"
