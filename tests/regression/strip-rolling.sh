#!/usr/bin/env bash
# Strip rolling, coarse, between two rolls and as a half strip: gripped and refused (the verdict by the case itself),
# unequal rolls; numbers against strip-rolling.json, then the runs against one another.
"$PYTHON" tests/regression/case.py strip-rolling && "$PYTHON" tests/regression/strip_rolling.py "$SCRATCH"
