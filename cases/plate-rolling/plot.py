#!/usr/bin/python3
"""Pictures of plate-rolling: plot.py OUTDIR reads what plate-rolling.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], columns={"nose": ("place of the nose", "mm", 1.0), "force1": None, "force2": None, "torque1": None, "torque2": None,
                                     "push": None}))
