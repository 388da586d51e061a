#!/usr/bin/env bash
# Causes that the map of dangers counts as named are names and words of the program; wrong ones are found. What draws the chart loads.
set -u
wrong=0
fail() { echo "FAILED: $1"; wrong=1; }
"$PYTHON" tests/stability/run.py --names || fail "names of dangers.csv and causes.csv"
(cd tests/chart && "$PYTHON" -c "import draw, matrix_pictures") || fail "what draws the chart"
cp -r cxx plugins "$SCRATCH/"
mkdir "$SCRATCH/tests"
cp -r tests/stability cases "$SCRATCH/tests/"
mv "$SCRATCH/tests/cases" "$SCRATCH/"
sed -i 's/; locking;/; lokking;/' "$SCRATCH/tests/stability/dangers.csv"
sed -i 's/so large that it wedges/so large that it sticks/' "$SCRATCH/tests/stability/causes.csv"
"$PYTHON" "$SCRATCH/tests/stability/run.py" --names 2>"$SCRATCH/wrong.txt" && fail "wrong names pass"
for text in 'no check is named "lokking"' 'does not say "is so large that it sticks"'; do
  grep -q "$text" "$SCRATCH/wrong.txt" || fail "not found: $text"
done
exit $wrong
