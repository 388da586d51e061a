"""The reference as plain text: what `burnish help NAME` prints."""
import textwrap

import topics

WIDTH = 118
TABLES = {"history": "history.csv", "events": "events.csv", "surface": "surface.csv", "tools": "tools.csv",
          "fields": "fields.vtu", "summary": "summary.json", "exit": "exit", "formulas": "formula"}
KINDS = {"constructor": "type", "member": "value", "macro": "macro of edp/", "setting": "variable of edp/", "exit": "exit status"}


def wrapped(text, indent, first=None):
    return textwrap.fill(text, WIDTH, initial_indent=indent if first is None else first, subsequent_indent=indent,
                         break_long_words=False, break_on_hyphens=False)


def facts(line, default=None):
    """Unit, default and range behind a meaning."""
    value = line.default if default is None else default
    words = [f"[{line.unit}]"] if line.unit else []
    words += [value if value.startswith("required") else f"default {value}"] if value else []
    words += [f"range {line.range}"] if line.range else []
    return ", ".join(words)


def sentence(line, default=None):
    more = facts(line, default)
    return f"{line.meaning}  {more}" if more else line.meaning


def call(use, topic, reference):
    """The signature with types: real C.approach(tool t, string coordinate, real[int] u)."""
    named = [line.name for line in use.entry.parameters if line.name.endswith("=")]
    words = [f"{kind} {name}" if kind and not name.endswith("=") else name for name, kind, _ in topics.rows(reference, use, topic)
             if not name.endswith("=")]
    name = use.signature.text.split("(")[0] if use.signature.arguments is not None else use.signature.text
    if topic.kind == "constructor":
        return f"{name} NAME({', '.join(words + ['...'])})" if f"rc{name.capitalize()}" not in reference.topics \
            else f"{name} NAME = rc{name.capitalize()}(...)"
    result = f"{use.result} " if use.result else ""
    inside = ", ".join(words + (["..."] if named else []))
    return f"{result}{name}({inside})" if use.signature.arguments is not None else f"{result}{name}"


def quoted(error):
    """A part of a message; what stands before it differs."""
    return error if error[0].isalnum() else "... " + error.lstrip()


def use_text(use, topic, reference):
    yield "  " + call(use, topic, reference)
    yield wrapped(sentence(use.entry, use.default), "      ")
    listed = list(topics.rows(reference, use, topic))
    width = max([len(name) for name, _, _ in listed] + [10]) + 2
    kinds = max([len(kind) for _, kind, _ in listed] + [4]) + 2
    for name, kind, line in listed:
        start = f"    {name:<{width}}{kind:<{kinds}}"
        yield wrapped(sentence(line), " " * len(start), start)
    for error in use.entry.errors:
        yield wrapped(quoted(error), "          ", "      error: ")
    for example in use.entry.examples:
        yield "      example: " + example


def topic_text(topic, reference):
    kind = KINDS.get(topic.kind, topic.kind)
    yield f"{topic.key}   ({kind}, {', '.join(topics.unique(use.path for use in topic.uses))})"
    for use in topic.uses:
        yield from use_text(use, topic, reference)


def table_text(found, reference):
    """One line each, for lists of names."""
    width = min(max([len(topic.key) for topic in found] + [8]) + 2, 40)
    for topic in found:
        use = topic.uses[0]
        start = f"  {topic.key:<{width}}"
        yield wrapped(sentence(use.entry, use.default), " " * len(start), start if len(topic.key) < width else start + " ")


def type_text(name, reference):
    """A type: how it is declared, then its methods and values in a line each."""
    for key in (name, "rc" + name.capitalize()):
        if key in reference.topics:
            yield from topic_text(reference.topics[key], reference)
            yield ""
    members = [topic for key, topic in reference.topics.items() if key.startswith(name + ".")]
    yield f"methods and values of {name}; burnish help {members[0].key} says more"
    yield from table_text(members, reference)


def option_text(option, reference, case=None):
    start = f"  {option.name:<17}{option.kind:<8}"    # the longest is -frictiontangent
    default = topics.default_of(option, reference, case)
    text = option.meaning + (f" [{option.unit}]" if option.unit else "") + f" default {default}"
    return wrapped(text + (f", range {option.range}" if option.range else ""), " " * len(start), start)


def options_text(reference, case=None):
    yield "options of every case; -h lists them with the defaults of the case, -options list prints all values as JSON"
    for option in reference.common:
        yield option_text(option, reference, case)
    if case is None:
        yield "options of one case: burnish help NAME, one of " + ", ".join(sorted(reference.cases))
        return
    yield f"options of the case {case}"
    for option in reference.cases[case]:
        yield option_text(option, reference, case)


def named_text(name, reference):
    """A named parameter, wherever it occurs."""
    for topic in reference.topics.values():
        for use in topic.uses:
            for line in use.entry.parameters:
                if line.name == name:
                    yield f"  {topic.key}(..., {name}{topic.named.get(name, '')})"
                    yield wrapped(sentence(line), "      ")


def group_text(kind, reference):
    found = [topic for topic in reference.topics.values() if topic.kind == kind or topic.page == kind]
    yield from table_text(found, reference)


def everything(reference):
    """The whole reference, for the file help.txt."""
    for topic in reference.topics.values():
        yield from topic_text(topic, reference)
        yield ""
    yield from options_text(reference)
    for case in sorted(reference.cases):
        yield ""
        yield f"options of the case {case}"
        for option in reference.cases[case]:
            yield option_text(option, reference, case)
