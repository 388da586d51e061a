"""Joins the heads with the types of the plugin and the declarations of edp/: one topic for each name."""
import re
from dataclasses import dataclass, field
from pathlib import Path

import heads
import sources
from settings import read_settings

TOP = Path(__file__).resolve().parents[3]
OF_ANY = {"C": "contact", "M": "material", "S": "stepcontrol", "T": "tool", "Vh": "fespace of the displacement"}
PAGES = [("plugins/contact", "contact"), ("plugins/tool", "tool"), ("plugins/material", "material"),
         ("plugins/step_", "stepcontrol"), ("plugins/checkpoint", "stepcontrol"), ("plugins/stage", "stepcontrol"), ("plugins/remesh", "stepcontrol"), ("plugins/initial", "material"), ("plugins/scene_report", "stepcontrol")]
FIRST = ["plugins/contact_type.cpp", "plugins/tool_type.cpp", "plugins/material_type.cpp", "plugins/step_control.cpp",
         "edp/run/rcRun.idp", "edp/run/rcRunState.idp", "edp/cases/rcCaseOptions.idp", "edp/cases/rcCase.idp", "edp/cases/rcResults.idp",
         "plugins/options.cpp", "edp/cases/rcHistory.idp", "edp/cases/rcOutput.idp"]  # then by name
FILES = ("history.csv", "events.csv", "surface.csv", "tools.csv", "fields.vtu", "surface.vtp", "tools.vtp", "supports.vtp", "summary.json", "event")


@dataclass
class Use:
    """One signature of a topic: its line in a head, and what the code says of it."""
    signature: heads.Signature
    entry: heads.Entry
    overloads: list
    path: str

    @property
    def result(self):
        return " or ".join(unique(one.result for one in self.overloads if one.result))

    @property
    def default(self):
        return self.entry.default or "".join(unique(one.default for one in self.overloads))

    def type_of(self, k):
        return " or ".join(unique(one.types[k] for one in self.overloads if k < len(one.types) and one.types[k]))


@dataclass
class Topic:
    """All that is said of one name."""
    key: str
    kind: str
    page: str
    uses: list = field(default_factory=list)
    named: dict = field(default_factory=dict)

    @property
    def anchor(self):
        if self.kind == "formula":
            text = self.key[8:].replace(" ", "")
            return "formula-" + "-".join(re.findall(r"\w+", text) or [f"{ord(letter):x}" for letter in text])
        name = re.sub(r"[^a-z0-9]+", "-", spell(self.key).lower()).strip("-")
        return f"type-{name}" if self.kind == "constructor" else name  # contact is the name of a page, too


@dataclass
class Reference:
    """Everything: heads, topics by name, callables and declarations, options."""
    heads: list
    topics: dict
    calls: list
    named: dict
    common: list
    cases: dict
    own: dict
    settings: dict


FREE = (*FILES, "exit", "formula")  # nothing callable: held against files and sources by the test


def spell(key):
    """Capitals that alone tell two names apart get a word: C.q and C.Q, surface.csv x and X."""
    return re.sub(r"(?<=[. ])([A-Z])$", r"capital-\1", key)


def unique(words):
    return list(dict.fromkeys(words))


def kind_of(key, calls):
    if key.split(" ")[0] in FREE:
        return key.split(" ")[0]
    kinds = unique(one.kind for one in calls)
    return kinds[0] if kinds else "unknown"


def page_of(key, kind, path):
    if kind in FILES:
        return "files"
    if kind in ("exit", "formula"):
        return {"exit": "statuses", "formula": "formulas"}[kind]
    if kind == "setting":
        return "settings"
    for start, page in PAGES:
        if path.startswith(start):
            return page
    return key.split(".")[0] if "." in key else "functions"


def matching(signature, calls):
    """The overloads that a signature stands for: as many arguments, or all of a member, setting, type."""
    if signature.arguments is None:
        return calls
    size = len(signature.arguments)
    return [one for one in calls if len(one.arguments if one.arguments is not None else one.types) == size
            or one.kind in ("type", "constructor") and size == 0]


def add_entry(reference, by_name, entry, path):
    for signature in entry.signatures:
        key = signature.key
        calls = by_name.get(key, [])
        if key not in reference.topics:
            kind = kind_of(key, calls)
            reference.topics[key] = Topic(key, kind, page_of(key, kind, path), [], reference.named.get(key, {}))
        reference.topics[key].uses.append(Use(signature, entry, matching(signature, calls), path))


def read_reference(top=TOP):
    lines = (top / "edp/manual/reference/callables.txt").read_text(encoding="utf-8").split("\n")
    calls, named = sources.read_callables("\n".join(lines + [one.callable for one in read_settings(top)]))
    declared = sources.read_declarations(top)
    common = sources.options_of(sources.uncommented((top / "edp/cases/rcCaseOptions.idp").read_text(encoding="utf-8")))
    cases, own = sources.read_case_options(top)
    settings = {one.name: one for one in declared if one.kind == "setting"}
    found = heads.read_heads(top)
    found.sort(key=lambda head: FIRST.index(head.path) if head.path in FIRST else len(FIRST))
    reference = Reference(found, {}, calls + declared, named, common, cases, own, settings)
    by_name = {}
    for one in reference.calls:
        by_name.setdefault(one.name, []).append(one)
    for head in reference.heads:
        for entry in head.entries:
            add_entry(reference, by_name, entry, head.path)
    return reference


def explained(reference, use, name):
    """The line that explains an argument: of the entry itself, of another in its file, of the one that it refers to."""
    referred = re.findall(r"\bas in (rc\w+)", use.entry.meaning + " ".join(one.meaning for one in use.entry.parameters))
    entries = [use.entry]
    entries += [entry for head in reference.heads if head.path == use.path for entry in head.entries]
    entries += [other.entry for key in referred + ["rcRun"] if key in reference.topics for other in reference.topics[key].uses]
    for entry in entries:
        for line in entry.parameters:
            if line.name == name:
                return line
    if name in OF_ANY:
        return heads.Line(name, OF_ANY[name])
    return None


def rows(reference, use, topic):
    """Arguments and named parameters of a use: (name, type, line)."""
    for k, name in enumerate(use.signature.arguments or []):
        line = explained(reference, use, name) or heads.Line(name, "")
        yield name, use.type_of(k) or {"C": "contact", "M": "material", "S": "stepcontrol", "T": "tool"}.get(name, ""), line
    for line in use.entry.parameters:
        if line.name.endswith("="):
            yield line.name, topic.named.get(line.name, ""), line


def default_of(option, reference, case=None):
    """An option's default; that of a common one is the setting's, or the case's own."""
    value = option.default
    if value == "rcFolder":
        return f'"out/{case or "NAME"}"'
    if re.match(r"rc[A-Z]\w*$", value) and value in reference.settings:
        value = reference.own.get(case, {}).get(value, reference.settings[value].default)
    if value == "rcDraw":
        value = "true"
    if option.kind == "int" and value in ("true", "false"):
        value = "1" if value == "true" else "0"
    return value
