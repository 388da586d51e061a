#!/usr/bin/python3
"""Pictures of any scene: scene.py OUTDIR [PICTURE|movie] reads what rcCase wrote there and puts PNG files beside it.

rcCaseEnd runs it for final.png alone; without a name it draws all of plotting/case.py, for a script without a plot.py. Units are those that
the script says by rcUnits. A picture is left out where its files are missing.
"""
import os
import sys

sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # cases
try:
    from plotting.case import DEFAULT, draw
    from plotting.inputs import MissingInput
    from plotting.run import Run
except ImportError as error:
    sys.exit(f"scene.py: {error}; the Debian packages python3-matplotlib, python3-numpy and python3-meshio are needed")


def read_scene(folder):
    run = Run(folder)
    if not any(run.has(name) for name in Run.FILES):
        raise MissingInput(f"{folder}: none of {', '.join(Run.FILES)}")
    return run


if __name__ == "__main__":
    sys.exit(draw(sys.argv[1:], read_scene, DEFAULT, patient=True))
