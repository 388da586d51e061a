"""What cases/tables.py measures: runs of cases without pictures, in out/tables, and the cells of its tables."""
import json
import os
import re
import shlex
import subprocess
import sys


class Run:
    """One run of a case: its summary and what it printed."""

    done = {}      # (case, options): Run
    keep = False   # runs of the same options that are there are taken

    def __init__(self, case, options):
        folder = os.path.join("out/tables", case, re.sub(r"[^\w.=-]+", "_", options.strip()) or "default")
        log, mark = os.path.join(folder, "log.txt"), os.path.join(folder, "options.txt")
        if not (Run.keep and os.path.exists(mark) and open(mark).read() == options):
            os.makedirs(folder, exist_ok=True)
            burnish = os.environ.get("BURNISH", "build/burnish")
            command = [burnish, f"cases/{case}/{case}.edp", "-pictures", "0", "-out", folder, *shlex.split(options)]
            with open(log, "w", encoding="utf-8") as file:
                code = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT).returncode
            if code not in (0, 3, 4):  # 4: finished, not to be trusted
                sys.exit(f"tables.py: exit code {code} of {' '.join(command)}, see {log}")
            with open(mark, "w", encoding="utf-8") as file:
                file.write(options)
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        with open(log, encoding="utf-8", errors="replace") as file:
            self.log = file.read()
        self.final, self.counts = self.summary["final"], self.summary["counts"]
        self.finished, self.ep = self.summary["status"] == "finished", self.final["plastic_strain_eq_max"]
        self.steps, self.factorizations = self.counts["steps"], self.counts["factorizations"]
        self.nodes, self.t = self.summary["mesh"]["nodes"], self.final["t"]
        self.cpu = brief(self.summary["cpu_seconds"]["total"])
        print(f"{case} {options}: {self.summary['status']}, {self.cpu} s CPU", flush=True)

    def result(self, name):
        return self.summary["results"][name]["value"]

    def stopped(self):
        return "" if self.finished else f"stops at t = {self.t:.3f}"


def run(case, options=""):
    if (case, options) not in Run.done:
        Run.done[case, options] = Run(case, options)
    return Run.done[case, options]


def brief(x):
    """Two digits: 0.42, 6.0, 38, 109."""
    return f"{x:.0f}" if x >= 10 else f"{x:.1f}" if x >= 1 else f"{x:.2f}"


def strain(x):
    return "0" if x == 0 else f"{x:.4f}" if x >= 1e-3 else f"{x:.5f}"


def off(x, y):
    """Difference of x from y in per cent."""
    return f"{brief(100 * abs(x / y - 1))} %"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(c) for c in line) + " |" for line in lines)
