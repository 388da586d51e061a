"""Holds the reference (edp/manual/reference) against the loaded plugin, the sources and the files of a run.

    reference.py TOP CALLABLES OPTIONS FOLDER...
        TOP        the project
        CALLABLES  what rcCallables(0) printed
        OPTIONS    what cases/rolling printed with -options list
        FOLDER     results of a run: summary.json, *.csv, final.vtu

Prints what is missing, superfluous or wrong; exit status 1 if there is anything.
"""
import csv
import json
import re
import sys
from pathlib import Path

TOP = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(TOP / "edp/manual/reference"))
import sources  # noqa: E402
import topics  # noqa: E402
from settings import read_settings  # noqa: E402

TABLES = ("history.csv", "events.csv", "surface.csv", "tools.csv")
FIELDS = {"fields.vtu": "final.vtu", "surface.vtp": "surface-0.vtp", "tools.vtp": "tools-0.vtp", "supports.vtp": "supports.vtp"}


def read(path):
    return Path(path).read_text(encoding="utf-8")


def literals():
    """All texts of the sources, those that the compiler joins joined, quotes as they are printed."""
    texts = []
    for pattern in ("cxx/**/*.?pp", "plugins/*.?pp", "edp/**/*.idp"):
        for path in TOP.glob(pattern):
            code = re.sub(r"^ *//.*$", "", read(path), flags=re.M)
            joined = re.sub(r'"\s*\n\s*"', "", code)
            texts += re.findall(r'"((?:[^"\\\n]|\\.)*)"', joined)
    return "\n".join(texts).replace('\\"', '"')


class Checker:
    def __init__(self, callables):
        self.reference = topics.read_reference(TOP)
        self.wrong, self.callables = [], callables
        self.internal = {name: head.path for head in self.reference.heads for name in head.internal}

    def fail(self, text):
        self.wrong.append(text)

    def check_callables(self):
        """The stored list is that of the plugin."""
        settings = {one.callable for one in read_settings(TOP)}
        stored, loaded = settings | set(read(TOP / "edp/manual/reference/callables.txt").split("\n")), set(self.callables.split("\n"))
        for line in sorted(loaded - stored):
            self.fail(f"callables.txt lacks \"{line}\" of the loaded plugin")
        for line in sorted(stored - loaded):
            self.fail(f"the loaded plugin lacks \"{line}\" of callables.txt or settings.cpp")

    def check_covered(self):
        """Everything callable has an entry, every entry is of something callable."""
        covered = {id(one) for topic in self.reference.topics.values() for use in topic.uses for one in use.overloads}
        for one in self.reference.calls:
            if id(one) not in covered and one.kind != "type" and one.name not in self.internal:
                self.fail(f"no entry for {one.kind} {one.name}({', '.join(one.types)}){' of ' + one.path if one.path else ''}")
        names = {one.name for one in self.reference.calls}
        for name, path in self.internal.items():
            if name not in names:
                self.fail(f"{path}: internal name {name} does not occur")
            if name in self.reference.topics:
                self.fail(f"{path}: {name} is internal and has an entry")
        for key, topic in self.reference.topics.items():
            for use in topic.uses:
                if not use.overloads and topic.kind not in topics.FREE:
                    self.fail(f"{use.entry.place}: nothing callable is {use.signature.text}")

    def check_parameters(self):
        for key, topic in self.reference.topics.items():
            lines = [line.name for use in topic.uses for line in use.entry.parameters if line.name.endswith("=")]
            for name in topic.named.keys() - set(lines):
                self.fail(f"{key}: no line for the parameter {name}")
            for use in topic.uses:
                self.check_use(topic, use)
            for name in set(lines) - topic.named.keys():
                self.fail(f"{key}: there is no parameter {name}")
        for key in self.reference.named.keys() - self.reference.topics.keys():
            self.fail(f"no entry for {key}, which has named parameters")

    def check_use(self, topic, use):
        place, arguments = use.entry.place, use.signature.arguments or []
        if not use.entry.meaning or use.entry.excess:
            self.fail(f"{place}: {use.signature.text} has no meaning, or more than four fields")
        for one in use.overloads:
            if one.arguments is not None and one.arguments != arguments:
                self.fail(f"{place}: arguments {arguments}, declared {one.arguments}")
        for name in arguments:
            line = topics.explained(self.reference, use, name)
            if line is None or not line.meaning:
                self.fail(f"{place}: argument {name} of {use.signature.text} is not explained")
        own = {name for other in use.entry.signatures for name in other.arguments or []}
        for line in use.entry.parameters:
            if not line.name.endswith("=") and line.name not in own:
                self.fail(f"{place}: {line.name} is no argument of {use.entry.name}")
            if line.excess or not line.meaning:
                self.fail(f"{place}: {line.name} has no meaning, or more than four fields")
            if line.name.endswith("=") and not line.default and not line.range:
                self.fail(f"{place}: {line.name} has neither default nor range")

    def check_errors(self):
        """The words of every error occur in the sources."""
        texts = literals()
        for topic in self.reference.topics.values():
            for use in topic.uses:
                for error in use.entry.errors:
                    for part in error.split("..."):
                        if part.strip() not in texts:
                            self.fail(f"{use.entry.place}: no source says \"{part.strip()}\"")

    def check_defaults(self):
        """Defaults of named parameters are those of the calls that read them; test_names.sh compares those of settings."""
        table = defaults_of_calls()
        checked = 0
        for (key, name), value in table.items():
            for use in self.reference.topics[key].uses if key in self.reference.topics else []:
                for line in use.entry.parameters:
                    if line.name == name:
                        checked += 1
                        if plain(line.default) != plain(value):
                            self.fail(f"{key} {name} has the default {line.default}, in the code {value}")
        if checked < 15:
            self.fail(f"only {checked} defaults were compared")

    def check_options(self, printed):
        """A case's options and defaults are those that it lists itself."""
        listed = {("-" + key): value for key, value in json.loads(printed).items() if key != "options"}
        options = {one.name: one for one in self.reference.common + self.reference.cases["rolling"]}
        for name in listed.keys() ^ options.keys():
            self.fail(f"option {name}: in one of the reference and cases/rolling/rolling.edp only")
        for name in listed.keys() & options.keys():
            default = topics.default_of(options[name], self.reference, "rolling")
            if re.match(r'"|-?[\d.]', default) and plain(default) != plain(json.dumps(listed[name])):
                self.fail(f"option {name}: default {default}, the case says {listed[name]}")

    def entries_of(self, file):
        return {key.split(" ", 1)[1] for key, topic in self.reference.topics.items() if topic.kind == file}

    def compare(self, file, found):
        """Names found in a file against its entries; <tool> and the like stand for any name."""
        entries = self.entries_of(file)
        for name in found:
            if name not in entries and not any(fits(entry, name) for entry in entries if "<" in entry):
                self.fail(f"no entry for {file} {name}")
        return entries - set(found)

    def check_tables(self, folders):
        """Columns that the runs wrote; coordinates are those of the summary."""
        for name in TABLES:
            columns = set()
            for folder in folders:
                if name == "tools.csv" and not (folder / name).exists():  # none in space
                    continue
                coordinates = {key[2:] for key in json.loads(read(folder / "summary.json"))["final"] if key.startswith("Q_")}
                with open(folder / name, encoding="utf-8") as stream:
                    columns |= set(fixed(name, next(csv.reader(stream)))) - (coordinates if name == "history.csv" else set())
            for column in self.compare(name, sorted(columns)):
                if "<" not in column:
                    self.fail(f"{name} has no column {column}")

    def check_fields(self, folders):
        """Fields that the runs wrote for ParaView; one that no run had is one of the writer at least."""
        writer = read(TOP / "cxx/output/workpiece_file.cpp") + read(TOP / "cxx/output/contact_files.cpp")
        for kind, file in FIELDS.items():
            names = set()
            for folder in folders:
                found = re.findall(rb'DataArray[^>]*Name="(\w+)"', (folder / file).read_bytes())
                names |= {one.decode() for one in found} - {"connectivity", "offsets", "types", "Points"}
            for name in self.compare(kind, sorted(names)):
                tensor = re.sub("_(xx|yy|zz|xy|yz|zx)$", "", name)  # its components are named by PointTraits
                if f'"{tensor}"' not in writer:
                    self.fail(f"{kind}: no field {name} is written")

    def check_summary(self, folders):
        keys = {key for folder in folders for key in flat(json.loads(read(folder / "summary.json")))}
        writers = ("edp/cases/rcSummary.idp", "edp/cases/rcCase.idp", "edp/cases/rcResults.idp", "cxx/output/summary.cpp", "plugins/summary.cpp")
        writer = "".join(read(TOP / file) for file in writers)
        for name in self.compare("summary.json", sorted(keys)):
            last = re.split(r"\.|\[\]", name)[-1]
            if "<" not in last and last and f'"{last}"' not in writer:
                self.fail(f"summary.json: no key {name} is written")

    def check_kinds(self):
        """Kinds of events, exit statuses and functions of formulas are those of the code."""
        tape = read(TOP / "cxx/formula/formula_tape.cpp")
        known = set(re.findall(r'\{"(\w+)", \w', tape)) - {"conjugate", "real_part", "imag_part"}
        known |= set(re.findall(r'"(\w+)"', tape.split("std::vector<std::string> list{")[1].split("}")[0]))
        known = known - {"csgn"} | {"sign"}   # GiNaC's name of it
        listed = {name.split("(")[0] for name in self.entries_of("formula") if "(" in name}
        for name in known ^ (listed - {"sqrt", "pow"}) - {"sqrt", "pow"}:
            self.fail(f"formula {name}: in one of cxx/formula/formula_tape.cpp and the reference only")
        names = read(TOP / "cxx/contact/events.cpp").split("NAMES[] = {")[1].split("}")[0]
        named = set(re.findall(r'"([\w-]+)"', names))
        for name in named ^ self.entries_of("event"):
            self.fail(f"event {name}: in one of cxx/contact/events.cpp and the reference only")
        state = read(TOP / "edp/run/rcRunState.idp").split("func int rcExitStatus")[1].split("\n}")[0]
        statuses = {int(one) for one in re.findall(r"(?:return|\?) (\d+)", state)} | {5, 20}
        for status in statuses ^ {int(one) for one in self.entries_of("exit")}:
            self.fail(f"exit {status}: in one of rcExitStatus and the reference only")


def fixed(table, columns):
    """The columns that a script cannot choose: those of the history's own end with the moments of the tools."""
    moments = [k for k, name in enumerate(columns) if name.endswith("_Mz")]
    return columns[:moments[-1] + 1] if table == "history.csv" else columns


def fits(entry, name):
    pattern = "".join(".+" if part.startswith("<") else re.escape(part) for part in re.split(r"(<\w+>)", entry))
    return re.fullmatch(pattern, name) and entry not in ("<coordinate>", "<column>")


def flat(value, prefix=""):
    """Keys of the summary with the way to them: final.t, checks[].value."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from flat(inner, f"{prefix}.{key}" if prefix else key)
    elif isinstance(value, list) and value and isinstance(value[0], dict):
        for inner in value:
            yield from flat(inner, prefix + "[]")
    elif isinstance(value, list) and prefix == "warnings":
        yield prefix + "[]"
    elif value == []:  # no findings: its keys are not known
        return
    else:
        yield prefix


def plain(text):
    text = text.strip().strip('"')
    try:
        return float(text)
    except ValueError:
        return text.lower()


def defaults_of_calls():
    """Defaults where a named parameter is read: a.boolean("tied", false), with constants of the file in place."""
    owner = {"contact_type": "rcContact", "contact_matrix": "contact.condense", "contact_step": None,
             "material_type": "rcMaterial"}
    found = {}
    for path in sorted((TOP / "plugins").glob("*.cpp")):
        code = read(path)
        for name, value in re.findall(r'\ba\.(?:real|integer|boolean|text)\("(\w+)", ("?[\w.-]+"?)[,)]', code):
            if re.match(r"(options|input)\b", value):
                continue
            constant = re.search(rf"\b{re.escape(value)} = ([\w.-]+)", code)
            value = constant[1] if constant else value
            key = owner.get(path.stem, {"integrity": "material.damage", "steps": "material.damage"}.get(name))
            methods = {"tolerance": "contact.events", "until": "contact.events", "events": "contact.begin",
                       "kind": "material.tangent", "blend": "material.tangent"}
            key = methods.get(name, key) if path.stem in ("contact_step", "material_type") else key
            if key and not (name in ("label", "internal") or value == "default"):
                found[(key, name + "=")] = value
    return found


def main():
    checker = Checker(read(sys.argv[2]).strip() + "\n")
    folders = [Path(one) for one in sys.argv[4:]]
    checker.check_callables()
    checker.check_covered()
    checker.check_parameters()
    checker.check_errors()
    checker.check_defaults()
    checker.check_options(read(sys.argv[3]))
    checker.check_tables(folders)
    checker.check_fields(folders)
    checker.check_summary(folders)
    checker.check_kinds()
    agree = f"{len(checker.reference.topics)} topics agree with plugin, sources and files"
    print("\n".join(checker.wrong) or agree)
    return 1 if checker.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
