"""Finds the value of one option for which a result has a given value:  make sweep CASE=rolling TARGET="depth=85" BY=R=14e-3:20e-3
  TARGET   name=value, a name of "results" or "final" of summary.json
  BY       option=first:last, the ends of the range; or option alone: from 0.8 to 1.25 times its default, wider where needed
  TOLERANCE  largest distance from the target over its size, default 1e-3
Each run is a variant of the sweep and is not repeated. Brent's method (scipy.optimize.brentq). Writes target.csv, all runs
made, and target.png. Exit status 1 if a run fails or the target is not between the
results at the ends, 2 for what cannot be run.
"""
import csv
import json
import os
import shlex
import subprocess
import sys

from gather import read_summary, row_of, why
from grid import DEFAULTS, ask_case, described, fingerprint, finished, parse_options, script_of
from values import SweepError, plain, to_number

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
WIDEST = 6  # times that a range without ends is widened


class Failed(Exception):
    """A run that did not finish, or an answer that is not there."""


class Result:
    """The result as a function of the option; a run for each value, finished ones are read."""

    def __init__(self, script, top, name, option, options):
        self.script, self.top, self.name, self.option, self.options = script, top, name, option, options
        self.mark, self.seen = fingerprint(script), {}

    def __call__(self, value):
        text = f"{value:.10g}"
        if text not in self.seen:
            self.seen[text] = self.run(text)
            print(f"  {self.option} = {text}: {self.name} = {self.seen[text]:.8g}", flush=True)
        return self.seen[text]

    def run(self, text):
        folder = f"{self.top}/{self.option}={text}"
        options = [*self.options, "-" + self.option, text]
        request = f"{self.mark} {shlex.join(options)}"
        if not finished(folder, request):
            subprocess.run(["cases/sweep/variant.sh", folder, request, os.environ["BURNISH"], self.script, *options],
                           check=False)
        summary = read_summary(folder)
        if not finished(folder, request):
            raise Failed(f"{os.path.basename(folder)} did not finish: {why(folder, summary)}; {folder}/log.txt")
        row = row_of(summary)
        if self.name not in row:
            raise SweepError(f"TARGET: no result \"{self.name}\"; there are: {', '.join(row)}")
        return float(row[self.name])


def parse_target(text):
    name, equals, value = text.rpartition("=")
    if not equals or not name.strip():
        raise SweepError(f"TARGET: \"{text}\" is not name=value, such as depth=85")
    return name.strip(), to_number(value, f"TARGET: {name.strip()}")


def ends_of(by, script):
    """(option, first, last, whether the range may be widened)"""
    option, equals, span = by.partition("=")
    if not os.access(os.environ["BURNISH"], os.X_OK):
        raise SweepError(f"{os.environ['BURNISH']} cannot be run: make build makes it")
    if not option or option in ("out", "options", *DEFAULTS):
        raise SweepError(f"BY: \"{by}\" is not an option, or option=first:last")
    if equals:
        parts = span.split(":")
        if len(parts) != 2:
            raise SweepError(f"BY: \"{span}\" is not first:last")
        first, last = (to_number(part, f"BY: {option}") for part in parts)
        if not first < last:
            raise SweepError(f"BY: {option} from {parts[0]} to {parts[1]}, expected an ascending range")
        return option, first, last, False
    listed = subprocess.run([os.environ["BURNISH"], script, "-options", "list"], stdout=subprocess.PIPE, text=True, check=False)
    try:
        default = json.loads(listed.stdout.splitlines()[-1]).get(option)
    except (IndexError, ValueError):
        default = None
    if not isinstance(default, (int, float)) or default == 0:
        raise SweepError(f"BY: {option} has no default other than zero, expected BY={option}=first:last")
    return option, min(0.8 * default, 1.25 * default), max(0.8 * default, 1.25 * default), True


def bracket(result, target, first, last, widen):
    """Ends between which the result passes the target."""
    for widened in range(WIDEST):
        a, b = result(first) - target, result(last) - target
        if a * b <= 0:
            return first, last
        if not widen or widened + 1 == WIDEST:
            break
        width = last - first
        if abs(a) < abs(b):
            first = first - width if first * (first - width) > 0 else first / 2
        else:
            last = last + width if last * (last + width) > 0 else last / 2
    raise Failed(f"{result.name} = {target:g} is not between {result(first):g} at {result.option} = {first:g} and "
                 f"{result(last):g} at {last:g}; expected another range, BY={result.option}=first:last")


def draw(result, target, unit, folder):
    from plotting.figure import RED, apply_style, new_figure, save
    apply_style()
    figure, axes = new_figure(5.6, 3.6)
    points = sorted((float(x), y) for x, y in result.seen.items())
    axes.plot(*zip(*points), "o-", markersize=4)
    axes.axhline(target, color=RED, linewidth=1, label=f"target {target:g}")
    axes.set_xlabel(f"{result.option} [{unit}]" if unit.strip("-") else result.option)
    axes.set_ylabel(result.name)
    axes.legend()
    return save(figure, folder, "target")


def main():
    try:
        from scipy.optimize import brentq
    except ImportError as error:
        raise SweepError(f"{error}; the Debian package python3-scipy is needed") from None
    case, script = script_of(os.environ.get("CASE", ""))
    name, target = parse_target(os.environ["TARGET"])
    option, first, last, widen = ends_of(os.environ.get("BY", ""), script)
    tolerance = to_number(os.environ.get("TOLERANCE") or "1e-3", "TOLERANCE")
    if not 0 < tolerance < 1:
        raise SweepError(f"TOLERANCE is {tolerance:g}, expected 0 < TOLERANCE < 1")
    options = parse_options(os.environ.get("OPTIONS", ""), {option: None}, script)
    ask_case(os.environ["BURNISH"], script, [*options, "-" + option, plain(str(first))])
    folder = f"out/sweep/{case}"
    result = Result(script, folder, name, option, options)
    print(f"{case}: {option} for {name} = {target:g}")
    low, high = bracket(result, target, first, last, widen)
    near = tolerance * (abs(target) or max(abs(result(low)), abs(result(high))))

    def distance(value):  # zero as soon as it is near enough: the method stops there
        d = result(value) - target
        return 0. if abs(d) <= near else d

    answer = brentq(distance, low, high, xtol=1e-9 * max(abs(low), abs(high)), maxiter=60)
    with open(f"{folder}/target.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([option, name])
        writer.writerows(sorted(result.seen.items(), key=lambda item: float(item[0])))
    print(draw(result, target, described(script).get(option, ("",))[0], folder))
    reached = result(answer)
    print(f"{option} = {answer:.8g}: {name} = {reached:.8g}, target {target:g}, {len(result.seen)} runs")
    if abs(reached - target) > near:
        raise Failed(f"{name} jumps over {target:g} near {option} = {answer:.8g}")


if __name__ == "__main__":
    try:
        main()
    except SweepError as error:
        print(f"sweep: {error}", file=sys.stderr)
        sys.exit(2)
    except Failed as error:
        print(f"sweep: {error}", file=sys.stderr)
        sys.exit(1)
