#!/usr/bin/python3
"""Pictures of any scene: scene.py OUTDIR [PICTURE|movie] reads what rcCase wrote there and puts PNG files beside it.

scene.py - PICTURE space|plane reads its libraries, then the folder as a line of the standard input; without a line it draws nothing
(rcPictureSoon).

rcCaseEnd runs it for final.png alone; without a name it draws all of plotting/case.py, for a script without a plot.py. Units are those that
the script says by rcUnits. A picture is left out where its files are missing.
"""
import importlib
import os
import signal
import sys

signal.signal(signal.SIGINT, signal.SIG_DFL)  # stop quietly
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


def awaited(arguments):
    """The words of the command, the folder from the standard input."""
    try:
        importlib.import_module("plotting.space.case" if arguments.pop() == "space" else "meshio")
    except ImportError:
        pass  # who reads the files says it
    folder = sys.stdin.readline().rstrip("\n")
    return [folder, *arguments[1:]] if folder else sys.exit()


if __name__ == "__main__":
    given = sys.argv[1:]
    sys.exit(draw(awaited(given) if given[:1] == ["-"] else given, read_scene, DEFAULT, patient=True))
