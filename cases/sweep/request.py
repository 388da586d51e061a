"""What burnish sweep is asked for: script, varied options, options of all variants, settings, goal.

  SCRIPT.edp              a script that ends with rcCaseEnd and reads its options as cases do (edp/cases/rcCaseOptions.idp)
  name=values             what is varied, values.py
  -name value             options of the script for all variants, and these settings of the sweep:
    -study NAME           folder out/sweep/NAME of the current folder; default: the script's name, NAME-2, ... for other requests
    -again 1              variants that failed run once more; -again "-steps 400": with these options besides
    -jobs 4               runs at a time, default one for each core
    -samples 20 -seed 1   points of first:last:random and first:last:latin, trajectories of first:last:morris
    -ssh host1,host2      other machines, ":" is this one: ssh without a password, GNU parallel here, and there the same folders
                          under the same paths (a network folder) with the same system
    -draw "depth;turn"    pictures sweep.png and cost.png of these results, beside the page (plot.py); commas do where no name has one
  target= minimize= maximize= where= measured= within=     goals for unknowns name=first:last, goal.py
Every error is a SweepError.
"""
import glob
import hashlib
import json
import os
import re
import shlex
import subprocess
from types import SimpleNamespace

from values import DRAWN, SweepError, parse_vary, to_number, whole

# what every variant gets unless it is asked for: no pictures of its own, one field file (that pictures in space are drawn from)
DEFAULTS = {"pictures": "0", "series": "1", "check": "0"}
SETTINGS = {"study": "", "again": "", "jobs": "", "samples": "20", "seed": "1", "ssh": "", "draw": ""}
GOALS = ("target", "minimize", "maximize", "where", "measured", "within")
BY_SWEEP = ("out", "options", "resume")


def read_text(path):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def script_files(script):
    """The script and what lies beside it that it may include."""
    return sorted({script, *glob.glob(os.path.join(glob.escape(os.path.dirname(script) or "."), "*.idp"))})


def fingerprint(script):
    """Of the script and what lies beside it."""
    digest = hashlib.sha256()
    for path in script_files(script):
        with open(path, "rb") as file:
            digest.update(file.read())
    return digest.hexdigest()[:16]


def checked_script(words):
    scripts = [w for w in words if w.endswith(".edp") and "=" not in w]
    if len(scripts) != 1:
        raise SweepError(f"{len(scripts)} scripts among the words, expected one file that ends in .edp")
    if not os.path.isfile(scripts[0]):
        raise SweepError(f"no script \"{scripts[0]}\" that can be read")
    if "rcCaseEnd" not in read_text(scripts[0]):
        raise SweepError(f"{scripts[0]} has no rcCaseEnd, which writes what a sweep compares. Two lines make a case of it: "
                         "rcCase(C, M, u[], S, program, record) in the place of rcRun, and behind it rcCaseEnd(C, M, S); "
                         "before them, for options: rcCaseOptions(\"NAME\"); rcOptionsEnd();")
    return scripts[0]


def sorted_words(words, script):
    """Words -> (name=values, {goal: text}, {option of the script: text}, settings)"""
    vary, goals, options, settings = [], {}, {}, dict(SETTINGS)
    waiting = iter([w for w in words if w != script])
    for word in waiting:
        if word.startswith("-"):
            value = next(waiting, None)
            if value is None:
                raise SweepError(f"{word} has no value")
            (settings if word[1:] in settings else options)[word[1:]] = value  # the last one counts, as in a run
        elif word.partition("=")[0] in GOALS and "=" in word:
            name, _, text = word.partition("=")
            if name in goals:
                raise SweepError(f"{name}= is given twice")
            goals[name] = text
        else:
            vary.append(word)
    return vary, goals, options, settings


def described(script):
    """{option: (unit, meaning)} as the scripts tell: rcReal("-R", 1, "mm", "radius")."""
    top = os.environ.get("BURNISH_TOP", ".")
    text = read_text(os.path.join(top, "edp", "cases", "rcCaseOptions.idp")) + "".join(map(read_text, script_files(script)))
    found = re.findall(r'rc(?:Real|Int|Text)\("-(\w+)",[^"]*(?:"[^"]*",\s*)?"([^"]*)",\s*"([^"]*)"\)', text)
    return {name: (unit.strip("-"), meaning) for name, unit, meaning in found}


def asked(script, options):
    """{option: default} of a script that reads these options; its own message if it refuses them."""
    burnish = os.environ["BURNISH"]
    if not os.access(burnish, os.X_OK):
        raise SweepError(f"{burnish} cannot be run: make build makes it")
    done = subprocess.run([burnish, script, *words_of(options), "-options", "list"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", stdin=subprocess.DEVNULL)
    lines = [line for line in done.stdout.splitlines() if line.strip()]
    try:
        return json.loads(lines[-1])
    except (IndexError, ValueError):
        told = [line for line in lines if line.startswith("burnish:")] or lines[-5:]
        raise SweepError("\n".join(told) or f"{burnish} ends with exit code {done.returncode}") from None


def checked_again(again, vary):
    """ -again takes options of the script that are not varied."""
    for name in again or {}:
        if name in (*BY_SWEEP, *SETTINGS, *vary):
            raise SweepError(f"-again: -{name} is " + ("varied" if name in vary else "none of the script that a variant may have")
                             + ", expected options of the script, such as \"-steps 400\"")
    return again


def words_of(options):
    return [word for name, value in options.items() for word in ("-" + name, value)]


def again_options(text):
    """ -again: None, {} for once more, or the options besides."""
    if text in ("", "0"):
        return None
    if text == "1":
        return {}
    words = shlex.split(text)
    if len(words) % 2 or any(not n.startswith("-") for n in words[::2]):
        raise SweepError(f"-again: \"{text}\", expected 1 or options of the script, such as \"-steps 400\"")
    return {n[1:]: v for n, v in zip(words[::2], words[1::2])}


def read_request(words):
    """@returns script, name, mark, vary, options, again, goals, settings"""
    script = checked_script(words)
    varied, goals, options, settings = sorted_words(words, script)
    for name in BY_SWEEP:
        if name in options:
            raise SweepError(f"-{name} is set by the sweep")
    vary = parse_vary(varied, (*BY_SWEEP, *SETTINGS, *DEFAULTS))
    if not vary:
        raise SweepError("nothing is varied, expected for example R=10:20:5 mu=0.1,0.2")
    for name in vary:
        if name in options:
            raise SweepError(f"-{name} is given, and {name} is varied")
    unknown = [n for n, v in vary.items() if v[0] == "unknown"]
    if goals and len(unknown) != len(vary):
        other = next(n for n in vary if n not in unknown)
        raise SweepError(f"{other}: with {next(iter(goals))}= every varied option is an unknown, expected {other}=first:last")
    if unknown and not goals:
        raise SweepError(f"{unknown[0]}: first:last is an unknown, expected a goal besides, such as target=\"depth=0.1\", or first:last:number")
    if not re.fullmatch(r"[A-Za-z0-9_.+-]*", settings["study"]) or settings["study"].startswith("."):
        raise SweepError(f"-study is \"{settings['study']}\", expected letters, digits, dashes")
    drawn = any(v[0] in DRAWN for v in vary.values())
    return SimpleNamespace(
        script=script, name=os.path.basename(script)[:-len(".edp")], mark=fingerprint(script), vary=vary, varied=varied, goals=goals,
        options=options, study=settings["study"], again=checked_again(again_options(settings["again"]), vary), ssh=settings["ssh"], draw=settings["draw"],
        jobs=whole(settings["jobs"] or str(os.cpu_count()), "-jobs", 1, 10000),
        samples=whole(settings["samples"], "-samples", 2, 10000) if drawn else 0,
        seed=whole(settings["seed"], "-seed", 0, 2 ** 31) if drawn else 0,
        within=to_number(goals.get("within", "1e-3"), "within"))


def asks(request):
    """What makes two requests the same study, as {what: text}."""
    return {"script's text": request.mark, "variation": shlex.join(request.varied), "options": shlex.join(words_of(request.options)),
            "samples": f"{request.samples}, seed {request.seed}", "goal": json.dumps(request.goals, sort_keys=True)}
