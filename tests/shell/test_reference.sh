#!/usr/bin/env bash
# The reference (edp/manual/reference) agrees with the loaded plugin, the sources and the files of four runs (reference.py); an
# entry that is missing, superfluous or wrong in a copy is found. Pages, help and snippets are whole (reference_pages.py).
set -u
failures=0
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }
runs="$SCRATCH/rolling $SCRATCH/incline $SCRATCH/ball $SCRATCH/upsetting"
echo 'load "burnish"
cout << rcCallables(0);' >"$SCRATCH/list.edp"
"$BURNISH" "$SCRATCH/list.edp" >"$SCRATCH/callables.txt" || fail "rcCallables"
"$BURNISH" cases/rolling/rolling.edp -options list >"$SCRATCH/options.json" || fail "-options list"
"$BURNISH" cases/rolling/rolling.edp -element P1 -inner 4 -outer 40 -sides 6 -steps 20 -width 3 -series 2 -pictures 0 -check 0 \
  -out "$SCRATCH/rolling" >"$SCRATCH/run.txt" || { case $? in 4) ;; *) fail "rolling"; cat "$SCRATCH/run.txt" ;; esac; }
"$BURNISH" cases/incline/incline.edp -nx 4 -steps 3 -series 1 -pictures 0 -check 0 -out "$SCRATCH/incline" >"$SCRATCH/run.txt" ||
  { fail "incline"; cat "$SCRATCH/run.txt"; }
"$BURNISH" cases/ball/ball.edp -what dragged -n 2 -steps 2 -series 1 -pictures 0 -check 0 -out "$SCRATCH/ball" >"$SCRATCH/run.txt" ||
  { case $? in 4) ;; *) fail "ball"; cat "$SCRATCH/run.txt" ;; esac; }
"$BURNISH" cases/upsetting/upsetting.edp -n 4 -steps 20 -reduction 0.7 -remesh 1 -series 1 -pictures 0 -check 0 -out "$SCRATCH/upsetting" >"$SCRATCH/run.txt" ||
  { case $? in 4) ;; *) fail "upsetting"; cat "$SCRATCH/run.txt" ;; esac; }
# shellcheck disable=SC2086
check() { "$PYTHON" -B tests/shell/reference.py "$1" "$SCRATCH/callables.txt" "$SCRATCH/options.json" $runs; }
check . || fail "the reference"

copy="$SCRATCH/copy"
mkdir -p "$copy"
ln -sf "$PWD/cxx" "$PWD/cases" "$copy"
cp -r plugins edp "$copy"
wanted=()
change() { # file, what sed does to it, what must be said then
  cp "$copy/$1" "$SCRATCH/before"
  sed -i "$2" "$copy/$1"
  ! cmp -s "$SCRATCH/before" "$copy/$1" || fail "nothing changed by $2"
  wanted+=("$3")
}
change plugins/contact_type.cpp '/^\/\/   C.couple/,/^\/\/     ! relations/d' "no entry for method contact.couple(string, string)"
change plugins/contact_type.cpp '/^\/\/     straight=/,/^\/\/     loose/{/loose/!d}' "rcContact: no line for the parameter straight="
change plugins/contact_type.cpp 's/^\(\/\/     friction= .*\)| 0 |/\1| 1 |/' "rcContact friction= has the default 1, in the code 0"
change edp/manual/reference/callables.txt '/^member tool.q /d' "callables.txt lacks \"member tool.q -> real[int]\""
change edp/run/rcNotes.idp '/^\/\/   rcNotedMean/d' "no entry for function rcNotedMean(string) of edp/run/rcNotes.idp"
change edp/run/rcRunState.idp 's/^\/\/   rcQuiet /\/\/   rcSilent /' "nothing callable is rcSilent"
change edp/manual/reference/files.txt '/^\/\/   surface.csv gap/d' "no entry for surface.csv gap"
change edp/cases/rcSummary.idp '/^\/\/   summary.json left_out/d' "no entry for summary.json left_out"
change plugins/tool_type.cpp 's/^\/\/     ! lack the formula/\/\/     ! want the formula/' "no source says \"want the formula\""
wanted+=("nothing callable is t.q" "no entry for setting rcQuiet()") # their other halves

! check "$copy" >"$SCRATCH/said.txt" 2>&1 || fail "a wrong reference passes"
for text in "${wanted[@]}"; do grep -qF -- "$text" "$SCRATCH/said.txt" || fail "not found: $text"; done
[ "$(grep -c . "$SCRATCH/said.txt")" = "${#wanted[@]}" ] || { fail "expected ${#wanted[@]} lines"; cat "$SCRATCH/said.txt"; }

"$PYTHON" -B edp/manual/reference/generate.py "$SCRATCH/pages" || fail "generate.py"
"$PYTHON" -B tests/shell/reference_pages.py "$SCRATCH/pages" || fail "the pages"
for snippet in "$SCRATCH"/pages/snippet-*.edp; do
  options=(-pictures 0 -steps 3 -nx 12 -check 0)
  grep -q rcOptionsEnd "$snippet" || options=() # are refused where nothing reads them
  (cd "$SCRATCH" && "$BURNISH" "$snippet" "${options[@]}" >said.txt 2>&1) ||
    { fail "$snippet"; cat "$SCRATCH/said.txt"; }
done

says() { # status, words of the output, words of the command
  local status=0 output expected=$1 words=$2
  shift 2
  output=$(cd / && "$BURNISH" "$@" 2>&1) || status=$?
  [ "$status" = "$expected" ] || fail "burnish $*: exit status $status, expected $expected"
  case $output in *"$words"*) ;; *) fail "burnish $*: no \"$words\" in $output" ;; esac
}
says 0 "burnish help [NAME]" --help
says 0 "Coulomb coefficient" help contact.add
says 0 "interrupted by Ctrl-C" help exit
says 0 "final.stick_share" help summary
says 0 "stepsperfactor=" help rcContact
says 0 "-assembly        string " help u-channel
says 0 "edp/manual/sweeps.md" help sweep
says 0 "edp/manual/pictures.md" help sequence.png
says 20 "near it: contact.add" help contact.ad
echo "$failures failed"
[ "$failures" = 0 ]
