"""The variants of a sweep. From the environment CASE, VARY and OPTIONS, with BURNISH, makes out/sweep/CASE/:
  sweep.json    parameters in order, with units and meanings, and the variants: folder, values, options
  commands.txt  one shell command for each variant that is not finished yet
and prints how many there are. Exit status 2 and a line on stderr for what cannot be run. CASE is the name of a case, or the
path of a script that reads its options as cases do (edp/cases/rcCaseOptions.idp). Ways to write VARY: values.py.
"""
import glob
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys

from values import SweepError, combinations, parse_vary

# what every variant gets unless OPTIONS says otherwise: numbers only, no pictures, no field files on the way
DEFAULTS = {"pictures": "0", "series": "0", "check": "0"}


def script_of(case):
    """(name, path of the script) of a case's name or of a script's path."""
    if case.endswith(".edp") and os.path.isfile(case):
        if "rcCaseEnd" not in read_text(case):
            raise SweepError(f"CASE: {case} has no rcCaseEnd, which writes what a sweep compares; see edp/cases/rcCase.idp")
        return os.path.basename(case)[:-len(".edp")], case
    script = f"cases/{case}/{case}.edp"
    if not case or "/" in case or not os.path.isfile(script):
        known = sorted(os.path.basename(os.path.dirname(p)) for p in glob.glob("cases/*/*.edp"))
        raise SweepError(f"CASE: no case \"{case}\"; there are: {' '.join(known)}, or the path of a script .edp")
    return case, script


def parse_options(text, vary, script):
    """Fixed options "-a 1 -b x" -> list of words, first the defaults of those that the script has."""
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
    known = has(script)
    defaults = [w for n, v in DEFAULTS.items() if "-" + n not in names and n in known for w in ("-" + n, v)]
    return defaults + words


def has(script):
    """Names of the options that a script has; those that it refuses as they stand are told by ask_case."""
    done = subprocess.run([os.environ["BURNISH"], script, "-options", "list"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", stdin=subprocess.DEVNULL)
    return re.findall(r'"-?(\w+)":', done.stdout) if done.returncode == 0 else [*DEFAULTS]


def case_name():
    return script_of(os.environ["CASE"])[0]


def described(script):
    """{option: (unit, meaning)} as the scripts tell: rcReal("-R", 1, "mm", "radius")."""
    text = read_text(os.path.join("edp", "cases", "rcCaseOptions.idp")) + read_text(script)
    found = re.findall(r'rc(?:Real|Int|Text)\("-(\w+)",[^"]*(?:"[^"]*",\s*)?"([^"]*)",\s*"([^"]*)"\)', text)
    return {name: (unit, meaning) for name, unit, meaning in found}


def ask_case(burnish, script, options):
    """Lets the case read the options; its own message if it refuses them."""
    if not os.access(burnish, os.X_OK):
        raise SweepError(f"{burnish} cannot be run: make build makes it")
    done = subprocess.run([burnish, script, *options, "-options", "list"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", stdin=subprocess.DEVNULL)
    if done.returncode:
        lines = done.stdout.splitlines()
        told = [line for line in lines if line.startswith("burnish:")]
        raise SweepError("\n".join(told or lines[-5:]) or f"{burnish} ends with exit code {done.returncode}")


def fingerprint(script):
    """Of the script and what lies beside it: a variant of another script is not finished."""
    digest = hashlib.sha256()
    for path in sorted({script, *glob.glob(os.path.join(os.path.dirname(script) or ".", "*.idp"))}):
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
    for chosen in combinations(vary):
        folder = f"{top}/" + ",".join(f"{k}={v}" for k, v in chosen.items())
        if len(os.path.basename(folder)) > 200:
            raise SweepError(f"VARY: the folder name {os.path.basename(folder)} is too long")
        yield {"folder": folder, "values": chosen,
               "options": [*options, *(w for k, v in chosen.items() for w in ("-" + k, v))]}


def write_variants(top, case, script, vary, listed):
    """sweep.json and commands.txt. @returns the number of variants that wait for their run"""
    units = described(script)
    os.makedirs(top, exist_ok=True)
    with open(f"{top}/sweep.json", "w", encoding="utf-8") as file:
        json.dump({"case": case, "parameters": [{"name": n, "unit": units.get(n, ("", ""))[0],
                                                 "meaning": units.get(n, ("", ""))[1]} for n in vary],
                   "variants": listed}, file, indent=1)
    mark, waiting = fingerprint(script), 0
    with open(f"{top}/commands.txt", "w", encoding="utf-8") as file:
        for v in listed:
            request = f"{mark} {shlex.join(v['options'])}"
            if finished(v["folder"], request):
                continue
            waiting += 1
            command = ["cases/sweep/variant.sh", v["folder"], request, os.environ["BURNISH"], script, *v["options"]]
            file.write(shlex.join(command) + "\n")
    return waiting


def main():
    case, script = script_of(os.environ.get("CASE", ""))
    top = f"out/sweep/{case}"
    vary = parse_vary(os.environ.get("VARY", ""), ("out", "options", *DEFAULTS))
    listed = list(variants(vary, parse_options(os.environ.get("OPTIONS", ""), vary, script), top))
    ask_case(os.environ["BURNISH"], script, listed[0]["options"])
    done = len(listed) - write_variants(top, case, script, vary, listed)
    print(f"{case}: {len(listed)} variants" + (f", {done} finished before" if done else ""))


if __name__ == "__main__":
    try:
        main()
    except SweepError as error:
        print(f"sweep: {error}", file=sys.stderr)
        sys.exit(2)
