#!/usr/bin/env bash
# Example 2, coarse: P2 with pictures, P1 on the mesh where roller 1 leaves no plastic strain, the printed loads; the whole
# ring under four rollers, with a gear and on P1 without, against its half.
"$PYTHON" tests/regression/case.py planetary && "$PYTHON" tests/regression/planetary_whole.py "$SCRATCH"
