"""The variants of a sweep. From the environment CASE, VARY and OPTIONS, with BURNISH, makes out/sweep/CASE/:
  sweep.json    parameters in order, with units and meanings, and the variants: folder, values, options
  commands.txt  one shell command for each variant that is not finished yet
and prints how many there are. Exit status 2 and a line on stderr for what cannot be run.
"""
import glob
import hashlib
import itertools
import json
import math
import os
import re
import shlex
import subprocess
import sys

# what every variant gets unless OPTIONS says otherwise: numbers only, no pictures, no field files on the way
DEFAULTS = {"pictures": "0", "series": "0", "check": "0"}
WORD = re.compile(r"[A-Za-z0-9_.+-]+")


class SweepError(Exception):
    """What is wrong with the request."""


def to_number(text, where):
    try:
        return float(text)
    except ValueError:
        raise SweepError(f"{where}: \"{text}\" is not a number") from None


def spaced(text, where):
    """first:last:number -> the values as texts."""
    parts = text.split(":")
    if len(parts) != 3:
        raise SweepError(f"{where}: \"{text}\" has {len(parts)} parts, expected first:last:number")
    first, last = to_number(parts[0], where), to_number(parts[1], where)
    number = to_number(parts[2], where)
    if number != int(number) or not 2 <= number <= 10000:
        raise SweepError(f"{where}: \"{parts[2]}\" values, expected a whole number from 2 to 10000")
    count = int(number)
    return [f"{first + (last - first) * i / (count - 1):.10g}" for i in range(count)]


def plain(text):
    """Numbers in one way of writing, so that 14e-3 and 0.014 are the same variant; words as they are."""
    try:
        value = float(text)
    except ValueError:
        return text
    return f"{value:.10g}" if math.isfinite(value) else text


def parse_vary(text):
    """ "R=1:2:3 mu=0.1,0.2" -> {"R": ["1", "1.5", "2"], "mu": ["0.1", "0.2"]} """
    vary = {}
    for part in text.split():
        name, equals, values = part.partition("=")
        if not equals or not name or not values:
            raise SweepError(f"VARY: \"{part}\" is not name=values, such as R=10e-3:20e-3:5 or mu=0.1,0.2")
        where = f"VARY: {name}"
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9]*", name):
            raise SweepError(f"VARY: \"{name}\" is not the name of an option (without its dash)")
        if name in vary:
            raise SweepError(f"{where} is given twice")
        if name in ("out", "options", *DEFAULTS):
            raise SweepError(f"{where} cannot be varied")
        listed = spaced(values, where) if ":" in values else [plain(v) for v in values.split(",")]
        for value in listed:
            if not WORD.fullmatch(value):
                raise SweepError(f"{where}: \"{value}\" is not a value, expected numbers or words with commas")
        if len(set(listed)) != len(listed):
            raise SweepError(f"{where} has a value twice: {', '.join(listed)}")
        vary[name] = listed
    if not vary:
        raise SweepError('VARY is empty, expected for example VARY="R=10e-3:20e-3:5 mu=0.1,0.2"')
    return vary


def parse_options(text, vary):
    """Fixed options "-a 1 -b x" -> list of words with the defaults first."""
    try:
        words = shlex.split(text)
    except ValueError as error:
        raise SweepError(f"OPTIONS: {error}") from None
    names = words[::2]
    if len(words) % 2 or any(not n.startswith("-") for n in names):
        raise SweepError(f"OPTIONS: \"{text}\" is not a list of -name value")
    for name in names:
        if name in ("-out", "-options"):
            raise SweepError(f"OPTIONS: {name} is set by the sweep")
        if name[1:] in vary:
            raise SweepError(f"OPTIONS: {name} is varied by VARY")
    defaults = [w for n, v in DEFAULTS.items() if "-" + n not in names for w in ("-" + n, v)]
    return defaults + words


def described(script):
    """{option: (unit, meaning)} as the comments of the script tell: real R = rcReal("-R", 1);  // mm  radius."""
    with open(script, encoding="utf-8") as file:
        found = re.findall(r'rc(?:Real|Int)\("-(\w+)"[^/\n]*//\s*(\S+)\s{2,}([^\n]*)', file.read())
    return {name: (unit, meaning.strip()) for name, unit, meaning in found}


def ask_case(burnish, script, options):
    """Lets the case read the options; its own message if it refuses them."""
    done = subprocess.run([burnish, script, *options, "-options", "list"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", stdin=subprocess.DEVNULL)
    if done.returncode:
        lines = done.stdout.splitlines()
        told = [line for line in lines if line.startswith("burnish:")]
        raise SweepError("\n".join(told or lines[-5:]) or f"{burnish} ends with exit code {done.returncode}")


def fingerprint(case):
    """Of the case's scripts: a variant of another script is not finished."""
    digest = hashlib.sha256()
    for path in sorted(glob.glob(f"cases/{case}/*.edp") + glob.glob(f"cases/{case}/*.idp")):
        with open(path, "rb") as file:
            digest.update(file.read())
    return digest.hexdigest()[:16]


def read_text(path):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def finished(folder, request):
    """Whether the folder holds the finished run of exactly this request."""
    try:
        done = json.loads(read_text(f"{folder}/summary.json"))["status"] == "finished"
    except (ValueError, KeyError, TypeError):
        return False
    code, asked = (read_text(f"{folder}/{name}.txt").strip() for name in ("exit", "request"))
    return done and code == "0" and asked == request


def variants(vary, options, top):
    """One dict for each combination, the first parameter slowest."""
    for values in itertools.product(*vary.values()):
        chosen = dict(zip(vary, values))
        folder = f"{top}/" + ",".join(f"{k}={v}" for k, v in chosen.items())
        if len(os.path.basename(folder)) > 200:
            raise SweepError(f"VARY: the folder name {os.path.basename(folder)} is too long")
        yield {"folder": folder, "values": chosen,
               "options": [*options, *(w for k, v in chosen.items() for w in ("-" + k, v))]}


def main():
    case, burnish = os.environ.get("CASE", ""), os.environ["BURNISH"]
    script, top = f"cases/{case}/{case}.edp", f"out/sweep/{case}"
    if not case or "/" in case or not os.path.isfile(script):
        known = sorted(os.path.basename(os.path.dirname(p)) for p in glob.glob("cases/*/*.edp"))
        raise SweepError(f"CASE: no case \"{case}\"; there are: {' '.join(known)}")
    vary = parse_vary(os.environ.get("VARY", ""))
    listed = list(variants(vary, parse_options(os.environ.get("OPTIONS", ""), vary), top))
    ask_case(burnish, script, listed[0]["options"])
    units = described(script)
    os.makedirs(top, exist_ok=True)
    with open(f"{top}/sweep.json", "w", encoding="utf-8") as file:
        json.dump({"case": case, "parameters": [{"name": n, "unit": units.get(n, ("", ""))[0],
                                                 "meaning": units.get(n, ("", ""))[1]} for n in vary],
                   "variants": listed}, file, indent=1)
    mark, waiting = fingerprint(case), 0
    with open(f"{top}/commands.txt", "w", encoding="utf-8") as file:
        for v in listed:
            request = f"{mark} {shlex.join(v['options'])}"
            if finished(v["folder"], request):
                continue
            waiting += 1
            command = ["cases/sweep/variant.sh", v["folder"], request, burnish, script, *v["options"]]
            file.write(shlex.join(command) + "\n")
    done = len(listed) - waiting
    print(f"{case}: {len(listed)} variants" + (f", {done} finished before" if done else ""))


if __name__ == "__main__":
    try:
        main()
    except SweepError as error:
        print(f"sweep: {error}", file=sys.stderr)
        sys.exit(2)
