"""A study: the folder out/sweep/NAME with study.json (what was asked for, parameters, variants) and a folder for each variant.

A study belongs to one request: script's text, variation, options, goal. The same request goes on with what is missing. Another one
gets a study of its own, NAME-2, ..., and where -study names a folder that is taken, an error that says what differs. Nothing that a
run has left is overwritten, but by -again. A variant that a study of the same script and options beside it has finished is copied.
"""
import fcntl
import json
import os
import shutil

from request import DEFAULTS, asked, asks, described, read_text, words_of
from values import SweepError, combinations

TOP = os.path.join("out", "sweep")
LONGEST = 200  # letters of a folder's name
MOST_STUDIES = 1000


class Study:
    """folder, name, request; variants: {folder's name: {option: text}} in order; runs: a variant's options, where it lies, how it ended."""

    def __init__(self, request):
        self.request = request
        first = {n: v[0] if isinstance(v, list) else f"{0.5 * (v[1] + v[2]):.10g}" for n, v in request.vary.items()}
        has = options_of(request, first)
        if "out" not in has:
            raise SweepError(f"{request.script} has no option -out, by which each variant gets a folder of its own, expected rcCaseOptions(\"{request.name}\");"
                             " before rcOptionsEnd();")
        self.options = {**{n: v for n, v in DEFAULTS.items() if n in has}, **request.options}
        self.resume = {"resume": "1"} if "resume" in has else {}
        self.parameters = parameters_of(request)
        self.variants = {}
        self.name, self.folder = "", ""  # by open

    def add(self, values):
        """@returns the name of the variant with these values"""
        name = ",".join(f"{k}={v}" for k, v in values.items())
        if len(name) > LONGEST:
            raise SweepError(f"the folder's name {name} is too long")
        self.variants[name] = values
        return name

    def open(self):
        """Makes or finds the folder, which is this process's from now on, with the variants that are listed; a goal adds its own."""
        os.makedirs(TOP, exist_ok=True)
        with open(os.path.join(TOP, ".lock"), "w", encoding="utf-8") as names:  # two sweeps that begin together do not take one name
            fcntl.flock(names, fcntl.LOCK_EX)
            self.name = place(self.request)
            self.folder = os.path.join(TOP, self.name)
            os.makedirs(self.folder, exist_ok=True)
            if not asks_of(self.folder):
                self.write()
        self.hold()
        if not self.request.goals:
            for values in combinations(self.request.vary, self.request.samples, self.request.seed):
                self.add(values)
        self.write()

    def hold(self):
        """The study is this process's until it and its runs have ended; waits for those of another one."""
        lock = os.open(os.path.join(self.folder, ".lock"), os.O_RDWR | os.O_CREAT, 0o644)
        os.set_inheritable(lock, True)  # runs of a sweep that was killed hold it on
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            print(f"burnish sweep: waits for runs of another sweep in {self.folder}", flush=True)
            fcntl.flock(lock, fcntl.LOCK_EX)

    def write(self):
        path = os.path.join(self.folder, "study.json")
        with open(path + ".new", "w", encoding="utf-8") as file:
            json.dump({"name": self.name, "script": self.request.script, "asks": asks(self.request), "parameters": self.parameters,
                       "variants": [{"folder": n, "values": v} for n, v in self.variants.items()]}, file, indent=1)
        os.replace(path + ".new", path)

    def place_of(self, name):
        return os.path.join(self.folder, name)

    def words(self, name):
        """Options of a variant, of one that is tried again with those of -again."""
        again = read_again(self.place_of(name))
        return words_of({**self.options, **self.resume, **again, **self.variants[name]})

    def missing(self):
        return [name for name in self.variants if not ended(self.place_of(name))]

    def try_again(self):
        """The failed variants are removed, to be run with the options of -again besides. @returns how many"""
        failed = [n for n in stored(self.folder) if ended(self.place_of(n)) and not finished(self.place_of(n))]
        options = {n: {**read_again(self.place_of(n)), **self.request.again} for n in failed}
        if self.request.again:
            self.require_possible(options)
        for name in failed:
            shutil.rmtree(self.place_of(name))
            os.makedirs(self.place_of(name))
            with open(os.path.join(self.place_of(name), "again.json"), "w", encoding="utf-8") as file:
                json.dump(options[name], file)
        return len(failed)

    def require_possible(self, options):
        """Refuses options of -again that the script refuses for every variant that failed, and before one is removed."""
        told = None
        for name, again in options.items():
            try:
                asked(self.request.script, {**self.options, **again, **values_of(name)})
                return
            except SweepError as error:
                told = told or error
        if told:
            raise SweepError(f"-again: {told}")

    def adopt(self):
        """Copies missing variants that a study with the same script and options beside it has finished. @returns how many"""
        found, mine = 0, asks(self.request)
        for other in sorted(os.listdir(TOP)):
            theirs = asks_of(os.path.join(TOP, other))
            if other == self.name or any(theirs.get(k) != mine[k] for k in ("script's text", "options")):
                continue
            for name in self.missing():
                source = os.path.join(TOP, other, name)
                if finished(source) and not read_again(source):
                    shutil.rmtree(self.place_of(name), ignore_errors=True)
                    shutil.copytree(source, self.place_of(name) + ".new", dirs_exist_ok=True)
                    os.rename(self.place_of(name) + ".new", self.place_of(name))
                    found += 1
        return found


def options_of(request, first):
    """{option: default} of the script; refused if it does not know what is varied. A value that it refuses is a variant that fails."""
    try:
        return asked(request.script, {**request.options, **first})
    except SweepError:
        has = asked(request.script, request.options)
        for name in [n for n in first if n not in has]:
            asked(request.script, {**request.options, name: first[name]})
        return has


def place(request):
    """Name of the study of this request, one that is there or a new one."""
    mine = asks(request)
    for number in range(1, MOST_STUDIES):
        name = request.study or request.name + (f"-{number}" if number > 1 else "")
        folder = os.path.join(TOP, name)
        if not os.path.isdir(folder) or not os.listdir(folder):
            return name
        theirs = asks_of(folder)
        if theirs == mine:
            return name
        if request.study:
            if not theirs:
                raise SweepError(f"-study {name}: {folder} is there and no study of a sweep; expected another name")
            other = "; ".join(f"{k} {theirs.get(k)!r}, here {mine[k]!r}" for k in mine if theirs.get(k) != mine[k])
            raise SweepError(f"-study {name} is there already with another request: {other}. Expected another name, or remove {folder}")
    raise SweepError(f"{MOST_STUDIES} studies of {request.name} in {TOP}, expected -study NAME")


def asks_of(folder):
    try:
        return json.loads(read_text(os.path.join(folder, "study.json"))).get("asks", {})
    except (ValueError, AttributeError):
        return {}


def parameters_of(request):
    units, found = described(request.script), []
    for name, values in request.vary.items():
        unit, meaning = units.get(name, ("", ""))
        spacing = "log" if any(w.startswith(name + "=") and w.endswith(":log") for w in request.varied) else ""
        ends = [] if isinstance(values, list) else list(values[1:])
        found.append({"name": name, "unit": unit, "meaning": meaning, "spacing": spacing, "ends": ends})
    return found


def values_of(name):
    """Values of a variant from its folder's name, as add made it."""
    return dict(pair.split("=", 1) for pair in name.split(","))


def stored(folder):
    """Names of the variants that have a folder."""
    return sorted(n for n in os.listdir(folder) if "=" in n and os.path.isdir(os.path.join(folder, n)))


def read_again(folder):
    """Options of a variant that was tried again; empty for others."""
    try:
        return json.loads(read_text(os.path.join(folder, "again.json")))
    except ValueError:
        return {}


def ended(folder):
    """Whether the run has ended by itself, well or not."""
    return read_text(os.path.join(folder, "exit.txt")).strip() != ""


def finished(folder):
    """Whether it came to its end."""
    try:
        done = json.loads(read_text(os.path.join(folder, "summary.json")))["status"] == "finished"
    except (ValueError, KeyError, TypeError):
        return False
    return done and read_text(os.path.join(folder, "exit.txt")).strip() == "0"
