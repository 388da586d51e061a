#!/usr/bin/python3
"""Pictures of the roller under a spring: plot.py OUTDIR reads what spring-roller.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main

sys.exit(main(sys.argv[1:], mu="mu",
              columns={"rise": ("rise", "mm", 1.0), "spring_force": ("force of the spring", "N/mm", 1.0), "drag": ("drag", "N/mm", 1.0)}))
