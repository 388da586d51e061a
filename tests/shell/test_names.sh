#!/usr/bin/env bash
# Names in cxx/NAMES.md occur in the tree and follow its rule, options and constants in ALGORITHMS.md have the numbers of the
# code (names.py); wrong ones in a copy are found.
set -eu
"$PYTHON" tests/shell/names.py

copy="$SCRATCH/copy" wrong=0
mkdir -p "$copy/cxx"
for folder in edp plugins; do ln -sfT "$PWD/$folder" "$copy/$folder"; done
for folder in cxx/*/; do ln -sfT "$PWD/$folder" "$copy/${folder%/}"; done
rm "$copy/cxx/run" && cp -r cxx/run "$copy/cxx/run"
expect() { # file, what sed does to it, what must be said then
  cp cxx/NAMES.md cxx/ALGORITHMS.md "$copy/cxx"
  cp cxx/run/settings.cpp "$copy/cxx/run"
  sed -i "$2" "$copy/cxx/$1"
  ! cmp -s "cxx/$1" "$copy/cxx/$1" || { echo "nothing changed by $2"; wrong=1; }
  if "$PYTHON" tests/shell/names.py "$copy" >"$SCRATCH/said.txt" || ! grep -q "^cxx/$1:[0-9]*: $3" "$SCRATCH/said.txt"
  then echo "not found: $3"; cat "$SCRATCH/said.txt"; wrong=1; fi
}
expect NAMES.md 's/`WorkpieceState::stress`/`WorkpieceState::stresses`/' "the C++ name WorkpieceState::stresses does not occur"
expect NAMES.md 's/`M.stresseq`/`M.equivalentstress`/' "the script name M.equivalentstress does not occur"
expect NAMES.md 's/`output=`/`stops=`/' "the script name stops= does not occur"
expect NAMES.md 's/`rcConverged`/`rcDone`/' "the script name rcDone does not occur"
expect NAMES.md 's/`normal_force`/`force_normal`/' "the file name force_normal does not occur"
expect NAMES.md '/^| `hardening_modulus` | `H`/d' "hardening_modulus and H break the rule"
expect NAMES.md '/^| `hint` | `s`/a | `stress` | `F` | none |' "no row needs the exception stress, F"
expect ALGORITHMS.md 's/^| `min_substeps` | 3 /| `min_substeps` | 4 /' "min_substeps is 3 in UpdateOptions"
expect ALGORITHMS.md '/^| `max_substeps` /d' "max_substeps of UpdateOptions is neither a setting nor in the table of options"
expect ALGORITHMS.md 's/^| `forms_only` /| `bound` /' "StepperOptions has no member bound"
expect run/settings.cpp 's/"25", COUNT/"20", COUNT/' "maxiterations is 25 in IterationOptions"
expect run/settings.cpp 's/{"pathlimit"/{"largestpath"/' "path_limit and largestpath break the rule"
expect ALGORITHMS.md 's/`GROWTH` (1.3)/`GROWTH` (1.4)/' "the constant GROWTH is 1.3 in the code"
expect ALGORITHMS.md 's/`GROWS` (2)/`FAST` (2)/' "the constant FAST is none in the code"
exit $wrong
