#!/usr/bin/env bash
# The files for ParaView, read and warped by VTK (Debian's python3-vtk9): tests/viewers/paraview.py.
set -eu
"$BURNISH" tests/support/press.edp -out "$SCRATCH/run" -pictures 0 >"$SCRATCH/log.txt" 2>&1 || { cat "$SCRATCH/log.txt"; exit 1; }
"$BURNISH" cases/damage/damage.edp -n 2 -element P1 -steps 20 -out "$SCRATCH/damage" -pictures 0 -check 0 -series 2 \
  >"$SCRATCH/damage.txt" 2>&1 || [ $? = 4 ] || { cat "$SCRATCH/damage.txt"; exit 1; }
"$PYTHON" tests/viewers/paraview.py "$SCRATCH"
