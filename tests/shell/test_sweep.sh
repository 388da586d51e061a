#!/usr/bin/env bash
# burnish sweep with a program of known results in place of FreeFEM (fake_run.py): variants, studies that nothing overwrites, failed ones,
# what is stopped or killed, goals, the page's data, refusals; the numbers that sweeps compute (sweep_numbers.py).
set -u
export TOP=$PWD REAL=$BURNISH BURNISH=$PWD/tests/shell/fake_run.py
failures=0
fail() { echo "FAILED: $1"; sed 's/^/  | /' "$SCRATCH/log"; failures=$((failures + 1)); }
"$PYTHON" tests/shell/sweep_numbers.py >"$SCRATCH/log" 2>&1 || fail "numbers"
cd "$SCRATCH" && mkdir -p own && cd own || exit 1
printf 'rcReal("-a", 1, "mm", "radius"); rcReal("-b", 1, "-", "friction"); rcInt("-steps", 10, "-", "number of steps");\nrcCaseEnd(C, M, S);\n' >press.edp
top=out/sweep/press
# sweep STATUS NAME WORDS...: output in the file log
sweep() { local s=$1 n=$2 r; shift 2; "$REAL" sweep press.edp "$@" -jobs 4 >"$SCRATCH/log" 2>&1; r=$?; [ "$r" = "$s" ] || fail "$n: exit status $r instead of $s"; }
holds() { grep -qF -- "$2" "${3:-$SCRATCH/log}" || fail "$1: ${3:-the output} lacks '$2'"; }
lacks() { ! grep -qF -- "$2" "${3:-$SCRATCH/log}" || fail "$1: ${3:-the output} has '$2'"; }
runs() { cat "$1"/*/ran.txt | wc -l; }
ran() { local n; n=$(runs "$2"); [ "$n" = "$3" ] || fail "$1: $n runs instead of $3"; }

# 1. Two of six fail: kept, skipped, reasons, exit status 0
sweep 0 grid a=-4,1,2 b=1:2:2 c=0.5
holds grid "press: 6 variants"
holds grid "2 of 6 variants failed"
holds grid "a=-4,b=1,c=0.5: exit code 10: the product is too small"
holds grid "a,b,c,status,bowl,product,sum,ishigami," $top/sweep.csv
holds grid "2,1,0.5,finished,0.0,2.0,3.0," $top/sweep.csv
holds grid "[6/6] "
[ "$(head -c 4 $top/sweep.parquet)" = PAR1 ] || fail "grid: no sweep.parquet"
ran grid $top 6
before=$(cat $top/*/summary.json | md5sum)
sweep 0 same a=-4,1,2 b=1:2:2 c=0.5
holds same "6 ended before"
ran same $top 6
[ "$before" = "$(cat $top/*/summary.json | md5sum)" ] || fail "same: a variant was touched"

# 2. Failed ones again, with shorter steps; a value that the script refuses is a failed variant
sweep 0 again a=-4,1,2 b=1:2:2 c=0.5 -again "-steps 400"
holds again "2 failed variants are tried again"
lacks again "variants failed"
holds again "-steps 400" $top/sweep.csv
ran again $top 6
sweep 0 refused a=1,2 c=0.95,0.5 -study high
holds refused "a=1,c=0.95: exit code 20: option -c is 0.95, expected at most 0.9"
ran refused out/sweep/high 2
sweep 1 none a=-4,-5 b=1 c=0.5 -study none
holds none "2 of 2 variants failed"
holds none "burnish sweep: every variant failed"

sweep 0 poor a=-4,1 b=1,2 -study poor
before=$(cat out/sweep/poor/*/log.txt out/sweep/poor/*/ran.txt | md5sum)
wrong_again() { local n=$1 w=$2; shift 2; sweep 20 "$n" a=-4,1 b=1,2 -study poor -again "$*"; holds "$n" "$w"; }
wrong_again misspelt "-again: burnish: unknown option -stepps, expected one of" -stepps 400
wrong_again refused "-again: burnish: option -c is 0.95" -c 0.95
wrong_again varied "-again: -a is varied" -a 3
wrong_again settings "-again: -out is none of the script that a variant may have" -out x
[ "$before" = "$(cat out/sweep/poor/*/log.txt out/sweep/poor/*/ran.txt | md5sum)" ] || fail "again: refused, and a variant was touched"

# 3. Another request gets a study of its own, and takes what is there; a name that is taken is refused
sweep 0 wider a=-4,1,2,3 b=1,2 c=0.5
holds wider "press-2: 8 variants, 4 ended before (4 of them in another study)"
sweep 20 taken a=1,2 -study press
holds taken "-study press is there already with another request: variation 'a=-4,1,2 b=1:2:2 c=0.5', here 'a=1,2'"
sweep 0 options a=1,2 b=1,2 c=0.5 -steps 7
holds options "press-3: 4 variants; "
cp press.edp before.edp && echo "// another text" >>press.edp
sweep 20 text a=-4,1,2 b=1:2:2 c=0.5 -study press
holds text "script's text"
sweep 0 text a=-4,1,2 b=1:2:2 c=0.5
holds text "press-4: 6 variants; "
mv before.edp press.edp
sweep 0 back a=-4,1,2 b=1:2:2 c=0.5
holds back "press: 6 variants, 6 ended before"

# ... also where two begin together
cp press.edp pair.edp
for k in 1 2; do
  for want in 2.5 3.5; do "$REAL" sweep pair.edp target=sum=$want a=0:4 -steps $k -jobs 1 >"$SCRATCH/log.$want" 2>&1 & done; wait
  cat "$SCRATCH/log.2.5" "$SCRATCH/log.3.5" >"$SCRATCH/log"
  holds together "a = 1.5: sum"; holds together "a = 2.5: sum"; lacks together "waits for"
  [ "$(grep -lF -- "-steps $k" out/sweep/pair*/study.json | wc -l)" = 2 ] || fail "together: two studies took one name"
done

# 4. Stopped by Ctrl-C and killed while the slow half is held: the rest runs, nothing twice, and no run is left
for signal in INT KILL; do
  request=(a=1,2 b=1,2 slow=0.1,0.9 -steps "$signal" -study "stop$signal")
  (HOLD=$SCRATCH/go$signal exec "$REAL" sweep press.edp "${request[@]}" -jobs 4 >"$SCRATCH/log" 2>&1) &
  pid=$!
  # four have ended, and all others are under way: a run that begins just then might end before the next sweep looks
  for _ in $(seq 1200); do [ "$(cat out/sweep/stop$signal/*slow=0.1/exit.txt out/sweep/stop$signal/*slow=0.9/ran.txt 2>/dev/null | wc -l)" = 8 ] && break; sleep 0.05; done
  kill -$signal $pid; wait $pid 2>/dev/null; status=$?
  [ "$status" = "$([ "$signal" = KILL ] && echo 137 || echo 130)" ] || fail "$signal: exit status $status"
  touch "$SCRATCH/go$signal"
  sweep 0 "$signal" "${request[@]}"
  holds "$signal" "8 variants, 4 ended before"
  [ "$(cat out/sweep/stop$signal/*/exit.txt | sort -u)" = 0 ] || fail "$signal: exit codes"
  for v in out/sweep/stop$signal/*slow=0.1; do [ "$(wc -l <"$v/ran.txt")" = 1 ] || fail "$signal: $v ran twice"; done
done

# 5. A terminal sees a table that is renewed
script -qec "'$REAL' sweep press.edp a=1,2 slow=0.5 -jobs 1 -study live" "$SCRATCH/log" >/dev/null 2>&1
holds live "live: 1 of 2 ended, 0 failed, 1 running, about "
holds live $'\x1b[2A\x1b[J'

# ... and two other machines, reached by a program in place of ssh, take runs; as sshd it sets SHELL, which GNU parallel there needs
mkdir bin && printf '#!/bin/bash\necho "$1" >>"%s/hosts"\nshift; [ "$1" = -- ] && shift\nSHELL=/bin/bash exec bash -c "$*"\n' "$SCRATCH" >bin/ssh && chmod +x bin/ssh
PATH=$PWD/bin:$PATH sweep 0 ssh a=1:4:4 slow=0.2 -study far -ssh one,two
[ "$(sed '/^-/d' "$SCRATCH/hosts" | sort -u | xargs)" = "one two" ] && [ "$(cat out/sweep/far/*/exit.txt | xargs)" = "0 0 0 0" ] || fail "ssh: runs"

# 6. Goals
answer() { "$PYTHON" - "$@" <<'END' || fail "$1: answer"
import re, sys
text = open(sys.argv[2]).read()
for word in sys.argv[3:]:
    name, value, tolerance = word.split(":")
    found = re.findall(rf"(?<!\w){name} = (\S+?)(?: \+- \S+)?[,:;]", text.replace("\n", ";\n"))
    assert found, name
    assert abs(float(found[-1]) - float(value)) <= float(tolerance), (name, found[-1], value)
END
}
sweep 0 target target=product=3 a=0.5:4 -b 1.2
answer target "$SCRATCH/log" a:2.5:0.003
sweep 0 two "target=sum=3.5,product=3" a=1.8:4 b=0:1.7
answer two "$SCRATCH/log" a:2:0.02 b:1.5:0.02 sum:3.5:0.0035 product:3:0.003
sweep 0 end target=ishigami=5.8325 within=1e-5 c=0.2:1 -a 1   # its upper end is refused
answer end "$SCRATCH/log" ishigami:5.8325:6e-5
rm -rf out/sweep/press-[5-9]
sweep 0 least minimize=bowl "where=sum<2.5" within=0.01 a=0:4 b=-1:3
answer least "$SCRATCH/log" bowl:0.125:0.02
sweep 1 far target=sum=30 a=0:5
holds far "sum = 30 is not between 1 at a = 0 and 6 at 5"
sweep 20 name target=sun=3 a=0:5
holds name 'no result "sun"; there are: bowl, product, sum'
sweep 0 morris a=1:3:morris b=0:1:morris -samples 3 -study walk
holds morris "walk: "
[ "$(ls -d out/sweep/walk/a=* | wc -l)" -ge 7 ] || fail "morris: variants"
"$PYTHON" -c "
import math
print('t,curve')
for k in range(1, 21): print(f'{k/20},{3*(1-math.exp(-1.5*k/20)) + 0.004*(-1)**k}')" >curve.csv
sweep 0 curve measured=curve.csv a=2:4 b=1:2
answer curve "$SCRATCH/log" a:3:0.06 b:1.5:0.06
"$PYTHON" - "$SCRATCH/log" <<'END' || fail "curve: its intervals"
import re, sys
found = re.search(r"^a = (\S+) \+- (\S+), b = (\S+) \+- (\S+):", open(sys.argv[1]).read(), re.M)
a, da, b, db = map(float, found.groups())
assert abs(a - 3) < da < 0.1 and abs(b - 1.5) < db < 0.1, (a, da, b, db)
END
sweep 1 edge measured=curve.csv a=2:2.5 -b 1.5
holds edge "a at an end of the range"
sed 's/curve/strein/' curve.csv >bad.csv
sweep 20 columns measured=bad.csv a=2:2.5 b=1:2
holds columns 'no column "strein" in history.csv; there are: t, curve, strain'

# 7. The page: one file without addresses of other places; its data are those of the variants
"$PYTHON" - $top >"$SCRATCH/log" 2>&1 <<'END' || fail "page"
import csv, json, re, sys
page = open(sys.argv[1] + "/index.html", encoding="utf-8").read()
data = json.loads(re.search('<script id="data"[^>]*>(.*?)</script>', page, re.S).group(1).replace("<\\/", "</"))
rows = list(csv.DictReader(open(sys.argv[1] + "/sweep.csv")))
assert len(data["variants"]) == len(rows) == 6
assert [r["name"] for r in data["results"]] == ["bowl", "product", "sum", "ishigami"]
assert data["parameters"][0]["meaning"] == "radius" and data["parameters"][0]["values"] == ["-4", "1", "2"]
for variant, row in zip(data["variants"], rows):
    assert variant["values"] == {n: row[n] for n in "abc"}
    assert all(abs(v - float(row[n])) <= 1e-4 * abs(v) for n, v in variant["results"].items())
    assert len(variant["curves"]["curve"]) == 101
assert [c["name"] for c in data["columns"]] == ["curve", "strain", "t"]
surface = data["analysis"]["sum"]["surface"]
assert surface["kind"] == "polynomial of degree 1" and surface["error"] < 1e-9, surface["kind"]
assert abs(data["analysis"]["sum"]["sobol"]["first"][0] - 36 / 37) < 5e-3   # a from -4 to 2, b from 1 to 2
effects = data["analysis"]["sum"]["effects"]
assert effects["mean"] == [6, 1] and max(effects["deviation"]) < 1e-12 and effects["number"] == [4, 3], effects
assert not re.search(r'(src|href)="https?:', page) and len(re.search('<script id="plotly"[^>]*>(.*?)</script>', page, re.S).group(1)) > 1e6
END
sweep 0 draw a=1,2 b=1,2 -draw "sum;product"
holds draw /sweep.png
sweep 20 undrawn a=1:40:40 b=1:20:20 -draw foo -study undrawn
holds undrawn "burnish sweep: -draw: no result foo; there are: bowl"
[ "$(runs out/sweep/undrawn)" -lt 400 ] || fail "undrawn: all variants ran"

# 8. Refused before anything runs
refused() { local n=$1 w=$2; shift 2; sweep 20 "$n" "$@"; holds "$n" "$w"; }
count=$(find out -name ran.txt | wc -l) studies=$(ls out/sweep | wc -l)
refused unknown "unknown option -Rad, expected one of" Rad=1,2
refused equals '"a" is not name=values' a
refused parts '"1:x:3:4:5" has 5 parts, expected first:last:number' a=1:x:3:4:5
refused number '"x" is not a number' a=1:x:3
refused count "expected a whole number from 2 to 10000" a=1:2:1
refused value '"" is not a value' a=1,,2
refused twice "a has a value twice" a=1e-2,0.01
refused again "a is given twice" a=1,2 a=3
refused out "out cannot be varied" out=a,b
refused empty "nothing is varied"
refused fixed "-a is given, and a is varied" a=1,2 -a 1
refused ratio "-1 and 2 with log, expected two numbers of one sign" a=-1:2:3:log
refused range "2 to 1, expected an ascending range" a=2:1:latin
refused unsaid "a: first:last is an unknown, expected a goal besides" a=1:2
refused mixed "b: with target= every varied option is an unknown" target=sum=1 a=1:2 b=1,2
refused goals "expected one of target=" target=sum=1 minimize=bowl a=1:2
refused where "where= goes with minimize=" target=sum=1 "where=sum<1" a=1:2
refused form '"sum" is not name=value' target=sum a=1:2
refused folder '-study is "../x", expected letters' a=1,2 -study ../x
refused ways "a is drawn by morris and b is not" a=1:2:morris b=1:2:latin
refused seed '-again: "steps 4", expected 1 or options' a=1,2 -again "steps 4"
echo 'cout << 1;' >plain.edp
"$REAL" sweep plain.edp a=1,2 >"$SCRATCH/log" 2>&1; [ $? = 20 ] || fail "plain: status"
holds plain "plain.edp has no rcCaseEnd, which writes what a sweep compares. Two lines make a case of it: rcCase(C, M, u[], S, program, record)"
[ "$count" = "$(find out -name ran.txt | wc -l)" ] && [ "$studies" = "$(ls out/sweep | wc -l)" ] || fail "refused: something ran or is left"

echo "$failures failed"
[ "$failures" = 0 ]
