#!/usr/bin/env bash
# Answers that are handed in are compared with lab.json, or with those of another run (lab.py NAME FILE...).
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
