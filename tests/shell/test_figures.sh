#!/usr/bin/env bash
# Every picture that a page shows is made by make figures or another target (figures.py); wrong pages are found.
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
exit $wrong
