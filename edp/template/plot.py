#!/usr/bin/python3
"""Pictures of NAME with its units: plot.py OUTDIR reads what NAME.edp wrote there and puts PNG files beside it.

Without this file the pictures say "length" and "stress". More of them: functions of the run that return a figure, pictures=[...], as
in Burnish's cases/indentation/plot.py.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.environ["BURNISH_TOP"], "cases"))
from plotting.case import main

sys.exit(main(sys.argv[1:], length="mm",       # forces in N/mm (axisymmetric: N), stresses in MPa
              columns={"depth_mm": ("depth", "mm", 1.0), "width_mm": ("contact width", "mm", 1.0)}))
