#!/usr/bin/env bash
# Names in cxx/NAMES.md occur in the tree and follow its rule, options and constants in ALGORITHMS.md have the numbers of the
# code (names.py); wrong ones in a copy are found.
set -eu
"$PYTHON" tests/shell/names.py

copy="$SCRATCH/copy" wrong=0
mkdir -p "$copy/cxx"
for folder in edp plugins; do ln -sfT "$PWD/$folder" "$copy/$folder"; done
for folder in cxx/*/; do ln -sfT "$PWD/$folder" "$copy/${folder%/}"; done
expect() { # file, what sed does to it, what must be said then
  cp cxx/NAMES.md cxx/ALGORITHMS.md "$copy/cxx"
  sed -i "$2" "$copy/cxx/$1"
  ! cmp -s "cxx/$1" "$copy/cxx/$1" || { echo "nothing changed by $2"; wrong=1; }
  if "$PYTHON" tests/shell/names.py "$copy" >"$SCRATCH/said.txt" || ! grep -q "^cxx/$1:[0-9]*: $3" "$SCRATCH/said.txt"
  then echo "not found: $3"; cat "$SCRATCH/said.txt"; wrong=1; fi
}
expect NAMES.md 's/`WorkpieceState::stress`/`WorkpieceState::stresses`/' "the C++ name WorkpieceState::stresses does not occur"
expect NAMES.md 's/`M.stresseq`/`M.equivalentstress`/' "the script name M.equivalentstress does not occur"
expect NAMES.md 's/`dtmax=`/`largestdt=`/' "the script name largestdt= does not occur"
expect NAMES.md 's/`rcConverged`/`rcDone`/' "the script name rcDone does not occur"
expect NAMES.md 's/`normal_force`/`force_normal`/' "the file name force_normal does not occur"
expect NAMES.md '/^| `hardening_modulus` | `H`/d' "hardening_modulus and H break the rule"
expect NAMES.md '/^| `hint` | `s`/a | `stress` | `F` | none |' "no row needs the exception stress, F"
expect ALGORITHMS.md 's/^| `path_limit` | 1.5 /| `path_limit` | 1.6 /' "path_limit is 1.5 in UpdateOptions"
expect ALGORITHMS.md '/^| `anderson_memory` /d' "the table of options lacks anderson_memory of IterationOptions"
expect ALGORITHMS.md 's/^| `tied` /| `bound` /' "IterationOptions has no member bound"
expect ALGORITHMS.md 's/`GROWTH` (1.3)/`GROWTH` (1.4)/' "the constant GROWTH is 1.3 in the code"
expect ALGORITHMS.md 's/`GROWS` (2)/`FAST` (2)/' "the constant FAST is none in the code"
exit $wrong
