"""burnish help [NAME]: prints what the reference says of a name; exit status 20 for a name that it does not know."""
import difflib
import os
import re
import sys

import heads
import plain
import topics

USAGE = """burnish help NAME    prints the reference of a name: contact.add, C.add, rcRun, tolerance=, -steps, summary, rolling
  tool, contact, material, stepcontrol    the types of a scene: how they are declared, what they do and know
  functions     functions and macros: rcRun, rcCase, rcReal, ...
  settings      variables that a script sets or reads: rcQuiet, rcStatus, rcTolerance, ...
  constants     rcConverged, rcForces, ...
  options       options of every case; the name of a case: its own
  history, events, surface, tools, fields, summary    files of a run: columns, fields, keys with their units
  formulas      functions that formulas of coordinates, forces, friction, hardening, events may call
  exit          exit statuses
  sweep, pictures, movie.gif, springback, ...    the page of the manual that explains them
A value out of its range, and what else is wrong in a script, ends it with exit status 20 and a line that names the place, the
value and what is allowed."""
# what has a page of the manual and no entry: words, then the page and what it says
PAGES = (
    (("sweep", "study", "target", "minimize", "measured"), "sweeps", "burnish sweep: runs for all values of some options, values for a result"),
    (("sequence.png", "scene.png", "stress.png", "plastic-strain.png", "stress-error.png", "history.png", "pressure.png", "expected.png",
      "pictures", "plot.py", "movie.html", "movie.gif"), "pictures", "the pictures and movies of a run, and curves of your own"),
    (("springback", "sheet", "u-channel.edp"), "thin-strips", "thin strips and sheets, their support and springback"),
    (("plasticity", "viscoplastic", "perzyna"), "own-laws", "laws with a history in a script, five examples"),
    (("knurl", "gear", "teeth"), "toothed-tools", "tools with teeth on a block and on a ring"),
    (("paraview", "fields.pvd"), "paraview", "the files of a run in ParaView"),
    (("warnings", "report.txt"), "reports", "warnings and the report of a run"),
    (("new", "template"), "own-scene", "burnish new NAME makes a scene that runs, to be changed"),
)
GROUPS = {"functions": ("function", "macro"), "settings": ("setting",), "constants": ("constant",)}
ALIASES = {"status": "exit", "statuses": "exit", "columns": "history", "types": "topics", "column": "history",
           "event": "events", "formula": "formulas"}


def spelled(word):
    """C.add is contact.add, history.csv the table of that name."""
    letter, dot, member = word.partition(".")
    if dot and letter in heads.OBJECTS:
        return f"{heads.OBJECTS[letter]}.{member}"
    bare = re.sub(r"\.(csv|vtu|json)$", "", word)
    return ALIASES.get(bare, bare)


def last_part(key):
    """A method without its type, a column without its file: contact.add add, summary.json final.t t."""
    return key.partition(" ")[2].split(".")[-1].split("(")[0] or key.split(".")[-1]


def table(kind, reference):
    name = plain.TABLES[kind]
    titles = {"exit": "exit statuses of a script", "formulas": "formulas that a script hands over as texts know"}
    yield titles.get(kind, f"{name}, see edp/cases/rcOutput.idp and edp/cases/rcSummary.idp")
    yield from plain.group_text(name, reference)
    if kind == "events":
        yield "kinds of events"
        yield from plain.group_text("event", reference)


def lookup(word, reference):
    """Lines on a word, or None."""
    name = spelled(word)
    if name in heads.OBJECTS.values():
        return plain.type_text(name, reference)
    if name in reference.topics:
        return plain.topic_text(reference.topics[name], reference)
    if name in plain.TABLES:
        return table(name, reference)
    if name in GROUPS:
        return plain.table_text([topic for topic in reference.topics.values() if topic.kind in GROUPS[name]], reference)
    if name == "options" or name in reference.cases:
        return plain.options_text(reference, None if name == "options" else name)
    return lookup_part(name, reference)


def lookup_part(name, reference):
    """A method without its type, a column without its file, a named parameter, an option: all of that name."""
    lines, bare = [], name.strip("-=")
    for key, topic in reference.topics.items():
        if last_part(key) == name:
            lines += [*plain.topic_text(topic, reference), ""]
    lines += plain.named_text(bare + "=", reference) if not name.startswith("-") else []
    options = [(option, None) for option in reference.common]
    options += [(option, case) for case in sorted(reference.cases) for option in reference.cases[case]]
    for option, case in options:
        if option.name == "-" + bare and not name.endswith("="):
            lines.append(plain.option_text(option, reference, case) + (f" (case {case})" if case else " (every case)"))
    return lines or None


def page_of(word):
    """Lines on a word that a page of the manual explains; none for others."""
    for words, page, what in PAGES:
        if word.lower() in words:
            yield f"{word}: {what}"
            yield f"  see the manual, {topics.TOP / 'edp/manual' / page}.md"


def all_names(reference):
    names = {*reference.topics, *plain.TABLES, *GROUPS, *reference.cases, *heads.OBJECTS.values(), "options"}
    names |= {last_part(key) for key in reference.topics}
    names |= {name for parameters in reference.named.values() for name in parameters}
    names |= {option.name for options in [reference.common, *reference.cases.values()] for option in options}
    return names


def unknown(word, reference):
    lower = {name.lower(): name for name in all_names(reference).union(*(words for words, _, _ in PAGES))}
    near = difflib.get_close_matches(spelled(word).lower(), lower, 5, 0.6)
    names = ", ".join(lower[name] for name in near)
    advice = f"near it: {names}" if names else "burnish help lists the topics"
    print(f"burnish: no help on \"{word}\"; {advice}", file=sys.stderr)
    return 20


def main(words):
    if not words or words[0] in ("-h", "--help", "help", "topics"):
        print(USAGE)
        return 0
    try:
        reference = topics.read_reference()
    except heads.HeadError as error:
        print(f"burnish: {error}", file=sys.stderr)
        return 20
    word = " ".join(words)
    lines = [*(lookup(word, reference) or lookup(".".join(words), reference) or []), *page_of(word)]
    if not lines:
        return unknown(word, reference)
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    try:
        status = main(sys.argv[1:])
        sys.stdout.flush()
    except BrokenPipeError:  # burnish help contact | head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 0
    sys.exit(status)
