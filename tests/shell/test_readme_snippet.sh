#!/usr/bin/env bash
# The complete scripts of README.md, extracted and run as printed: every block that opens with ```freefem.
set -eu
awk -v folder="$SCRATCH" '/^```freefem[[:space:]]*$/ { inside = 1; ++n; next }
     /^```/ && inside { inside = 0; next }
     inside { print >(folder "/snippet" n ".edp") }
     END { if (n < 1) { print "README.md has no ```freefem block" >"/dev/stderr"; exit 1 }
           if (inside) { print "a ```freefem block of README.md is not closed" >"/dev/stderr"; exit 1 } }' README.md
cd "$SCRATCH"   # whatever they write stays here
for snippet in snippet*.edp; do
  lines=$(grep -c '[^[:space:]]' "$snippet") || { echo "$snippet of README.md is empty"; exit 1; }
  "$BURNISH" "$snippet" >output.txt 2>&1 </dev/null || { status=$?; cat output.txt; echo "exit status $status"; exit 1; }
  cat output.txt
  grep -q '[^[:space:]]' output.txt || { echo "$snippet printed nothing"; exit 1; }
  echo "$snippet of $lines lines run as printed"
done
