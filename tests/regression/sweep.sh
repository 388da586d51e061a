#!/usr/bin/env bash
# burnish sweep of a real scene: yield stress and hardening of a block are found back from its force over the way, and the friction that
# gives a force between those of its ends.
set -u
failures=0
fail() { echo "FAILED: $1"; cat log; failures=$((failures + 1)); }
scene=$PWD/cases/upsetting/upsetting.edp coarse="-n 4 -element P1 -steps 10"
cd "$SCRATCH" || exit 1
"$BURNISH" "$scene" $coarse -sigY 240 -H 800 -pictures 0 -series 0 -check 0 -out known >log 2>&1 || fail "the known run"
"$PYTHON" - known/history.csv >curve.csv <<'END'
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))
print("reduction,force")
for row in rows[1:]:
    print(f"{row['reduction']},{row['force']}")
END
"$BURNISH" sweep "$scene" measured=curve.csv sigY=100:400 H=200:2000 $coarse >log 2>&1 || fail "identification: exit status $?"
"$PYTHON" - log <<'END' || fail "identification"
import re
found = re.search(r"^sigY = (\S+) \+- (\S+), H = (\S+) \+- (\S+): rms of (\S+) of.*correlation of sigY and H (\S+),", open("log").read(), re.M)
sigY, _, H, _, rms, correlation = map(float, found.groups())
assert abs(sigY - 240) < 0.24 and abs(H - 800) < 2 and rms < 3e-4 and -1 < correlation < -0.5, (sigY, H, rms, correlation)
END
force=$("$BURNISH" "$scene" $coarse -mu 0.1 -pictures 0 -series 0 -check 0 -out friction >/dev/null 2>&1; tail -n 1 friction/history.csv | cut -d, -f21)
"$BURNISH" sweep "$scene" target="Q_y=$("$PYTHON" -c "print(-$force/2)")" mu=0.02:0.15 $coarse >log 2>&1 || fail "target: exit status $?"
"$PYTHON" - log <<'END' || fail "target"
import re
assert abs(float(re.search(r"^mu = (\S+):", open("log").read(), re.M)[1]) - 0.1) < 0.006
END
echo "$failures failed"
[ "$failures" = 0 ]
