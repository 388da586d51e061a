#!/usr/bin/env bash
# make install: the wrapper and plain FreeFem++ with the lines printed run a script from any folder, without the tree;
# make uninstall leaves nothing.
set -eu
wrong=0
fail() { echo "FAILED: $1"; wrong=1; }
make -s PACKAGES=true BUILD="$BUILD" PREFIX="$SCRATCH/usr" install >"$SCRATCH/install.txt"
grep -q 'includepath += "'"$SCRATCH/usr/share/burnish/edp"'"' "$SCRATCH/install.txt" || fail "the lines for FreeFem++ are not printed"
! grep -rl -e "$PWD/edp" -e "$BUILD/plugins" -e "$PWD/cases" "$SCRATCH/usr/bin" "$SCRATCH/usr/share/burnish/freefem++.pref" || fail "paths of the tree in what is installed"
mkdir -p "$SCRATCH/away" "$SCRATCH/home"
awk '/^```freefem/ {inside = 1; next} /^```/ {if (inside) exit} inside' README.md | sed 's/square(60, 20,/square(20, 7,/' >"$SCRATCH/away/own.edp"
cd "$SCRATCH/away"
env -u BURNISH -u BURNISH_TOP "$SCRATCH/usr/bin/burnish" own.edp >run.txt 2>&1 || { fail "the wrapper: exit status $?"; tail -n 5 run.txt; }
grep -q "^t 1 " run.txt || fail "the run has not reached its end"
env -u BURNISH -u BURNISH_TOP "$SCRATCH/usr/bin/burnish" help contact.add >help.txt && grep -q frictionlaw= help.txt || fail "burnish help"
# an own scene, two variants that finish, one that says why not
env -u BURNISH -u BURNISH_TOP "$SCRATCH/usr/bin/burnish" new press >new.txt
env -u BURNISH -u BURNISH_TOP "$SCRATCH/usr/bin/burnish" sweep press/press.edp R=8,12,-1 -fine 1 -steps 3 >sweep.txt 2>&1 || { fail "burnish sweep: exit status $?"; tail -n 5 sweep.txt; }
grep -q "R=-1: exit code 20: option -R is -1, expected > 0" sweep.txt && [ "$(cat out/sweep/press/*/exit.txt | sort -n | xargs)" = "0 0 20" ] || { fail "burnish sweep: its variants"; cat sweep.txt; }
[ "$(grep -o 'data:image/png;base64,' out/sweep/press/index.html | wc -l)" = 2 ] || fail "burnish sweep: pictures of its page"
cp "$SCRATCH/usr/share/burnish/freefem++.pref" "$SCRATCH/home/.freefem++.pref"
env -u FF_LOADPATH -u FF_INCLUDEPATH -u BURNISH_TOP HOME="$SCRATCH/home" ${FREEFEM:-FreeFem++} -nw -v 0 own.edp >plain.txt 2>&1 || { fail "FreeFem++: exit status $?"; tail -n 5 plain.txt; }
printf 'load "burnish"\nrcPicture("none");\n' >picture.edp
env -u FF_LOADPATH -u FF_INCLUDEPATH -u BURNISH_TOP HOME="$SCRATCH/home" ${FREEFEM:-FreeFem++} -nw -v 0 picture.edp >picture.txt 2>&1 || true
grep -q "open file.*scene.py" picture.txt && fail "plain FreeFem++ does not find what draws"
grep -q "could not be drawn" picture.txt || { fail "plain FreeFem++ draws nothing, and says nothing"; cat picture.txt; }
cmp -s <(grep "^t " run.txt) <(grep "^t " plain.txt) || fail "plain FreeFem++ gives other numbers"
cd - >/dev/null
make -s PACKAGES=true BUILD="$BUILD" PREFIX="$SCRATCH/usr" uninstall >/dev/null
[ -z "$(find "$SCRATCH/usr" -type f)" ] || { fail "files left after uninstall"; find "$SCRATCH/usr" -type f; }
exit $wrong
