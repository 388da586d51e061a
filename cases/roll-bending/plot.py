#!/usr/bin/python3
"""Pictures of roll bending: plot.py OUTDIR reads what roll-bending.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], mu="mu", without=("pressure",),
              columns={"bend_angle": ("direction of the straight end", "deg", 1.0), "wrapped": ("angle of the form touched", "deg", 1.0),
                       "moment": ("moment of winding", "N", 1.0), "roll_force": ("force of the roll", "N/mm", 1.0)}))
