#!/usr/bin/env bash
# Runs tests and counts them:  run_scripts.sh FILE...
#   .edp   a FreeFEM script        passes when it ends with exit code 0, or as its first lines say:
#            // expect exit: 20            the exit code it must end with
#            // expect text: some words    words its output must hold (may be repeated)
#            // options: -n 4              command line options of the script
#            // environment: NAME=value    a variable that it finds
#   .sh    a shell script          passes when it exits 0
#   else   a GoogleTest program    every test in it counts
# Runs $JOBS tests at a time from the top folder. Each test finds an empty folder of its own in $SCRATCH and the
# command that runs FreeFEM scripts in $BURNISH. Exit status 0 only if at least one test ran and all passed.
set -u
if [ "${1-}" != --one ]; then
  cd "$(dirname "$0")/.." || exit 1
  [ $# -gt 0 ] || { echo "error: no tests found in the folders of this suite" >&2; exit 1; }
  export BUILD="${BUILD:-$PWD/build}" PYTHON="${PYTHON:-/usr/bin/python3}" BURNISH_TOP="$PWD"
  export BURNISH="${BURNISH:-$BUILD/burnish}" TIMEOUT="${TIMEOUT:-600}" RESULTS
  mkdir -p "$BUILD/results" && RESULTS=$(mktemp -d "$BUILD/results/XXXXXX") || exit 1
  printf '%s\0' "$@" | xargs -0 -n 1 -P "${JOBS:-1}" "$0" --one
  # counted against the list, so that a test which left no result has failed
  passed=0 failed=0
  for test in "$@"; do
    read -r p f <"$RESULTS/${test//\//_}.count" || { p=0 f=1; }
    passed=$((passed + p)) failed=$((failed + f))
  done 2>/dev/null
  if [ "$failed" = 0 ]; then rm -rf "$RESULTS"; else
    echo "failed (logs in $RESULTS):"
    cat "$RESULTS"/*.failed
  fi
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ] && [ "$passed" -gt 0 ]; exit
fi

test=$2 name=${2//\//_}
log="$RESULTS/$name.log" xml="$RESULTS/$name.xml"
export SCRATCH="$RESULTS/$name.d"
mkdir -p "$SCRATCH"
note() { sed -n "1,20s|^// *$1: *||p" "$test"; } # what the script's first lines say
start=$(date +%s.%N)
passed=0 failed=0 why=
case $test in
  *.edp) read -ra options <<<"$(note options)"
         command=(env $(note environment) "$BURNISH" "$test" "${options[@]}") ;;
  *.sh)  command=(bash "$test") ;;
  *)     command=("$test" "--gtest_output=xml:$xml") ;;
esac
# the braces catch what bash itself says of a crash; --foreground lets Ctrl-C reach the test
{ timeout --foreground -k 10 "$TIMEOUT" "${command[@]}" >"$log" 2>&1 </dev/null; } 2>/dev/null
status=$?
wanted=0
case $test in
  *.edp)
    wanted=$(note 'expect exit') wanted=${wanted:-0}
    while IFS= read -r text; do
      [ -z "$text" ] || grep -qF -- "$text" "$log" || why="the output lacks: $text"
    done <<<"$(note 'expect text')" ;;
esac
[ "$status" = "$wanted" ] || why="exit status $status instead of $wanted"
[ "$status" != 124 ] || why="stopped after $TIMEOUT s"
if [ -f "$xml" ]; then # GoogleTest's own count; a crash leaves no file
  read -r total bad < <(sed -n 's/^<testsuites tests="\([0-9]*\)" failures="\([0-9]*\)" .*/\1 \2/p' "$xml")
  passed=$((total - bad)) failed=$bad
  [ "$total" -gt 0 ] || why="no test in the program"
  [ -z "$why" ] || [ "$failed" -gt 0 ] || failed=1
else
  [ -z "$why" ] && passed=1 || failed=1
fi
seconds=$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN {printf "%.1f", b - a}')
echo "$passed $failed" >"$RESULTS/$name.count"
if [ "$failed" = 0 ]; then
  count=; [ ! -f "$xml" ] || count=" ($passed tests)"
  printf 'PASS %7s s  %s%s\n' "$seconds" "${test#"$PWD"/}" "$count"
else
  echo "  $test: $why" >"$RESULTS/$name.failed"
  [ ! -f "$xml" ] || sed -i '/^\[ *\(RUN\|OK\|-*\) *\]/d' "$log" # a crash shows the test it happened in
  tail=$(tail -n 60 "$log" | sed 's/^/    | /')
  printf 'FAIL %7s s  %s: %s; its log ends:\n%s\n' "$seconds" "${test#"$PWD"/}" "$why" "$tail"
fi
