#!/usr/bin/env bash
# Options of the rolling case, its output folder and FreeFEM's own refusals: each bad command ends with its exit code and
# a message that names what is wrong; nothing is computed.
set -u
failures=0
# refuse CODE "words|more words" COMMAND...
refuse() {
  local code=$1 words=$2 output status word
  shift 2
  output=$(timeout 60 "$@" 2>&1 </dev/null)
  status=$?
  if [ "$status" != "$code" ]; then
    echo "FAILED: exit status $status instead of $code: $*"; head -n 20 <<<"$output"; failures=$((failures + 1)); return
  fi
  while IFS= read -r word; do
    grep -qF -- "$word" <<<"$output" && continue
    echo "FAILED: the output of $* lacks \"$word\":"; head -n 20 <<<"$output"; failures=$((failures + 1)); return
  done <<<"${words//|/$'\n'}"
  grep -F 'burnish:' <<<"$output" | head -n 1
}
rolling() { local code=$1 words=$2; shift 2; refuse "$code" "$words" "$BURNISH" cases/rolling/rolling.edp -out "$SCRATCH/r" "$@"; }

rolling 20 'unknown option -muu|expected one of|-mu ' -muu 0.2
rolling 20 'unknown option stray|expected one of' stray
rolling 20 'option -mu has no value' -mu
rolling 20 'option -mu has no value' -mu ''
rolling 20 'option -element has no value' -element
rolling 20 'option -mu has the value "high"|expected a number' -mu high
rolling 20 'option -mu has the value "0.2x"|expected a number' -mu 0.2x
rolling 20 'option -mu has the value "-outer"|expected a number' -mu -outer 30
rolling 20 'option -inner has the value "4.5"|expected a whole number' -inner 4.5
rolling 20 'option -element is "P3"|expected P1 or P2' -element P3
rolling 20 'option -scheme is "magic"|expected implicit, event or article' -scheme magic
rolling 20 'option -pictures is 3|expected 0 to 2' -pictures 3
printf 'include "burnish.idp"\nreal h = 2,\n  tool = 1;\n' >"$SCRATCH/name.edp"
refuse 20 'name.edp: tool in line 3 is the name of a type of Burnish|such as tool1' "$BURNISH" "$SCRATCH/name.edp"
printf 'include "burnish.idp"\nfunc real material(real x) { return x; }\n' >"$SCRATCH/name.edp"
refuse 20 'name.edp: material in line 2 is the name of a type of Burnish|such as material1' "$BURNISH" "$SCRATCH/name.edp"
printf 'include "burnish.idp"\nmesh Th = square(2, 2);\nfespace Vh(Th, P1);\nVh u, contact = x;\n' >"$SCRATCH/name.edp"
refuse 20 'name.edp: contact in line 4 is the name of a type of Burnish|such as contact1' "$BURNISH" "$SCRATCH/name.edp"
printf 'include "burnish.idp"\ncout << "LET THROUGH" << endl;\n' >"$SCRATCH/none.edp"
refuse 20 'option -mu is given|none.edp reads no options|then rcOptionsEnd()' "$BURNISH" "$SCRATCH/none.edp" -mu 0.3
refuse 20 'option -h is given|none.edp does not list its options' "$BURNISH" "$SCRATCH/none.edp" -h
"$BURNISH" "$SCRATCH/none.edp" -mu 0.3 | grep -q 'LET THROUGH' && { echo "FAILED: ran with an option that nothing reads"; failures=$((failures + 1)); }
printf 'include "burnish.idp"\nreal mu = rcReal("-mu", 0.1);\n' >"$SCRATCH/open.edp"
refuse 20 'unknown option -nu, expected one of -mu|it was ignored|no rcOptionsEnd()' "$BURNISH" "$SCRATCH/open.edp" -mu 0.2 -nu 0.3
printf 'include "burnish.idp"\ninclude "getARGV.idp"\ncout << getARGV("-mu", 0.1) << endl;\n' >"$SCRATCH/argv.edp"
printf 'include "burnish.idp"\nstepcontrol S(1.);\n' >"$SCRATCH/plain.edp" # its settings need no reader
for words in "none.edp -v 0 -ns" "open.edp -mu 0.2" "argv.edp -mu 0.2" "plain.edp -dtmax 0.1"; do
  "$BURNISH" "$SCRATCH/"$words >"$SCRATCH/out" 2>&1 || { echo "FAILED: $words"; head -n 5 "$SCRATCH/out"; failures=$((failures + 1)); }
done
rolling 20 'option -steps is 0|expected 1 to 1e+06' -steps 0
rolling 20 'option -inner is 1|expected 2 to' -inner 1
rolling 20 'option -graded is -1|expected 0 to 0.0012' -graded -1
refuse 20 'pure rates are solved once and need frictiontangent="consistent"' "$BURNISH" cases/rolling/rolling.edp -out "$SCRATCH/late" -inner 3 -outer 16 -sides 3 -pictures 0 -scheme article -frictiontangent lagged
shear() { refuse 20 "$1" "$BURNISH" cases/shear/shear.edp -out "$SCRATCH/r" "${@:2}"; }
for option in element scheme tolerance series forms assembly solver model; do
  shear "option -$option is given, but the script does not use it|occurs nowhere in cases/shear/shear.edp" -$option 1
done
refuse 20 'option -steps is given, but the script does not use it: rcLeastSteps' "$BURNISH" cases/rolling-contact/rolling-contact.edp -steps 10
[ ! -e "$SCRATCH/r" ] || { echo "FAILED: a refused run made its output folder"; failures=$((failures + 1)); }
small=(-element P1 -inner 4 -outer 20 -sides 4 -pictures 0)
rolling 20 'nu = 0.5|-1 < nu < 0.5' "${small[@]}" -nu 0.5
rolling 20 'sigY = -1|> 0' "${small[@]}" -sigY -1
rolling 20 'sigY = 0|> 0' "${small[@]}" -sigY 0
rolling 20 'mu = -0.2|mu >= 0' "${small[@]}" -mu -0.2
rolling 20 'unknown update "best"' "${small[@]}" -update best
rolling 20 'option -tolerance is 0|> 0' -tolerance 0
rolling 20 'option -tolerance is 0.1|0 to 0.01' -tolerance 0.1
rolling 20 'unknown option -muu|expected one of' -muu 0.9 -foo x.edp
rolling 20 'option -R is -1|> 0' "${small[@]}" -R -1
rolling 20 'the output folder "/dev/null/x" cannot be written|Not a directory' "${small[@]}" -out /dev/null/x
touch "$SCRATCH/file"
rolling 20 'the output folder "'"$SCRATCH"'/file" cannot be written|Not a directory' "${small[@]}" -out "$SCRATCH/file"
refuse 20 'no script|does-not-exist.edp|that can be read' "$BURNISH" "$SCRATCH/does-not-exist.edp"
refuse 20 'no script among the words "-mu 0.2"|usage: burnish SCRIPT.edp' "$BURNISH" -mu 0.2
refuse 20 'usage: burnish SCRIPT.edp' "$BURNISH"
"$BURNISH" -h | grep -q 'usage: burnish SCRIPT.edp' || { echo "FAILED: burnish -h has no usage"; failures=$((failures + 1)); }

# what FreeFEM itself refuses, with its own exit codes, before anything reaches the plugin
cat >"$SCRATCH/method.edp" <<'END'
include "burnish.idp"
tool t(circle=1);
t.fly(3);
END
refuse 1 'fly' "$BURNISH" "$SCRATCH/method.edp"
cat >"$SCRATCH/named.edp" <<'END'
include "burnish.idp"
tool t(circle=1, shade=2);
END
refuse 20 'unknown named parameter shade=|expected one of' "$BURNISH" "$SCRATCH/named.edp"
cat >"$SCRATCH/typed.edp" <<'END'
include "burnish.idp"
mesh Th = square(1, 1);
fespace Vh(Th, [P1, P1]);
contact C = rcContact(Vh, labels=6);
END
refuse 20 'named parameter labels= is of type int, expected int[int]' "$BURNISH" "$SCRATCH/typed.edp"
sed 's/labels=6/labels=[3, 4]/' "$SCRATCH/typed.edp" >"$SCRATCH/listed.edp"
refuse 20 'expected int[int]: int[int] list = [...]; before, and labels=list' "$BURNISH" "$SCRATCH/listed.edp"
sed 's/labels=6/label="top"/' "$SCRATCH/typed.edp" >"$SCRATCH/worded.edp"
refuse 20 'named parameter label= is of type string, expected int' "$BURNISH" "$SCRATCH/worded.edp"
cat >"$SCRATCH/shell.edp" <<'END'
include "burnish.idp"
load "msh3"
meshS Th = square3(1, 1);
fespace Vh(Th, P1);
material M = rcMaterial(Vh, G=1, nu=0.3, sigY=1, H=0);
END
refuse 20 'rcMaterial: arguments (fespace on a surface), expected (fespace) or (fespace in space)' "$BURNISH" "$SCRATCH/shell.edp"
# an uncaught error of ours: text once, line, exit code 20
cat >"$SCRATCH/uncaught.edp" <<'END'
include "burnish.idp"
cout << "before" << endl;
tool t(circle=-1);
cout << "after" << endl;
END
refuse 20 'before|current line = 3|burnish: tool: radius = -1, expected a finite number > 0' "$BURNISH" "$SCRATCH/uncaught.edp"
[ "$("$BURNISH" "$SCRATCH/uncaught.edp" | grep -c radius)" = 1 ] || { echo "FAILED: text not once"; failures=$((failures + 1)); }

# meshes with inverted triangles: whatever way in, FreeFEM says so and stops
cat >"$SCRATCH/inverted.msh" <<'END'
4 2 4
0 0 1
1 0 1
1 1 1
0 1 1
1 2 3 0
1 4 3 0
1 2 1
2 3 2
3 4 3
4 1 4
END
cat >"$SCRATCH/gmsh.msh" <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
6
1 1 2 1 1 1 2
2 1 2 2 2 2 3
3 1 2 3 3 3 4
4 1 2 4 4 4 1
5 2 2 1 1 1 2 3
6 2 2 1 1 1 4 3
$EndElements
END
material='fespace Vh(Th, [P1, P1]); material M = rcMaterial(Vh, G=1, nu=0.3, sigY=1, H=0); cout << "LET THROUGH" << endl;'
{ echo 'include "burnish.idp"'; echo "mesh Th = readmesh(\"$SCRATCH/inverted.msh\");"; echo "$material"; } >"$SCRATCH/read.edp"
refuse 5 'area of triangle < 0|Triangle 1' "$BURNISH" "$SCRATCH/read.edp"
{ echo 'include "burnish.idp"'; echo 'load "gmsh"'; echo "mesh Th = gmshload(\"$SCRATCH/gmsh.msh\");"; echo "$material"; } >"$SCRATCH/load.edp"
refuse 6 'area > 0' "$BURNISH" "$SCRATCH/load.edp"
{ echo 'include "burnish.idp"'; echo 'mesh Tq = square(2, 2);'
  echo 'mesh Th = movemesh(Tq, [x + 1.2*(x > 0.4 && x < 0.6 && y > 0.4 && y < 0.6), y]);'; echo "$material"; } >"$SCRATCH/move.edp"
refuse 8 'triangles was reverse' "$BURNISH" "$SCRATCH/move.edp"

echo "$failures failed"
[ "$failures" = 0 ]
