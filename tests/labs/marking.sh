#!/usr/bin/env bash
# Answers that are handed in are compared with lab.json, or with those of another run (lab.py NAME FILE...). A key without a value, with
# one too many, or with a wrong one is noticed.
set -eu
right="$SCRATCH/right.csv" wrong="$SCRATCH/wrong.csv" other="$SCRATCH/other.csv"
"$PYTHON" - >"$right" <<'END'
import json
print("name,value,unit")
for name, (value, _) in json.load(open("cases/labs/2-friction/lab.json"))["answers"].items():
    print(f"{name},{value},mm")
END
sed '2s/,[^,]*,/,1e9,/; $d' "$right" >"$wrong"
sed '2s/,[^,]*,/,1e9,/' "$right" >"$other"
said="$SCRATCH/said.txt"
lab() { "$PYTHON" tests/labs/lab.py 2-friction "$@" >"$said"; }
lab "$right" && grep -q "right.csv: 5 of 5 answers" "$said"
if lab "$right" "$wrong"; then echo "a wrong answer was not noticed"; exit 1; fi
grep -q "wrong.csv: 3 of 5 answers" "$said" && grep -q "is 1e+09, expected" "$said" && grep -q "is missing" "$said"
if lab "$right" --against "$other"; then echo "the other run was not used"; exit 1; fi
grep -q "right.csv: 4 of 5 answers" "$said"
lab "$other" --against "$other"

lab="$SCRATCH/lab"
solved() { # SED: solves lab 0 by its key, changed so
  rm -rf "$lab" && cp -r cases/labs/0-first-steps "$lab" && sed -i "$1" "$lab/key.md"
  "$PYTHON" cases/labs/solve.py "$lab" -o "$SCRATCH/solved" >"$said" 2>&1
}
refused() { if solved "$1"; then echo "solved in spite of $1"; exit 1; fi; grep -qF "$2" "$said" || { cat "$said"; exit 1; }; }
refused '/^- Gap 2/d' "key.md has no value of gap 2 of lab.edp"
refused 's/^- Gap 5.*/&\n- Gap 6: `1`/' "no script has the gaps"
refused 's/^- Gap 5/- Gap 4/' "key.md has gap 4 twice"
refused '/^| 3 |/d' "key.md does not mend broken3.edp"
refused 's/`-500\*t`/`-501*t`/' "expected once"
solved 's/^- Gap 3: `-F/- Gap 3: `-0.9*F/'
"$BURNISH" "$SCRATCH/solved/solution.edp" -pictures 0 -out "$SCRATCH/wrong" >"$said" 2>&1 || true
if "$PYTHON" tests/labs/lab.py 0-first-steps "$SCRATCH/wrong/answers.csv" >"$said" 2>&1; then echo "a wrong value was not noticed"; exit 1; fi
grep -E 'force of the roller on the block.* is -(359\.9|360)[0-9.]*, expected -400' "$said"
