#!/usr/bin/env bash
# -model auto: leaner models of a case are run and compared. A faster one is proposed, whose results are within the accuracy
# asked; one that changes them by more is not.
set -u
failures=0
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
"$BURNISH" cases/upsetting/upsetting.edp -n 12 -steps 60 -pictures 0 -check 0 -model auto -accuracy 0.05 -out "$SCRATCH/loose" >"$SCRATCH/loose.txt" ||
  fail "loose: exit status $?"
grep -A20 "leaner models" "$SCRATCH/loose.txt"
leanest=$(sed -n 's/^  leanest: \(.*[^ ]\)  *([0-9.]* times faster)$/\1/p' "$SCRATCH/loose.txt")
[ -n "$leanest" ] || fail "no leaner model within 5 %"
grep -q "linear elements .*(too much)" "$SCRATCH/loose.txt" || fail "linear elements, which let side nodes fold over, are taken"
# what is proposed keeps what it promises
read -ra words <<<"$leanest"
"$BURNISH" cases/upsetting/upsetting.edp -n 12 -steps 60 "${words[@]}" -pictures 0 -check 0 -out "$SCRATCH/lean" >/dev/null || fail "leanest: exit status $?"
"$PYTHON" - "$SCRATCH" <<'END' || fail "results of the leanest model"
import json, sys
base, lean = (json.load(open(f"{sys.argv[1]}/{name}/summary.json"))["results"] for name in ("loose", "lean"))
numbers = [n for n, item in base.items() if item.get("expected") != 0 and item["value"]]
off = {n: abs(lean[n]["value"] / base[n]["value"] - 1) for n in numbers}
print("largest change of a result:", max(off.values()))
sys.exit(not numbers or max(off.values()) > 0.05)
END
echo "$failures failed"
[ "$failures" = 0 ]
