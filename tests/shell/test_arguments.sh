#!/usr/bin/env bash
# Positional arguments that a function, a method or a constructor of ours does not take: both lists of types in words of scripts, exit status 20.
set -u
failures=0
cat >"$SCRATCH/head.edp" <<'END'
include "burnish.idp"
mesh Th = square(2, 2); fespace Vh(Th, [P1, P1]); Vh [u, v] = [0, 0];
real[int] R(1);
tool roller(circle=1.);
END
# wrong CALL "what was given" "what is allowed"
wrong() {
  local log
  { cat "$SCRATCH/head.edp"; printf '%s\n' "$1"; } >"$SCRATCH/wrong.edp"
  log=$("$BURNISH" "$SCRATCH/wrong.edp" 2>&1 </dev/null)
  [ $? = 20 ] && grep -qF "burnish: $2, expected $3" <<<"$log" && ! grep -q 'N7burnish' <<<"$log" && return
  echo "FAILED: $1 does not say \"$2, expected $3\" with exit status 20:"
  tail -n 5 <<<"$log"
  failures=$((failures + 1))
}
wrong 'roller.place("x", "y");' 'tool.place: arguments (string, string)' '(string, real)'
wrong 'roller.place("x");' 'tool.place: arguments (string)' '(string, real)'
wrong 'material M = rcMaterial(Th, E=1., nu=0.3);' 'rcMaterial: arguments (mesh)' '(fespace) or (fespace in space)'
wrong 'contact C = rcContact(3, label=3);' 'rcContact: arguments (int)' '(fespace) or (fespace in space)'
wrong 'contact C = rcContact(Vh, label=3); C.add("roller");' 'contact.add: arguments (string)' '(tool)'
wrong 'contact C = rcContact(Vh, label=3); C.approach(roller, "y", u);' 'contact.approach: arguments (tool, string, finite element function)' '(tool, string, real[int])'
wrong 'real r = rcReal(3, "-R");' 'rcReal: arguments (int, string)' '(string, real'
wrong 'stepcontrol S("1");' 'stepcontrol: arguments (string)' '(real)'
wrong 'tool t = 3;' 'tool: arguments (int)' '()'
# what needs conversions still finds its overload: int for real, words in quotes, arrays for their numbers
cat >>"$SCRATCH/head.edp" <<'END'
roller.coordinates("cartesian"); roller.place("x", 1);
stepcontrol S(1);
contact C = rcContact(Vh, label=3, fixed=u[]);
C.add(roller);
if (rcReal("-number", 1) != 1 || roller.value("x") != 1) exit(1);
END
"$BURNISH" "$SCRATCH/head.edp" >"$SCRATCH/right.log" 2>&1 </dev/null || { echo "FAILED: right arguments"; tail -n 5 "$SCRATCH/right.log"; failures=$((failures + 1)); }
[ "$failures" = 0 ]
