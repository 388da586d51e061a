#!/usr/bin/env bash
# The commands that the manual prints run (snippets.py); those that take long in make test-manual. A block without a mark and a command that
# fails are found.
set -u
wrong=0
"$PYTHON" tests/shell/snippets.py quick || wrong=1
mkdir "$SCRATCH/wrong"
printf '```sh\nmake help\n```\n<!-- run -->\n```sh\nbuild/burnish nothing.edp\n```\n<!-- run with: -a -->\n```sh\nbuild/burnish help rcRun\n```\n' >"$SCRATCH/wrong/page.md"
SCRATCH=$SCRATCH/wrong "$PYTHON" tests/shell/snippets.py quick "$SCRATCH/wrong/page.md" >"$SCRATCH/wrong.txt" && { echo "FAILED: wrong pages pass"; wrong=1; }
for text in "no test is named for the block: make help" "exit status 20: build/burnish nothing.edp" "^2 wrong"; do
  grep -q "$text" "$SCRATCH/wrong.txt" || { echo "FAILED: not found: $text"; wrong=1; }
done
exit $wrong
