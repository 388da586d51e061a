"""What the tree itself says of callables: types of the plugin's, declarations of edp/*.idp, options of the cases."""
import re
from dataclasses import dataclass, field

DECLARED = re.compile(r"(real|int|bool|string)(\[[^\]]*\])? +(rc\w+.*);")
FUNCTION = re.compile(r"func +(\S+(?:\[[^\]]*\])?) +(rc\w+)\(([^)]*)\)")
MACRO = re.compile(r"(?:NewMacro|macro) +(rc\w+)(?:\(([^)]*)\))?")
GUARD = re.compile(r"rc\w+Idp$|rc\w+Idp\(")
OPTION = re.compile(r'rc(Real|Int|Text)\(\s*"(-\w+)",\s*(.*?),\s*"([^"]*)",\s*"([^"]*)"\s*\)', re.S)
TYPES = {"Real": "real", "Int": "int", "Text": "string"}


@dataclass
class Callable:
    """One overload: contact.add(tool) -> bool; kind is that of rcCallables, or function, macro, setting of edp/."""
    kind: str
    name: str
    types: list = field(default_factory=list)
    result: str = ""
    arguments: list = None
    default: str = ""
    path: str = ""


def read_callables(text):
    """Lines of rcCallables(0): the overloads, and named parameters {name: {parameter: type}}."""
    calls, named = [], {}
    for line in text.split("\n"):
        kind, _, rest = line.partition(" ")
        if kind == "parameter":
            name, parameter, type_name = rest.split(" ", 2)
            named.setdefault(name, {})[parameter] = type_name
        elif kind in ("type", "constant"):
            name, _, result = rest.partition(" ")
            calls.append(Callable(kind, name, result=result))
        elif kind:
            left, _, result = rest.rpartition(" -> ")
            name, _, types = left.partition("(")
            calls.append(Callable(kind, name, split_types(types), result))
    return calls, named


def split_types(text):
    """"real[int], real)" as a list."""
    inside = text.rstrip(")")
    return [word for word in inside.split(", ") if word]


def outside_macros(text):
    """Lines of a .idp file that stand neither in the body of a NewMacro nor in that of a function."""
    inside = False
    for line in text.split("\n"):
        if not inside:
            yield line
        if line.startswith("NewMacro"):
            inside = True
        if line.rstrip().endswith("EndMacro"):
            inside = False


def argument(text):
    """"contact & C" as its type and name."""
    words = text.replace("&", " ").strip()
    type_name, _, name = words.rpartition(" ")
    return type_name.strip(), name


def variables(kind, rest, path):
    """rcA = 1, rcB(0) of one declaration."""
    depth, parts = 0, [""]
    for letter in rest:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    for part in parts:
        name, _, default = part.strip().partition("=")
        name = name.strip()
        if name.startswith("rc"):
            yield Callable("setting", name.split("(")[0], [], kind, None, default.strip(), path)


def declarations(path, text):
    """Functions, macros and global variables of one .idp file."""
    for line in outside_macros(text):
        code = line.split("//")[0] if not line.startswith("macro") else line
        function, macro, declared = FUNCTION.match(code), MACRO.match(code), DECLARED.match(code)
        if function:
            pairs = [argument(one) for one in re.split(r",(?![^\[]*\])", function[3])]
            types, names = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
            yield Callable("function", function[2], types, function[1], names, "", path)
        elif macro and not GUARD.match(macro[1]):
            names = [word.strip() for word in (macro[2] or "").split(",") if word.strip()]
            yield Callable("macro", macro[1], [""] * len(names), "", names, "", path)
        elif declared:
            yield from variables(declared[1] + (declared[2] or ""), declared[3], path)


def read_declarations(top):
    found = []
    for path in sorted((top / "edp").rglob("*.idp")):
        text = re.sub(r",[^\n,;]*\n +(?=rc\w+\(0\))", lambda m: m[0].replace("\n", " "), path.read_text(encoding="utf-8"))
        found += declarations(str(path.relative_to(top)), text)
    return found


@dataclass
class Option:
    """An option of a script, as -h lists it."""
    name: str
    kind: str
    default: str
    unit: str
    meaning: str
    range: str = ""


def ranges(text):
    """What rcRange and rcPositive of a script say: {"-R": "> 0"}."""
    found = {}
    for names in re.findall(r'rcPositive\("([^"]*)"\)', text):
        found.update({name: "> 0" for name in names.split()})
    for names, least, most in re.findall(r'rcRange\("([^"]*)", *([^,]+), *([^)]+)\)', text):
        for name in names.split():
            found[name] = f"> 0, <= {most}" if found.get(name) == "> 0" and least == "0" else f"{least} to {most}"
    return found


def uncommented(text):
    return re.sub(r"^//.*$", "", text, flags=re.M)


def options_of(text):
    allowed = ranges(text)
    return [Option(name, TYPES[kind], default, unit, " ".join(meaning.split()), allowed.get(name, ""))
            for kind, name, default, unit, meaning in OPTION.findall(text)]


def read_case_options(top):
    """Options of the cases: {folder: [Option]}, and their own defaults of the common ones {folder: {rcElement: "P1"}}."""
    options, own = {}, {}
    for script in sorted((top / "cases").glob("*/*.edp")):
        texts = [path.read_text(encoding="utf-8") for path in [script, *sorted(script.parent.glob("*.idp"))]]
        included = re.findall(r'^include "(rc\w+Options\.idp)"', texts[0], re.M)
        texts += [(top / "edp/cases" / name).read_text(encoding="utf-8") for name in included]
        code = "\n".join(uncommented(text) for text in texts)
        before = code.split("rcCaseOptions(")[0]
        options[script.parent.name] = options_of(code)
        own[script.parent.name] = dict(re.findall(r"\b(rc[A-Z]\w+) = ([^;]+);", before))
    return options, own
