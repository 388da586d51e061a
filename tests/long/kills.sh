#!/usr/bin/env bash
# Fifty kills at random instants, writes among them, over all ways to run: every resumed run ends with the same bytes in every file as one
# that was left alone. So does one whose system clock is set back. A full disk and a folder that is gone end no run; the checkpoint before stays whole.
set -u
failures=0
kills() { "$PYTHON" -B tests/support/kills.py "$@" || failures=$((failures + 1)); }
rolling=(cases/rolling/rolling.edp -inner 4 -outer 40 -sides 6 -check 0)
kills implicit 7 "${rolling[@]}" -steps 60 -series 5
kills event 7 "${rolling[@]}" -steps 20 -width 3 -scheme event -series 3
kills factors 4 "${rolling[@]}" -steps 60 -series 2 -stepsperfactor 3
kills article 3 "${rolling[@]}" -element P1 -steps 20 -width 2 -scheme article -series 2
kills forms 6 "${rolling[@]}" -element P1 -steps 20 -width 3 -forms 1 -solver UMFPACK -series 2
kills event-forms 4 "${rolling[@]}" -element P1 -steps 10 -width 2 -forms 1 -solver UMFPACK -scheme event -series 2
kills axisymmetric 5 cases/upsetting/upsetting.edp -axisymmetric 1 -n 8 -check 0 -steps 30
kills tools 5 cases/planetary/planetary.edp -check 0 -series 3 -fine 200e-6
kills damage 5 cases/damage/damage.edp -check 0 -n 4 -steps 60 -series 3
kills space 4 cases/ball/ball.edp -check 0 -series 2 -n 3
"$PYTHON" -B tests/support/clock_back.py clock-back "${rolling[@]}" -steps 60 -series 5 || failures=$((failures + 1))

# a disk that is full: no file may exceed a limit that the history keeps and the checkpoint does not
folder="$SCRATCH/full"
(ulimit -f 40; "$BURNISH" "${rolling[@]}" -steps 30 -series 0 -pictures 0 -out "$folder" -checkpoint 1e-9) >"$SCRATCH/full.log" 2>&1
grep -q 'burnish: checkpoint .* cannot be written: File too large; the run goes on' "$SCRATCH/full.log" || { echo "FAILED: full disk"; tail -n 3 "$SCRATCH/full.log"; failures=$((failures + 1)); }
[ ! -e "$folder/run-1.checkpoint" ] || { echo "FAILED: a part of a checkpoint is there"; failures=$((failures + 1)); }
exit $((failures > 0))
