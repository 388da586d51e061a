"""Keyword lists and snippets for editors from the same data: VS Code, Vim, Kate, and a plain list."""
import json
import re
from pathlib import Path
from xml.sax.saxutils import escape

SNIPPETS = Path(__file__).with_name("snippets.txt")


def words_of(reference):
    """Names of a script by group."""
    groups = {"types": set(), "functions": set(), "variables": set(), "constants": set(), "members": set(), "parameters": set()}
    place = {"constructor": "types", "function": "functions", "macro": "functions", "setting": "variables",
             "constant": "constants"}
    for key, topic in reference.topics.items():
        if "." in key and topic.kind in ("method", "member"):
            groups["members"].add(key.split(".")[-1])
        elif topic.kind in place:
            groups[place[topic.kind]].add(key)
    for parameters in reference.named.values():
        groups["parameters"].update(name.rstrip("=") for name in parameters)
    return {name: sorted(words) for name, words in groups.items()}


def snippets():
    """(name, description, body) of every snippet; ${1:word} are the places to fill in."""
    for part in re.split(r"^== ", SNIPPETS.read_text(encoding="utf-8"), flags=re.M)[1:]:
        title, _, body = part.partition("\n")
        name, _, meaning = title.partition(": ")
        yield name, meaning, body.rstrip("\n")


def filled(body):
    """The snippet with its words in place, a script's own text."""
    return re.sub(r"\$\{\d+:([^}]*)\}", r"\1", body)


def vscode():
    return json.dumps({f"Burnish {name}": {"scope": "freefem,edp", "prefix": f"rc{name}", "description": meaning,
                                           "body": body.split("\n")} for name, meaning, body in snippets()}, indent=2) + "\n"


def vim(groups):
    kinds = {"types": "Type", "functions": "Function", "variables": "Identifier", "constants": "Constant",
             "parameters": "Keyword"}
    text = "\" Burnish's names for FreeFEM scripts: put it into ~/.vim/after/syntax/edp.vim\n"
    for group, kind in kinds.items():
        words = " ".join(word for word in groups[group] if group != "parameters")
        if words:
            text += f"syntax keyword burnish{kind} {words}\n"
    members, named = "\\|".join(groups["members"]), "\\|".join(groups["parameters"])
    text += f"syntax match burnishStatement \"\\.\\zs\\<\\({members}\\)\\>\"\n"
    text += f"syntax match burnishKeyword \"\\<\\({named}\\)\\ze\\s*=[^=]\"\n"
    for kind in [*kinds.values(), "Statement"]:
        text += f"highlight default link burnish{kind} {kind}\n"
    return text


def kate(groups):
    items_of = {name: "".join(f"      <item>{escape(word)}</item>\n" for word in words) for name, words in groups.items()}
    lists = "".join(f"    <list name=\"{name}\">\n{words}    </list>\n" for name, words in items_of.items())
    styles = {"types": "dsDataType", "functions": "dsFunction", "variables": "dsVariable", "constants": "dsConstant",
              "members": "dsAttribute", "parameters": "dsKeyword"}
    rules = "".join(f"        <keyword attribute=\"{name}\" context=\"#stay\" String=\"{name}\"/>\n" for name in groups)
    items = "".join(f"      <itemData name=\"{name}\" defStyleNum=\"{style}\"/>\n" for name, style in styles.items())
    return ("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE language>\n"
            "<language name=\"FreeFEM Burnish\" section=\"Scientific\" version=\"1\" kateversion=\"5.0\" "
            f"extensions=\"*.edp;*.idp\">\n  <highlighting>\n{lists}    <contexts>\n"
            "      <context name=\"Normal\" attribute=\"Normal\" lineEndContext=\"#stay\">\n"
            "        <RangeDetect attribute=\"String\" context=\"#stay\" char=\"&quot;\" char1=\"&quot;\"/>\n"
            "        <RegExpr attribute=\"Comment\" context=\"#stay\" String=\"//.*$\"/>\n"
            f"{rules}      </context>\n    </contexts>\n    <itemDatas>\n"
            "      <itemData name=\"Normal\" defStyleNum=\"dsNormal\"/>\n"
            "      <itemData name=\"String\" defStyleNum=\"dsString\"/>\n"
            "      <itemData name=\"Comment\" defStyleNum=\"dsComment\"/>\n"
            f"{items}    </itemDatas>\n  </highlighting>\n"
            "  <general>\n    <keywords casesensitive=\"1\"/>\n  </general>\n</language>\n")


def all_files(reference):
    """{file name: text}."""
    groups = words_of(reference)
    plain = "".join(word + "\n" for word in sorted({word for words in groups.values() for word in words}))
    return {"burnish.code-snippets": vscode(), "burnish.vim": vim(groups), "burnish-kate.xml": kate(groups),
            "keywords.txt": plain}
