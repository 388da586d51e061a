#!/usr/bin/env bash
# Every case: -h prints all options that it uses with default and meaning, numbers with a unit, and exits 0; the script with what it
# includes from its own folder (hertz.idp, shared with others, apart) has at most 120 lines of at most 120 characters.
set -u
failures=0
declare -A unused=([shear]=10 [rubber]=1 [rolling-contact]=1 [block-upsetting]=1 [slab]=1 [tilted-punch]=1 [ball-rolling]=1 [burnishing]=1)    # of the options that all cases share: test_options.sh
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
for script in cases/*/*.edp; do
  for word in -h --help; do
    "$BURNISH" "$script" $word >"$SCRATCH/help.txt" 2>&1 || fail "$script $word: exit status $?"
  done
  more=$(grep -oE '^include "rc[A-Za-z]+Options.idp"' "$script" | cut -d'"' -f2)
  options=$(grep -hv '^//' "$script" edp/cases/rcCaseOptions.idp ${more:+edp/cases/$more} | grep -oE 'rc(Real|Int|Text)\("-[a-zA-Z0-9]+"' | wc -l)
  options=$((options - ${unused[$(basename "$script" .edp)]-0}))
  # one line more for -options
  [ "$(grep -c '^  -' "$SCRATCH/help.txt")" = $((options + 1)) ] || fail "$script: $options options, help has others"
  bare=$(grep -oE 'rc(Real|Int|Text)\("-[a-zA-Z0-9]+", [^"]*("[^"]*")?\)' "$script")
  [ -z "$bare" ] || fail "$script: no unit and meaning in $bare"
  grep -E '^  -' "$SCRATCH/help.txt" | awk 'NF < 3 {exit 1}' || fail "$script: an option without meaning"
  folder=$(dirname "$script")
  lines=$(cat "$script" $(ls "$folder"/*.idp 2>/dev/null | grep -v hertz.idp) | wc -l)
  [ "$lines" -le 120 ] || fail "$folder: $lines lines"
  long=$(awk 'length($0) > 120 {print FILENAME ":" FNR}' "$script")
  [ -z "$long" ] || fail "lines of more than 120 characters: $long"
done
[ "$("$BURNISH" cases/rolling/rolling.edp -h | grep -c 'm  *outer radius of the sector')" = 1 ] || fail "rolling: -Ro"
echo "$failures failed"
[ "$failures" = 0 ]
