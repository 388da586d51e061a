#!/usr/bin/python3 -S
"""A program in place of burnish for the test of sweeps: fake_run.py SCRIPT [-options list | -option value ... -out FOLDER].

Options a b c, numbers, word, steps, slow (seconds; above 0.5 a run waits for the file HOLD of the environment, too). Results: bowl = (a - 2)^2 + (b - 1)^2, product = a b, sum = a + b, ishigami of a, b, c.
History: curve = a (1 - exp(-b t)), strain = t^2. c above 0.9 is refused, a run stops early where product < -1 unless -steps 400.
"""
import json
import math
import os
import sys
import time

DEFAULTS = {"out": "out", "pictures": 0, "series": 20, "check": 1, "a": 1.0, "b": 1.0, "c": 0.5, "word": "one", "steps": 10, "slow": 0.0}


def refuse(text):
    print(f"burnish: {text}")
    sys.exit(20)


def main(words):
    given = {n[1:]: v for n, v in zip(words[1::2], words[2::2])}
    options = dict(DEFAULTS)
    for name, text in given.items():
        if name not in DEFAULTS and name != "options":
            refuse(f"unknown option -{name}, expected one of {' '.join(DEFAULTS)}")
        options[name] = float(text) if isinstance(DEFAULTS.get(name), float) else text
    a, b, c = options["a"], options["b"], options["c"]
    if c > 0.9:
        refuse(f"option -c is {c:g}, expected at most 0.9")
    if given.get("options") == "list":
        print(json.dumps(options))
        return 0
    with open(os.path.join(options["out"], "ran.txt"), "a") as file:
        file.write("ran\n")
    time.sleep(options["slow"])
    while options["slow"] > 0.5 and not os.path.exists(os.environ.get("HOLD", "/")):
        time.sleep(0.05)
    early = a * b < -1 and str(options["steps"]) != "400"
    results = {"bowl": (a - 2) ** 2 + (b - 1) ** 2, "product": a * b, "sum": a + b, "ishigami": math.sin(a) + 7 * math.sin(b) ** 2 + 0.1 * c ** 4 * math.sin(a)}
    summary = {"status": "stopped early" if early else "finished", "reason": "the product is too small" if early else "", "final": {"t": 1.0, "x": a, "Q_x": 0.0},
               "counts": {"steps": 10}, "cpu_seconds": {"total": 0.5}, "results": {} if early else {n: {"value": v, "unit": "mm"} for n, v in results.items()}}
    with open(os.path.join(options["out"], "history.csv"), "w") as file:
        file.write("t,curve,strain\n")
        for k in range(101):
            t = k / 100
            file.write(f"{t},{a * (1 - math.exp(-b * t)):.12g},{t * t}\n")
    with open(os.path.join(options["out"], "summary.json"), "w") as file:
        json.dump(summary, file)
    return 10 if early else 0


sys.exit(main(sys.argv[1:]))
