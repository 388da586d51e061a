#!/usr/bin/python3
"""Pictures of NAME, for -pictures 2: plot.py OUTDIR reads what NAME.edp wrote there and puts PNG files beside it.

Units of mesh, stresses and forces are those of rcUnits in NAME.edp; here are those of its own columns. More pictures: functions of the run that return a figure, pictures=[...], as
in Burnish's cases/indentation/plot.py.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.environ["BURNISH_TOP"], "cases"))
from plotting.case import main

sys.exit(main(sys.argv[1:],
              columns={"depth_mm": ("depth", "mm", 1.0), "width_mm": ("contact width", "mm", 1.0)}))
