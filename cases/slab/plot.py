#!/usr/bin/python3
"""Pictures of slab: plot.py OUTDIR reads what slab.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], columns={"depth": ("depth", "mm", 1.0)}))
