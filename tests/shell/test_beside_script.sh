#!/usr/bin/env bash
# A file that a script names without a folder is looked for in the working folder, then beside the script, from whatever folder it is run;
# rcScriptFolder(0) ends with its slash.
set -u
failures=0
report() { echo "FAILED: $*"; cat "$SCRATCH/log.txt"; failures=$((failures + 1)); }
mkdir -p "$SCRATCH/scripts" "$SCRATCH/elsewhere" "$SCRATCH/empty"
# wheel FOLDER RADIUS: its drawing; block FOLDER WIDTH
wheel() {
  printf 'Point(1) = {0, 0, 0}; Point(2) = {%s, 0, 0}; Point(3) = {-%s, 0, 0}; Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 2};\n' "$2" "$2" >"$1/wheel.geo"
}
block() {
  printf 'SetFactory("OpenCASCADE"); Rectangle(1) = {0, 0, 0, %s, 1}; Physical Surface(1) = {1}; Physical Curve(1) = {1, 2, 3, 4};\n' "$2" >"$1/block.geo"
}
wheel "$SCRATCH/scripts" 2
block "$SCRATCH/scripts" 3
cat >"$SCRATCH/scripts/scene.edp" <<'END'
include "burnish.idp"
include "rcGmsh.idp"
tool wheel(cad="wheel.geo", name="wheel"); wheel.coordinates("cartesian");
mesh Th = rcGmsh("block.geo", "", rcText("-made", ""));
real[int] x = wheel.outlinex(4);
cout << "radius " << x.max << " area " << Th.area << " folder \"" << rcScriptFolder(0) << "\"" << endl;
END
# run FOLDER SCRIPT WORDS: what a script says that is run in a folder
run() {
  (cd "$1" && "$BURNISH" "$2" -made "$SCRATCH/block") >"$SCRATCH/log.txt" 2>&1 || report "$2 in $1: exit status $?"
  grep -qxF "$3" "$SCRATCH/log.txt" || report "$2 in $1: expected $3"
}
run "$SCRATCH/scripts" scene.edp 'radius 2 area 3 folder "./"'
run "$SCRATCH/empty" ../scripts/scene.edp 'radius 2 area 3 folder "../scripts/"'
run "$SCRATCH/empty" "$SCRATCH/scripts/scene.edp" "radius 2 area 3 folder \"$SCRATCH/scripts/\""
wheel "$SCRATCH/elsewhere" 5
block "$SCRATCH/elsewhere" 7
run "$SCRATCH/elsewhere" ../scripts/scene.edp 'radius 5 area 7 folder "../scripts/"'

# a path is one from the working folder
sed -i 's#"wheel.geo"#"./wheel.geo"#' "$SCRATCH/scripts/scene.edp"
(cd "$SCRATCH/empty" && "$BURNISH" ../scripts/scene.edp) >"$SCRATCH/log.txt" 2>&1
[ $? = 20 ] && grep -qF 'tool: "./wheel.geo" does not exist, seen from folder' "$SCRATCH/log.txt" || report "a path: not refused"

echo "$failures failed"
[ "$failures" = 0 ]
