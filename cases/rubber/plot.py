#!/usr/bin/python3
"""Pictures of the rubber block: plot.py OUTDIR reads what rubber.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], mu="mu",
              columns={"work": ("work of the drives", "N", 1.0), "energy": ("energy of the block", "N", 1.0)}))
