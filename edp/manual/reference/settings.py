"""The table of cxx/run/settings.cpp: named parameters of rcContact, stepcontrol and rcMaterial, and options of the same names."""
import re
from dataclasses import dataclass
from pathlib import Path

SOURCE = "cxx/run/settings.cpp"
TEXT = r'"((?:[^"\\]|\\.)*)"'
ROW = re.compile(rf'\{{{TEXT}, {TEXT}, {TEXT}, {TEXT}, {TEXT}, (\w+),\s*((?:{TEXT}\s*)+),\s*(AT|CHOICE)\(([\w.]+)((?:, {TEXT})*)\)\}}')


@dataclass
class Setting:
    """One row; path: iteration.tolerance; choices: words in quotes, [] of a number or a flag."""
    name: str
    owner: str
    unit: str
    section: str
    default: str
    range: str
    meaning: str
    path: str
    choices: list

    @property
    def member(self):
        return self.path.rpartition(".")[2]

    @property
    def callable(self):
        """As rcCallables lists it."""
        kind = "string" if self.choices else "bool" if self.default in ("true", "false") else "int" if " to " in self.range else "real"
        return f"parameter {self.owner} {self.name}= {kind}"

    @property
    def line(self):
        """As the head of a source says it: meaning | unit | default | range."""
        allowed = self.range.replace("value", self.name).replace("a finite number", "finite")
        return f"{self.meaning} | {self.unit} | {self.default} | {', '.join(self.choices) or allowed}"


def unquoted(text):
    return re.sub(r"\\(.)", r"\1", text)


def read_settings(top):
    code = (Path(top) / SOURCE).read_text(encoding="utf-8")
    ranges = dict(re.findall(rf"constexpr Range (\w+)\{{[^\"]*{TEXT}\}}", code))
    ranges["NONE"] = ""
    found = []
    for row in ROW.finditer(code):
        name, owner, unit, section, default = (unquoted(one) for one in row.groups()[:5])
        meaning = "".join(unquoted(one) for one in re.findall(TEXT, row[7]))
        found.append(Setting(name, owner, unit if unit else "", section, default, ranges[row[6]], meaning, row[10],
                             re.findall(r'"[^"]*"', row[11])))
    rows = len(re.findall(r"\b(?:AT|CHOICE)\(\w+\.", code))
    if len(found) != rows:
        raise SystemExit(f"{SOURCE}: {rows} rows, {len(found)} of them read")
    return found
