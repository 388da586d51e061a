#!/usr/bin/env bash
# Every picture that a page shows is made by make figures or another target (figures.py); wrong pages are found. A case without a run says what
# makes one.
set -u
wrong=0
fail() { echo "FAILED: $1"; wrong=1; }
"$PYTHON" tests/shell/figures.py || fail "pictures of the pages"
mkdir "$SCRATCH/pages"
cp cases/hertz/cost.png "$SCRATCH/pages/own.png"
printf '![a](own.png) ![b](nothing.png)\n' >"$SCRATCH/pages/page.md"
"$PYTHON" tests/shell/figures.py "$SCRATCH/pages" >"$SCRATCH/wrong.txt" && fail "wrong pages pass"
for text in "own.png is made by no line" "nothing.png is not there"; do
  grep -q "$text" "$SCRATCH/wrong.txt" || fail "not found: $text"
done
make -s PACKAGES=true CASE=never-run figures >"$SCRATCH/wrong.txt" 2>&1 && fail "pictures of no run"
grep -q "out/never-run: no run to draw; make case-never-run makes it" "$SCRATCH/wrong.txt" || fail "what makes the run is not said"
exit $wrong
