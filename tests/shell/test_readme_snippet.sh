#!/usr/bin/env bash
# The shortest script of README.md, extracted and run as printed: the first block that opens with ```freefem.
set -eu
awk '/^```freefem[[:space:]]*$/ && !found { inside = found = 1; next }
     /^```/ && inside { inside = 0; closed = 1; exit }
     inside { print }
     END { if (!found) { print "README.md has no ```freefem block" >"/dev/stderr"; exit 1 }
           if (!closed) { print "the ```freefem block of README.md is not closed" >"/dev/stderr"; exit 1 } }' \
  README.md >"$SCRATCH/snippet.edp"
lines=$(grep -c '[^[:space:]]' "$SCRATCH/snippet.edp") || { echo "the freefem block of README.md is empty"; exit 1; }
cd "$SCRATCH"   # whatever it writes stays here
"$BURNISH" snippet.edp >output.txt 2>&1 </dev/null || { status=$?; cat output.txt; echo "exit status $status"; exit 1; }
cat output.txt
grep -q '[^[:space:]]' output.txt || { echo "the snippet printed nothing"; exit 1; }
echo "snippet of $lines lines run as printed"
