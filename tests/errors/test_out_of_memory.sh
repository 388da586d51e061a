#!/usr/bin/env bash
# Memory that runs out in the plugin is an error, exit status 20, and no crash: FreeFem++'s own operator new returns null then,
# plugins/operator_new.cpp.
set -u
run() { "$BURNISH" tests/support/out-of-memory.edp; }
number() { awk -v word="$1" '$1 == word { print int($2) }' "$SCRATCH/all.log"; }
run >"$SCRATCH/all.log" 2>&1 || { echo "FAILED: without a limit"; tail -n 5 "$SCRATCH/all.log"; exit 1; }
before=$(number before) after=$(number after)
[ "$before" -gt 0 ] && [ $((after - before)) -gt 20000 ] || { echo "FAILED: $before kB before, $after kB after"; exit 1; }
[ "$before" -lt 1000000000 ] || { echo "skipped: a sanitizer needs terabytes of addresses"; exit 0; }
failures=0
for tenths in 1 3 5 7; do
  (ulimit -c 0; ulimit -v $((before + (after - before) * tenths / 10)); run) >"$SCRATCH/$tenths.log" 2>&1
  status=$?
  [ $status = 20 ] && grep -q "out of memory: this process can have" "$SCRATCH/$tenths.log" && continue
  echo "FAILED: with $tenths tenths of what it needs: exit status $status"
  tail -n 5 "$SCRATCH/$tenths.log"
  failures=$((failures + 1))
done
exit $((failures > 0))
