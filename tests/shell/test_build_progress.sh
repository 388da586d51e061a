#!/usr/bin/env bash
# What make says while it builds (.ci/build, .ci/said): how much is to be done, counted before, and the seconds that are left; nothing of it
# where nothing is to be done.
set -u
failures=0
report() { echo "FAILED: $*"; failures=$((failures + 1)); }
folder=$SCRATCH/build
mkdir -p "$folder"
cat >"$SCRATCH/Makefile" <<END
all: $folder/a $folder/b $folder/c $folder/d
$folder/flags $folder/sources:
	@touch \$@
$folder/%:
	@.ci/said $folder "compile \$*"
	@sleep 1; touch \$@
END
build() { .ci/build "$folder" make -s -f "$SCRATCH/Makefile" -- all >"$SCRATCH/said.txt" 2>&1; }
# said NUMBER LINE: that line of the last build
said() { grep -qxE "$2" <(sed -n "$1p" "$SCRATCH/said.txt") || { report "line $1 is not $2"; cat "$SCRATCH/said.txt"; }; }
build || report "exit status $?"
said 1 '\[1/4\] compile a'
said 2 '\[2/4\] compile b'
said 3 '\[3/4\] compile c, about [1-9] s left'
said 4 '\[4/4\] compile d, about [1-9] s left'
rm "$folder/c"
build || report "once more: exit status $?"
said 1 '\[1/1\] compile c'
build || report "nothing to do: exit status $?"
[ ! -s "$SCRATCH/said.txt" ] || report "nothing to do, but something is said"
rm "$folder/progress"
[ "$(.ci/said "$folder" "link x")" = "link x" ] || report "without a count"
echo "$failures failed"
[ "$failures" = 0 ]
