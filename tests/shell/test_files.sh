#!/usr/bin/env bash
# Files are whole or not there, however a run ends: a full disk (exit status 5), kill -9, SIGHUP, exit(n) of the script;
# nothing stays in the temporary folder, no link is followed, no name is run as a command.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
small=(cases/rolling/rolling.edp -element P1 -inner 4 -outer 40 -sides 6 -pictures 0)
# finish NAME CODE "words"
finish() {
  [ "$status" = "$2" ] || { report "$1: exit status $status instead of $2"; tail -n 5 "$SCRATCH/$1.log"; }
  [ -z "$3" ] || grep -qF -- "$3" "$SCRATCH/$1.log" || { report "$1: the output lacks \"$3\""; tail -n 5 "$SCRATCH/$1.log"; }
}
# whole FOLDER: every line, every field file and every list in it
whole() {
  "${PYTHON:-/usr/bin/python3}" - "$1" <<'END' || report "$1: not whole"
import glob, json, os, re, sys, xml.dom.minidom
folder = sys.argv[1]
hidden = [n for n in os.listdir(folder) if n.startswith(".")]
assert not hidden, hidden
for name in glob.glob(folder + "/*.csv"):
    text = open(name).read()
    assert text.endswith("\n"), name
    columns = {line.count(",") for line in text.splitlines()}
    assert len(columns) == 1, (name, columns)
for name in glob.glob(folder + "/*.vtu"):
    assert open(name, "rb").read().rstrip().endswith(b"</VTKFile>"), name
for name in glob.glob(folder + "/*.pvd"):
    xml.dom.minidom.parse(name)
    for file in re.findall('file="([^"]*)"', open(name).read()):
        assert os.path.exists(folder + "/" + file), file
for name in glob.glob(folder + "/*.json"):
    json.load(open(name))
END
}
# started NAME LINES: waits until the history has that many lines
started() {
  for _ in {1..400}; do
    [ "$(cat "$SCRATCH/$1/history.csv" 2>/dev/null | wc -l)" -lt "$2" ] || return
    sleep 0.05
  done
}

# 1. the history reaches the largest size that a file may have; the summary does not
(ulimit -f 16 && exec "$BURNISH" "${small[@]}" -steps 400 -series 0 -out "$SCRATCH/full" >"$SCRATCH/full.log" 2>&1)
status=$?
finish full 5 'history.csv" cannot be written on: File too large; its whole lines are kept'
whole "$SCRATCH/full"
[ "$(wc -l <"$SCRATCH/full/history.csv")" -gt 10 ] || report "full: the history was not kept"
grep -q '"status": "error"' "$SCRATCH/full/summary.json" || report "full: no summary"

# 2. a field file that does not fit: none, and the run ends
(ulimit -f 14 && exec "$BURNISH" "${small[@]}" -steps 10 -series 2 -out "$SCRATCH/fields" >"$SCRATCH/fields.log" 2>&1)
status=$?
finish fields 5 '.vtu" cannot be written: File too large'
whole "$SCRATCH/fields"

# 3. the index of the series survives kill -9, SIGHUP is taken as Ctrl-C
for run in KILL:137 HUP:130; do
  name=${run%:*}
  "$BURNISH" "${small[@]}" -steps 2000 -series 500 -out "$SCRATCH/$name" >"$SCRATCH/$name.log" 2>&1 &
  process=$!
  started "$name" 30
  kill -s "$name" "$process"
  wait "$process" 2>/dev/null
  status=$?
  [ "$name" = KILL ] && rm -f "$SCRATCH/$name"/.new.*
  finish "$name" "${run#*:}" ''
  whole "$SCRATCH/$name"
done
grep -q 'interrupted' "$SCRATCH/HUP/summary.json" || report "HUP: no summary"
[ "$(grep -c DataSet "$SCRATCH/KILL/fields.pvd")" -gt 3 ] || report "KILL: no series"

# 4. exit(9) of the script keeps its status
mkdir -p "$SCRATCH/leaves"
sed 's/^func int program(real t) {/& if (t > 0.2) exit(9);/' cases/rolling/rolling.edp >"$SCRATCH/leaves/rolling.edp"
"$BURNISH" "$SCRATCH/leaves/rolling.edp" "${small[@]:1}" -out "$SCRATCH/nine" >"$SCRATCH/nine.log" 2>&1
status=$?
finish nine 9 'error: exit(9) in the script'
whole "$SCRATCH/nine"

# 5. what an earlier run or somebody else left in the folder
mkdir -p "$SCRATCH/linked"
echo precious >"$SCRATCH/precious"
ln -s "$SCRATCH/precious" "$SCRATCH/linked/.writable"
touch "$SCRATCH/linked/.new.final.vtu"
echo 'load "burnish" rcMakeFolder("'"$SCRATCH"'/linked");' >"$SCRATCH/linked.edp"
"$BURNISH" "$SCRATCH/linked.edp" || report "linked: exit status $?"
[ "$(cat "$SCRATCH/precious")" = precious ] || report "a link was followed"
[ ! -e "$SCRATCH/linked/.new.final.vtu" ] || report "an unfinished file stays"
# (where nobody may write, root neither)
echo 'load "burnish" rcMakeFolder("/sys");' >"$SCRATCH/sys.edp"
"$BURNISH" "$SCRATCH/sys.edp" >"$SCRATCH/sys.log" 2>&1
status=$?
finish sys 20 'rcMakeFolder: the output folder "/sys" cannot be written: '
! grep -q 'No such file' "$SCRATCH/sys.log" || report "sys: the reason is another"

# 6. kill -9 while a file is read leaves nothing in the temporary folder
mkdir -p "$SCRATCH/tmp"
echo 'Sleep 1000;' >"$SCRATCH/asleep.geo"
echo 'load "burnish" tool t(cad="'"$SCRATCH"'/asleep.geo");' >"$SCRATCH/asleep.edp"
TMPDIR="$SCRATCH/tmp" "$BURNISH" "$SCRATCH/asleep.edp" >"$SCRATCH/asleep.log" 2>&1 &
process=$!
for _ in {1..200}; do [ -z "$(ls -A "$SCRATCH/tmp")" ] || break; sleep 0.05; done
[ -n "$(ls -A "$SCRATCH/tmp")" ] || report "no temporary folder was made"
kill -s KILL "$process"
wait "$process" 2>/dev/null
for _ in {1..100}; do [ -n "$(ls -A "$SCRATCH/tmp")" ] || break; sleep 0.05; done
[ -z "$(ls -A "$SCRATCH/tmp")" ] || report "left behind: $(ls -A "$SCRATCH/tmp")"

# 7. names are no commands
odd="$SCRATCH/\$(touch $SCRATCH/PWNED); \`touch $SCRATCH/PWNED\`"
cat >"$SCRATCH/odd.edp" <<'END'
include "burnish.idp"
string folder = rcText("-out", "");
rcMakeFolder(folder);
mesh Th = rcGmsh("cases/step-die/block.geo", "W=9", folder + "/block");
rcPictures(folder);
try { Th = rcGmsh("cases/step-die/block.geo", "W$(touch PWNED)=12", folder + "/b"); } catch(...) { cout << "refused" << endl; }
try { Th = rcGmsh("cases/step-die/block.geo", "W;touch${IFS}PWNED=12", folder + "/b"); } catch(...) { cout << "refused" << endl; }
END
"$BURNISH" "$SCRATCH/odd.edp" -out "$odd" >"$SCRATCH/odd.log" 2>&1 || report "odd: exit status $?"
[ -e "$odd/block.msh" ] && [ "$(grep -c '^refused' "$SCRATCH/odd.log")" = 2 ] || { report odd; tail "$SCRATCH/odd.log"; }
[ ! -e "$SCRATCH/PWNED" ] && [ ! -e PWNED ] || report "a name was run as a command"

# 8. a .geo file writes no file and starts no program, not by a name that is put together either
printf 'Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Line(1) = {1, 2};\n' >"$SCRATCH/line.geo"
number=0
while IFS= read -r command; do
  number=$((number + 1))
  { cat "$SCRATCH/line.geo"; echo "$command"; } >"$SCRATCH/evil$number.geo"
  echo 'load "burnish" tool t(cad="'"$SCRATCH/evil$number.geo"'");' >"$SCRATCH/evil.edp"
  "$BURNISH" "$SCRATCH/evil.edp" >"$SCRATCH/evil$number.log" 2>&1
  status=$?
  [ "$number" -gt 3 ] || finish "evil$number" 20 "evil$number.geo\", line 2: "
  [ ! -e "$SCRATCH/PWNED" ] || { report "evil: $command was run"; rm -f "$SCRATCH/PWNED"; }
done <<END
Printf("written") > "$SCRATCH/PWNED";
Save "$SCRATCH/PWNED";
SystemCall "touch $SCRATCH/PWNED";
If (1) SystemCall "touch $SCRATCH/PWNED"; EndIf
a = "touch $SCRATCH/PWNED"; For i In {1:2} SystemCall a; EndFor
END

echo "$failures failed"
[ "$failures" = 0 ]
