"""What dangers.csv and causes.csv say, and whether the program has their names and words."""
import glob
import os
import re

HERE = os.path.dirname(os.path.abspath(__file__))


def causes():
    """{name: fixed words of the program's line} of what stops or refuses a run; findings of accepted steps have names of their own."""
    with open(os.path.join(HERE, "causes.csv")) as f:
        lines = [line.split(";") for line in f if line.strip() and not line.startswith("#")]
    return {name.strip(): words.strip() for name, words in lines}


def dangers():
    with open(os.path.join(HERE, "dangers.csv")) as f:
        for line in f:
            if line.startswith("#") or not line.strip():
                continue
            name, script, values, reference, names, meaning, *more = (part.strip() for part in line.split(";"))
            rivals, without = (more + ["", ""])[:2]
            yield {"name": name, "script": script.split(), "values": values.split(), "reference": reference.split(),
                   "causes": [one.strip() for one in names.split("|")], "meaning": meaning, "rivals": rivals.split(),
                   "without": without.removeprefix("not:").split()}


def unknown_names():
    """Names of dangers.csv that the program has not, and causes.csv's words that it does not say."""
    top, text, words = os.path.join(HERE, os.pardir, os.pardir), "", causes()
    for path in glob.glob(os.path.join(top, "cxx", "**", "*.cpp"), recursive=True) + glob.glob(os.path.join(top, "plugins", "*.cpp")):
        with open(path) as f:
            text += re.sub(r'"\s*"', "", f.read())  # literals in pieces
    said = set(re.findall(r'"([^"\n]+)"', text))
    for name in sorted({name for d in dangers() for name in d["causes"]} - set(words)):
        if name not in said and not any(one.endswith(" ") and name.startswith(one) for one in said):
            yield f"dangers.csv: no check is named \"{name}\", and causes.csv has no such line"
    for name, line in words.items():
        if line not in text:
            yield f"causes.csv: {name}: the program does not say \"{line}\""
