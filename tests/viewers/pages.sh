#!/usr/bin/env bash
# The pages of a sweep and of a movie in Chromium, from files: what stands there after loading, and after a slider is moved.
set -u
failures=0 TOP=$PWD
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
work=$SCRATCH/top # links to the cases, so that out/ is our own
mkdir -p "$work" && ln -s "$PWD/cases" "$work" && cd "$work" || exit 1
# make explore's script
EXPLORE=1 CASE=incline VARY="tan=0.2,0.3 nx=4,8" OPTIONS="-element P1 -movie 1 -series 3" JOBS=1 bash cases/sweep/sweep.sh >log 2>&1 ||
  { cat log; exit 1; }
top=$PWD/out/sweep/incline
# dom FILE ADDRESS: the page as text after its script has run
dom() { timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$SCRATCH/browser" --virtual-time-budget=3000 --dump-dom "file://$1$2" 2>/dev/null; }
# holds NAME WORDS: in the last page
holds() { grep -qF -- "$2" page || fail "$1 lacks '$2'"; }

dom "$top/explore.html" "#tan=0.3,nx=4" >page
holds chosen 'tan = 0.3, nx = 4'
holds chosen 'src="tan=0.3,nx=4/stress.png"' 
"$PYTHON" - "$top" <<'END' || fail "chosen: the table of results"
import csv, re, sys
page = open("page").read()
row = [r for r in csv.DictReader(open(sys.argv[1] + "/sweep.csv")) if (r["tan"], r["nx"]) == ("0.3", "4")][0]
cells = re.findall(r"<tr><td>([^<]*)</td><td>([^<]*)</td>", page)
assert cells, "no table"
for name, value in cells:
    assert abs(float(value) - float(row[name])) <= 1e-4 * abs(float(value)), (name, value, row[name])
assert len(re.findall('<path class="mine" d="M', page)) >= 2, "no curves"
assert page.count('<path class="other" d="M') >= 3, "not those of the other variants"
assert not re.search("NaN|undefined|Infinity", re.sub("<script.*?</script>", "", page, flags=re.S)), "numbers missing"
END

# a user moves the second slider
sed 's#</body>#<script>{ const s = document.getElementById("slider-1"); s.value = 1; s.dispatchEvent(new Event("input")); }</script></body>#' \
  "$top/explore.html" >"$top/moved.html"
dom "$top/moved.html" "#tan=0.2,nx=4" >page
holds moved 'tan = 0.2, nx = 8'
holds moved 'src="tan=0.2,nx=8/stress.png"'
holds moved '>nx</text>'

dom "$top/tan=0.2,nx=4/movie.html" "#1" >page
"$PYTHON" - <<'END' || fail "movie: the frame of its address"
import json, re
page = open("page").read()
data = json.loads(re.search('<script id="frames"[^>]*>(.*?)</script>', page, re.S).group(1))
assert len(data["images"]) == 4, len(data["images"])
assert re.search('id="frame"[^>]*src="([^"]*)"', page).group(1) == data["images"][1]
assert f't = {data["t"][1]}</output>' in page
END
# and lets it play to its end
sed 's#</body>#<script>document.getElementById("play").click();</script></body>#' "$top/tan=0.2,nx=4/movie.html" >"$top/played.html"
dom "$top/played.html" "#0" >page
holds played 't = 1</output>'
holds played '>Play</button>'

# that of a run in space is drawn by WebGL: its colors are there, and other frames look different
"$PYTHON" "$TOP/tests/support/space_run.py" "$SCRATCH/space" && "$PYTHON" cases/plotting/scene.py "$SCRATCH/space" movie >log || fail "no page of a run in space"
for frame in 0 3; do
  timeout 60 chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$SCRATCH/browser" \
    --virtual-time-budget=3000 --window-size=900,800 --screenshot="$PWD/space-$frame.png" "file://$SCRATCH/space/movie.html#$frame" 2>/dev/null
done
"$PYTHON" - <<'END' || fail "space: what the page shows"
import numpy as np
from PIL import Image
start, end = (np.asarray(Image.open(f"space-{k}.png").convert("RGB")).astype(int)[:560, :640] for k in (0, 3))
vivid = lambda image: ((image.max(axis=2) - image.min(axis=2)) > 60).mean()
assert vivid(start) < 0.001, "the undeformed workpiece has colors"
assert vivid(end) > 0.01, "the strained one has none"
END

echo "$failures failed"
[ "$failures" = 0 ]
