#!/usr/bin/env bash
# OpenCASCADE is opened for CAD files only, gmsh for .geo files only, from the libraries beside the plugin; nothing stays behind,
# whatever happens.
set -eu
plugins="$BUILD/plugins"
fail() { echo "$*"; exit 1; }

for linked in "$plugins/burnish.so"; do
  ! ldd "$linked" | grep -qE "libgmsh|libTK" || fail "$linked is linked with gmsh or OpenCASCADE"
done

# what a script has in its process
cat >"$SCRATCH/empty.edp" <<'END'
include "burnish.idp"
load "shell"
tool t(cad="tests/support/cad/lobe.step");
int maps = exec("grep -c libgmsh /proc/$PPID/maps");
tool g(cad="tests/support/cad/lobe.geo");
maps = exec("grep -c libgmsh /proc/$PPID/maps");
END
"$BURNISH" "$SCRATCH/empty.edp" >"$SCRATCH/maps.txt"
read -r -d '' before after _ <"$SCRATCH/maps.txt" || true
[ "$before" = 0 ] || fail "gmsh is there before a .geo file is read: $before"
[ "$after" -gt 0 ] || fail "gmsh is not there after a .geo file was read"

# no library: a clear error
mkdir -p "$SCRATCH/alone"
cp "$plugins/burnish.so" "$plugins/burnish_cad.so" "$SCRATCH/alone"
cat >"$SCRATCH/geo.edp" <<'END'
include "burnish.idp"
tool t(cad="tests/support/cad/lobe.step");
tool g(cad="tests/support/cad/lobe.geo");
END
status=0
sed "s|$plugins|$SCRATCH/alone|" "$BURNISH" >"$SCRATCH/alone/burnish"
chmod +x "$SCRATCH/alone/burnish"
"$SCRATCH/alone/burnish" "$SCRATCH/geo.edp" >"$SCRATCH/alone.txt" 2>&1 || status=$?
cat "$SCRATCH/alone.txt"
[ "$status" = 20 ] || fail "exit status $status instead of 20"
grep -q "tool: gmsh.s library cannot be opened: .*libgmsh-dev has it" "$SCRATCH/alone.txt" || fail "no clear message"
rm "$SCRATCH/alone/burnish_cad.so" && status=0
"$SCRATCH/alone/burnish" "$SCRATCH/geo.edp" >"$SCRATCH/alone.txt" 2>&1 || status=$?
[ "$status" = 20 ] || fail "without burnish_cad.so: exit status $status instead of 20"
grep -q "OpenCASCADE.s library cannot be opened: .*libocct-data-exchange-dev has it" "$SCRATCH/alone.txt" || fail "no clear message: $(cat "$SCRATCH/alone.txt")"

# temporary files: of files that are read, refused, and that break gmsh down
mkdir -p "$SCRATCH/tmp"
printf 'SetFactory("OpenCASCADE");\nFor i In {1:9}\n Point(i) = {Sqrt(-i), i, 0};\nEndFor\nSpline(1) = {1:9};\n' >"$SCRATCH/breaks.geo"
printf 'Point(1) = {0, 0, 0;\n' >"$SCRATCH/syntax.geo"
cat >"$SCRATCH/temporary.edp" <<END
include "burnish.idp"
tool g(cad="tests/support/cad/punch.geo", geo="R=1");
mesh Th = rcGmsh("cases/step-die/block.geo", "W=9", "$SCRATCH/made");
try { tool b(cad="$SCRATCH/breaks.geo"); } catch(...) { cout << "refused" << endl; }
try { tool b(cad="$SCRATCH/syntax.geo"); } catch(...) { cout << "refused" << endl; }
try { tool b(cad="tests/support/cad/punch.geo", geo="H=1; R=70"); } catch(...) { cout << "refused" << endl; }
try { Th = rcGmsh("$SCRATCH/breaks.geo", "", "$SCRATCH/broken"); } catch(...) { cout << "refused" << endl; }
try { Th = rcGmsh("cases/step-die/die.geo", "W=70", "$SCRATCH/broken"); } catch(...) { cout << "refused" << endl; }
END
TMPDIR="$SCRATCH/tmp" "$BURNISH" "$SCRATCH/temporary.edp" >"$SCRATCH/temporary.txt"
[ "$(grep -c refused "$SCRATCH/temporary.txt")" = 5 ] || fail "not all were refused: $(cat "$SCRATCH/temporary.txt")"
left=$(ls -A "$SCRATCH/tmp")
[ -z "$left" ] || fail "left behind: $left"
[ ! -e "$SCRATCH/broken.msh" ] || fail "a mesh of a failed run"
