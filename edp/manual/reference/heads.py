"""Reads the heads of plugins/*.cpp and edp/*.idp, which are the reference: what a script can call, beside its code.

The head of a file is the block of // lines at its top. First come sentences, one blank after //, and sketches, indented
more. Then, by their indentation:

    //   SIGNATURE, SIGNATURE   meaning | unit | default | range       an entry; fields may be left out from the right
    //     NAME   meaning | unit | default | range                     a parameter of the entry above, NAME= a named one
    //     ! words of an error message, ... where a value stands       an error
    //     > a line of a script                                        an example, indented like an entry: of the file
    //       more words                                                continue the line above
    //   internal: NAME NAME                                           names that are not for scripts

Three blanks or more stand between a signature and its meaning. t, C, M, S are a tool, contact, material, stepcontrol.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

from settings import read_settings

OBJECTS = {"t": "tool", "C": "contact", "M": "material", "S": "stepcontrol"}
FIELDS = re.compile(r"(?:^|\s)\|(?=\s|$)")


class HeadError(Exception):
    """A line of a head that breaks the grammar."""


@dataclass
class Line:
    """Meaning, unit, default, range of an entry or a parameter."""
    name: str
    text: str

    def __post_init__(self):
        self.more("")

    def more(self, words):
        self.text = f"{self.text} {words}".strip()
        cells = [cell.strip() for cell in FIELDS.split(self.text)] + 4 * [""]
        self.meaning, self.unit, self.default, self.range = cells[:4]
        self.excess = "".join(cells[4:])


@dataclass
class Entry(Line):
    """One line of a head: the signatures that it explains, and what is indented below it."""
    place: str = ""
    parameters: list = field(default_factory=list)
    errors: list = field(default_factory=list)
    examples: list = field(default_factory=list)

    @property
    def signatures(self):
        return [Signature(text) for text in split_outside(self.name)]


class Signature:
    """C.add(t): key contact.add, arguments ["t"]; arguments are None without parentheses, [] for (...)."""

    def __init__(self, text):
        self.text = text
        name, _, rest = text.partition("(") if "(" in text and " " not in text.split("(")[0] else (text, "", "")
        self.arguments = None
        if rest:
            inside = rest.rstrip(")").strip()
            self.arguments = [] if inside in ("", "...") else [word.strip() for word in inside.split(",")]
        letter, _, member = name.partition(".")
        self.key = f"{OBJECTS[letter]}.{member}" if member and letter in OBJECTS else name


@dataclass
class Head:
    """All that the head of one file says."""
    path: str
    prose: list = field(default_factory=list)
    examples: list = field(default_factory=list)
    entries: list = field(default_factory=list)
    internal: list = field(default_factory=list)


def split_outside(text):
    """At the commas that are outside of parentheses."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def head_lines(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if not line.startswith("//"):
            return
        yield number, line[2:]


def named_line(text, place):
    name, blanks, meaning = re.match(r"(.*?\S)(?:( {3,})(.*))?$", text).groups()
    if not blanks:
        raise HeadError(f"{place}: three blanks or more must stand before the meaning of {name}")
    return name, meaning


class Reader:
    """Reads one head line by line."""

    def __init__(self, path, shown):
        self.head, self.last = Head(shown), None
        for number, line in head_lines(path):
            blanks = len(line) - len(line.lstrip())
            self.read(blanks, line.strip(), f"{shown}:{number}", line)

    def read(self, blanks, text, place, line):
        if blanks == 3:
            self.read_entry(text, place)
        elif not self.head.entries:
            self.head.prose.append(line[1:])
        elif blanks == 5:
            self.read_inside(text, place)
        elif blanks >= 7 and self.last is not None:
            self.last.more(text)
        else:
            raise HeadError(f"{place}: {blanks} blanks before \"{text}\", expected 3, 5, or 7 and more after an entry")

    def read_entry(self, text, place):
        self.last = None
        if text.startswith("> ") or text == ">":
            self.head.examples.append(text[2:])
        elif text.startswith("internal: "):
            self.head.internal += text.split()[1:]
        else:
            name, meaning = named_line(text, place)
            self.last = Entry(name, meaning, place)
            self.head.entries.append(self.last)

    def read_inside(self, text, place):
        entry = self.head.entries[-1]
        if text.startswith("> "):
            entry.examples.append(text[2:])
        elif text.startswith("! "):
            entry.errors.append(text[2:])
        else:
            self.last = Line(*named_line(text, place))
            entry.parameters.append(self.last)


def read_heads(top):
    """Heads of all sources that a script sees, in the order of their names."""
    paths = sorted((top / "plugins").glob("*.cpp")) + sorted((top / "edp").rglob("*.idp"))
    paths += sorted((top / "edp/manual/reference").glob("*.txt"))
    heads = []
    for path in paths:
        if path.name != "callables.txt":
            heads.append(Reader(path, str(path.relative_to(top))).head)
    add_settings(heads, read_settings(top))
    return heads


def add_settings(heads, settings):
    """The settings are parameters of what they belong to, before those with a rule of their own: those with | in their head."""
    for entry in (entry for head in heads for entry in head.entries):
        own = [one for one in settings if one.owner == entry.signatures[0].key]
        entry.parameters += [Line(one.name + "=", one.line) for one in own if entry.signatures[0].arguments != []]


if __name__ == "__main__":
    for one in read_heads(Path(__file__).resolve().parents[3]):
        print(f"{one.path}: {len(one.entries)} entries, {len(one.internal)} internal names")
