#!/usr/bin/env bash
# One variant of a sweep:  variant.sh FOLDER REQUEST BURNISH SCRIPT OPTIONS...
# Leaves in FOLDER log.txt, request.txt (what was asked for) and exit.txt (exit code) beside the case's files.
folder=$1 request=$2
shift 2
mkdir -p "$folder" && rm -f "$folder"/summary.json "$folder"/exit.txt || exit 1
printf '%s\n' "$request" >"$folder/request.txt"
OPENBLAS_NUM_THREADS=1 "$@" -out "$folder" >"$folder/log.txt" 2>&1 </dev/null
code=$?
echo "$code" >"$folder/exit.txt"
exit "$code"
