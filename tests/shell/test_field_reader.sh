#!/usr/bin/env bash
# The reader of field files (cases/plotting/vtu.py) on a file of savevtk: what it reads, and its errors for broken files.
set -eu
cat >"$SCRATCH/field.edp" <<'END'
load "iovtk"
mesh Th = square(6, 4, [3*x, y]);
fespace Ph(Th, P1);
Ph a = 2*x, b = 3*y, c = x + y;
int[int] order = [1, 1], lower = [0, 1];
savevtk(ARGV[ARGV.n - 1] + "/good.vtu", Th, [a, b, 0], c, dataname="displacement stress_eq", order=order, bin=true);
savevtk(ARGV[ARGV.n - 1] + "/element.vtu", Th, c, c, dataname="stress_eq plastic_strain_eq", order=lower, bin=true);
END
"$BURNISH" "$SCRATCH/field.edp" "$SCRATCH" >"$SCRATCH/log.txt" 2>&1 || { cat "$SCRATCH/log.txt"; exit 1; }
"$PYTHON" tests/shell/field_reader.py "$SCRATCH"
