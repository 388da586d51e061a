#!/usr/bin/env bash
# The pages of a sweep and of a movie in Chromium, from files: what stands there after loading, and after a user has clicked.
set -u
failures=0 TOP=$PWD
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
work=$SCRATCH/top # links to the cases, so that out/ is our own
mkdir -p "$work" && ln -s "$PWD/cases" "$work" && cd "$work" || exit 1
"$BURNISH" sweep cases/incline/incline.edp tan=0.2,0.25,0.3 nx=4,8,0 -element P1 -movie 1 -series 3 >log 2>&1 || { cat log; exit 1; }
top=$PWD/out/sweep/incline
# dom FILE ADDRESS: the page as text after its script has run
dom() { timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$SCRATCH/browser" --virtual-time-budget=8000 --dump-dom "file://$1$2" 2>/dev/null; }
# holds NAME WORDS: in the last page
holds() { grep -qF -- "$2" page || fail "$1 lacks '$2'"; }

# the page of a sweep: a user sorts by the second parameter, downwards, marks the first row, chooses the last result, saves
sed 's#</body>#<script>{ const wait = setInterval(() => { if (!document.body.dataset.drawn) return; clearInterval(wait); \
  for (const _ of [1, 2]) byId("head").querySelectorAll("th")[2].click(); \
  byId("rows").querySelector("tr").click(); \
  byId("result").selectedIndex = byId("result").options.length - 1; byId("result").dispatchEvent(new Event("change")); \
  element(document.body, "pre", {id: "tried"}, JSON.stringify({csv: csv(), markdown: markdown(), marked: [...marked].map(labelOf), \
    curves: byId("historyplot").data.length, effects: data.parameters.map((_, k) => byId(`effect-${k}`).data[1].y.length), \
    result: resultName(), contour: byId("surfaceplot").data[0].type, front: byId("front").textContent, \
    page: document.scrollingElement.scrollWidth - innerWidth, table: byId("rows").closest(".wide").scrollWidth - innerWidth})); }, 50); }</script></body>#' "$top/index.html" >"$top/tried.html"
dom "$top/tried.html" "" >page
"$PYTHON" - "$top" <<'END' || fail "what the page of a sweep shows"
import csv, html, io, json, re, sys
page = open("page").read()
tried = json.loads(html.unescape(re.search('<pre id="tried">(.*?)</pre>', page, re.S).group(1)))
rows = list(csv.DictReader(open(sys.argv[1] + "/sweep.csv")))
good = [r for r in rows if r["status"] == "finished"]
assert len(rows) == 9 and len(good) == 6, [r["status"] for r in rows]
body = re.search('<tbody id="rows">(.*?)</tbody>', page, re.S).group(1)
shown = re.findall(r'<tr class="([^"]*)"><td>(?:<img[^>]*>)?</td><td>([^<]*)</td><td>([^<]*)</td>', body)
assert [s[2] for s in shown] == ["8"] * 3 + ["4"] * 3 + ["0"] * 3, shown
assert "marked" in shown[0][0] and tried["marked"] == [f"tan = {shown[0][1]}, nx = 8"]
assert all(("failed" in s[0]) == (s[2] == "0") for s in shown) and body.count("expected") >= 3
assert body.count('<img src="data:image/png;base64,') == 6
saved = list(csv.reader(io.StringIO(tried["csv"])))
assert len(saved) == 10 and saved[0][1] == "nx" and [s[1] for s in saved[1:]] == [s[2] for s in shown]
by = {(r["tan"], r["nx"]): r for r in rows}
for line in saved[1:7]:
    for title, cell in zip(saved[0][2:], line[2:]):
        name = title.split(" [")[0]
        if name in rows[0] and name != "status":
            assert abs(float(cell) - float(by[tuple(line[:2])][name])) <= 1e-4 * abs(float(cell)), (name, cell)
assert tried["markdown"].count("\n") == 11 and tried["markdown"].startswith("| tan | nx |")
assert tried["effects"] == [6, 6] and tried["curves"] == 6 and tried["contour"] == "contour", tried
assert tried["front"].startswith("On the front: tan = ")
assert tried["table"] > 0 >= tried["page"], tried   # only the table scrolls sideways in a window of 800 pixels
assert page.count('class="main-svg"') >= 8, page.count('class="main-svg"')
assert not re.search("NaN|undefined|Infinity", re.sub("<script.*?</script>|<[^>]*>", " ", page, flags=re.S)), "numbers missing"
END

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
