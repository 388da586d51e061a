#!/usr/bin/env bash
# Every section, equation, key, link and path that the documents and comments cite exists (citations.py); wrong ones in a
# copy are found.
set -eu
"$PYTHON" tests/shell/citations.py

copy="$SCRATCH/copy"
mkdir -p "$copy/cxx"
cp cxx/*.md cxx/*.bib "$copy/cxx"
for folder in cases edp plugins tests; do ln -sfT "$PWD/$folder" "$copy/$folder"; done
for folder in cxx/*/; do ln -sfT "$PWD/$folder" "$copy/${folder%/}"; done
for file in *.md; do ln -sfT "$PWD/$file" "$copy/$file"; done
"$PYTHON" tests/shell/citations.py "$copy" >/dev/null || { echo "the copy differs"; exit 1; }

# the words are put together here, else this file would cite what does not exist
m=METHOD.md a=ALGORITHMS.md wrong=0
expect() { # the line of a comment, what must be said of it
  printf '#pragma once\n// %s\n' "$1" >"$copy/cxx/wrong.hpp"
  if "$PYTHON" tests/shell/citations.py "$copy" >"$SCRATCH/said.txt" || ! grep -qF "cxx/wrong.hpp:2: $2" "$SCRATCH/said.txt"
  then echo "not found: $1"; cat "$SCRATCH/said.txt"; wrong=1; fi
}
expect "see $m 9.9" "METHOD.md has no section 9.9"
expect "see $m 3.1, 3.99" "METHOD.md has no section 3.99"
expect "see $a 5.77" "ALGORITHMS.md has no section 5.77"
expect "see $m (1.99)" "METHOD.md has no equation (1.99)"
expect "see $m (1.3) to (1.98)" "METHOD.md has no equation (1.98)"
expect "the term of article (1.""30)" "article has no equation (1.30)"
expect "the law (""3.1)" "whose equation is (3.1)?"
expect "as in [Nobody""1999]" "references.bib has no key Nobody1999"
expect "see method"".md" "write METHOD.md"
expect "see $m section 1" "write \"METHOD.md 1\""
rm "$copy/cxx/wrong.hpp"

rm "$copy/README.md" && printf 'text\n[link](cxx/NOTHING.md)\n`cxx/nothing.cpp`\n' >"$copy/README.md"
! "$PYTHON" tests/shell/citations.py "$copy" >"$SCRATCH/said.txt" || wrong=1
grep -qF "README.md:2: link to cxx/NOTHING.md, which does not exist" "$SCRATCH/said.txt" || { echo "link not found"; wrong=1; }
grep -qF "README.md:3: path cxx/nothing.cpp, which does not exist" "$SCRATCH/said.txt" || { echo "path not found"; wrong=1; }
exit $wrong
