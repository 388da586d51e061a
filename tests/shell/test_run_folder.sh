#!/usr/bin/env bash
# The folder of a run is its own: another run into it is refused while it lasts, by whatever path, and not by one that was killed; an older
# run's results go when a run begins, the script's and the user's own files stay; until its end summary.json says "running".
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
folder="$SCRATCH/run"
run=("$BURNISH" cases/rolling/rolling.edp -element P1 -inner 4 -outer 40 -sides 6 -width 3 -check 0 -pictures 0)
there() { # how many of the files are there
  local number=0 name
  for name in "$@"; do [ ! -e "$folder/$name" ] || number=$((number + 1)); done
  echo "$number"
}
older=(final.vtu report.txt surface.csv fields-3.vtu tools-3.vtp surface-3.vtp movie.html drawn.png model.csv)

# 1. an older run, with pictures and a movie; files that are not of a run
"${run[@]}" -out "$folder" -steps 20 -series 3 >"$SCRATCH/older.log" 2>&1 || { report "older: exit status $?"; tail -n 5 "$SCRATCH/older.log"; }
PYTHONPATH=cases "$PYTHON" -B -c "
from matplotlib import pyplot as plt
from plotting.figure import new_figure, save
save(new_figure()[0], '$folder', 'drawn')
plt.figure().savefig('$folder/own.png')"
touch "$folder/movie.html" "$folder/model.csv" "$folder/notes.txt" "$folder/fields-a.vtu"
mkdir "$folder/fields-98765.vtu"
own=(own.png notes.txt fields-a.vtu fields-98765.vtu)
[ "$(there "${older[@]}")" = 9 ] || report "older: $(ls "$folder")"
grep -q '"status": "finished' "$folder/summary.json" || report "older: no summary"

# 2. a run begins there, and another one while it lasts
"${run[@]}" -out "$folder" -steps 5000 -series 100000 -R 14.5e-3 >"$SCRATCH/first.log" 2>&1 &
process=$!
for _ in {1..400}; do
  grep -q '"status": "running"' "$folder/summary.json" && [ "$(cat "$folder/history.csv" 2>/dev/null | wc -l)" -ge 12 ] && break
  sleep 0.05
done
for name in final.vtu report.txt surface.csv movie.html drawn.png model.csv; do
  [ ! -e "$folder/$name" ] || report "$name of an older run stays"
done
[ "$(there "${own[@]}")" = 4 ] || report "own files are gone: $(ls "$folder")"
ln -s run "$SCRATCH/link"
for path in "$folder" "$SCRATCH/link" "$SCRATCH/../$(basename "$SCRATCH")/run"; do
  "${run[@]}" -out "$path" -steps 20 -R 16e-3 >"$SCRATCH/second.log" 2>&1
  status=$?
  [ "$status" = 20 ] || report "second run: exit status $status instead of 20"
  grep -qF "rcMakeFolder: the output folder \"$path\" is in use: another run writes to it" "$SCRATCH/second.log" ||
    { report "second run: not told"; tail -n 3 "$SCRATCH/second.log"; }
done

# 3. killed: nothing but its own, and it says so
kill -s KILL "$process" || report "the first run has ended: $(tail -n 5 "$SCRATCH/first.log")"
wait "$process" 2>/dev/null
for name in final.vtu report.txt surface.csv; do [ ! -e "$folder/$name" ] || report "$name of a run that was killed"; done
"$PYTHON" - "$folder" <<'END' || report "a run that was killed"
import json, sys
summary = json.load(open(sys.argv[1] + "/summary.json"))
assert (summary["status"], summary["reason"]) == ("running", ""), summary
assert summary["options"]["R"] == 14.5e-3 and summary["versions"]["burnish"], summary
t = [float(line.split(",")[0]) for line in open(sys.argv[1] + "/history.csv").read().splitlines()[1:-1]]
assert len(t) > 8 and t == sorted(t), t
END

# 4. which hinders no other one
"${run[@]}" -out "$folder" -steps 20 -series 0 >"$SCRATCH/third.log" 2>&1 || { report "third: exit status $?"; tail -n 5 "$SCRATCH/third.log"; }
grep -q '"status": "finished' "$folder/summary.json" || report "third: no summary"
[ ! -e "$folder/fields.pvd" ] && [ ! -e "$folder/fields-1.vtu" ] || report "the series of an older run stays"
[ "$(there "${own[@]}")" = 4 ] || report "own files are gone: $(ls "$folder")"
[ -z "$(find "$folder" -name '.*' ! -name '.')" ] || report "hidden files: $(ls -A "$folder")"

echo "$failures failed"
[ "$failures" = 0 ]
