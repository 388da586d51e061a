#!/usr/bin/python3
"""curve.py FOLDER X Y: column Y of history.csv over its column X, as FOLDER/X-Y.png; curve.py FOLDER lists the columns."""
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

folder, *columns = sys.argv[1:]
history = np.genfromtxt(f"{folder}/history.csv", delimiter=",", names=True, deletechars="")
if not columns:
    print(*history.dtype.names)
    sys.exit(0)
x, y = columns
plt.plot(history[x], history[y], ".-")
plt.xlabel(x)
plt.ylabel(y)
plt.grid()
plt.savefig(f"{folder}/{x}-{y}.png", dpi=150)
