"""What the notebooks of the labs share: the run behind a cell, its answers, its tables, its picture.

  lab = Lab("1-contact")             results come into out/notebook/1-contact
  lab.run(n=8)                       the lab's script with -n 8, printed from its answers on; RunError with the reason if it fails
  lab.run("danger.edp", folder="P1", nu=0.49)     another script, into a folder of its own
  lab.answers(), lab.table("study.csv"), lab.picture()
The script is lab.edp, to be filled in; the environment's LAB_SOLUTION=1 fills it by the key (the test does), see solve.py.
"""
import csv
import os
import subprocess
from pathlib import Path

TOP = Path(os.environ.get("BURNISH_TOP") or Path(__file__).resolve().parents[2])
BURNISH = os.environ.get("BURNISH") or str(TOP / "build/burnish")
SHOWN = ("answer:", "error of pressure", "predicted:", "locks here")      # lines of a run that a cell prints


class RunError(Exception):
    """A run that did not end well; the text is its own reason."""

    def _render_traceback_(self):
        return [f"The run did not end well: {self}"]


class Lab:
    def __init__(self, name):
        self.source, self.out = TOP / "cases/labs" / name, Path(os.environ.get("LAB_OUT") or TOP / "out/notebook") / name

    def run(self, script="lab.edp", folder="", status=0, **options):
        """Runs, prints what follows the warnings; the output. status: the exit status that is expected."""
        file = self.source / script
        if os.environ.get("LAB_SOLUTION"):
            import solve
            solve.write(self.source, self.out / "solved")
            file = self.out / "solved" / solve.name(script)
        words = [BURNISH, str(file), "-out", str(self.out / folder)]
        words += [word for name, value in options.items() for word in ("-" + name, f"{value}")]
        done = subprocess.run(words, cwd=TOP, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        lines = done.stdout.splitlines()
        said = [line for line in lines if line.startswith("burnish: ") and not line.endswith(":")]
        if done.returncode != status:
            raise RunError(said[-1] if said else f"exit status {done.returncode}: " + "\n".join(lines[-5:]))
        print("\n".join(line for line in lines if any(word in line for word in SHOWN)))
        return done.stdout

    def answers(self, folder=""):
        """{name: value} of answers.csv"""
        with open(self.out / folder / "answers.csv", encoding="utf-8") as file:
            return {row["name"]: float(row["value"]) for row in csv.DictReader(file)}

    def table(self, file):
        """Rows of a CSV file, numbers where they are."""
        def number(text):
            try:
                return float(text)
            except ValueError:
                return text
        with open(self.out / file, encoding="utf-8") as rows:
            return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(rows)]

    def picture(self):
        """The lab's figure, drawn by its plot.py."""
        from IPython.display import Image
        file = self.out / "plot.png"
        done = subprocess.run(["/usr/bin/python3", str(self.source / "plot.py"), str(self.out), str(file)], cwd=TOP,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            raise RunError(done.stdout.strip())
        return Image(filename=str(file))


def compare(predictions, answers):
    """A line for each prediction beside what was computed."""
    for name, predicted in predictions.items():
        print(f"{name}: predicted {'nothing' if predicted is None else predicted}, computed {answers[name]:.5g}")
