#!/usr/bin/python3
"""Pictures of the U-channel: plot.py OUTDIR reads what u-channel.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], mu="mu",
              columns={"wall_angle": ("angle of the wall", "deg", 1.0), "flange_angle": ("angle of the flange", "deg", 1.0),
                       "thickness": ("thickness of the wall", "mm", 1.0), "punch_force": ("force on the punch", "N/mm", 1.0),
                       "die_force_x": ("force on the die along x", "N/mm", 1.0)}))
