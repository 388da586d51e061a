#!/usr/bin/env bash
# The manual's scripts are those that run, its commands exist (manual.py); its examples run, coarse; burnish new makes a scene
# that runs and overwrites nothing. Wrong pages are found.
set -u
wrong=0
fail() { echo "FAILED: $1"; wrong=1; }
top=$PWD
(cd "$SCRATCH" && "$BURNISH" new press >new.txt) || fail "burnish new: exit status $?"
(cd "$SCRATCH" && "$BURNISH" new press >again.txt 2>&1)
[ $? = 20 ] && grep -q "exists already" "$SCRATCH/again.txt" || fail "burnish new overwrites what exists"
(cd "$SCRATCH" && "$BURNISH" new "a b" >/dev/null 2>&1)
[ $? = 20 ] || fail "burnish new takes a name with a space"
"$PYTHON" tests/shell/manual.py || fail "the manual's code"

# examples that a page's command runs are test_snippets.sh's
for script in $("$PYTHON" tests/shell/manual.py --scripts); do
  grep -q "^build/burnish $script" edp/manual/*.md && continue
  name=$(basename "$script" .edp)
  "$BURNISH" "$script" >"$SCRATCH/$name.txt" 2>&1 || { fail "$script: exit status $?"; tail -n 3 "$SCRATCH/$name.txt"; }
done
(cd "$SCRATCH" && "$BURNISH" press/press.edp -steps 5 -fine 1 -pictures 0 >press.txt 2>&1) || { fail "press.edp: exit status $?"; tail -n 3 "$SCRATCH/press.txt"; }
[ -s "$SCRATCH/press/out/history.csv" ] || fail "press.edp writes no files in its folder"

mkdir "$SCRATCH/pages"
printf '<!-- from edp/manual/examples/block.edp -->\n```freefem\nmesh Th = nothing;\n```\n```freefem\nreal a;\n```\n```sh\nmake nothing\nbuild/burnish edp/manual/examples/block.edp -nothing 3\n```\n' >"$SCRATCH/pages/wrong.md"
"$PYTHON" tests/shell/manual.py "$SCRATCH/pages" >"$SCRATCH/wrong.txt" && fail "wrong pages pass"
for text in "does not have these lines: mesh Th = nothing" "does not say which script it is from: real a" "no target nothing" "has no option -nothing"; do
  grep -q -- "$text" "$SCRATCH/wrong.txt" || fail "not found: $text"
done
exit $wrong
