"""The reference as pages of Markdown (MyST) for the site of the manual; every entry has a target such as contact-add."""
import re

import plain
import topics

INTRO = {
    "contact": "The surface of a workpiece that tools may touch, the states of its nodes and what a run says of it. `C` is "
               "a contact.",
    "tool": "A rigid tool: its profile, its coordinates, the motion or force of each. `t` is a tool.",
    "material": "The workpiece's law, its stress and what is read at its points. `M` is a material.",
    "stepcontrol": "The length of the steps and the run over them. `S` is a stepcontrol.",
    "functions": "Functions and macros that begin with `rc`, of the plugin and of the library `edp/`.",
    "settings": "Variables that a script sets before a run or reads after it. The default is the value that `edp/` gives them.",
    "options": "Words after the script's name on the command line, `-name value`. `burnish cases/rolling/rolling.edp -h` "
               "lists them with the defaults of that case, `-options list` prints all with their values as JSON.",
    "files": "What a run writes into its folder. Coordinates, tools and columns bear the names that the script gives them.",
    "statuses": "With what a script ends; `echo $?` after it.",
}
RULE = ("A value outside its range ends the script with exit status 20 and a line `place: name = value, expected range`; other "
        "errors are listed where they occur. Units are chosen by the script: length, force, stress, time; `-` has none.\n")
EDITORS = """## For editors
`python3 edp/manual/reference/generate.py FOLDER` writes them beside these pages:

| File | Editor | Where it goes |
|---|---|---|
| `burnish.code-snippets` | VS Code: snippets `rcscene`, `rctool`, `rccontact`, `rcprogram`, `rcrecord`, `rccase`, ... | `.vscode/` of a folder |
| `burnish.vim` | Vim: colors | `~/.vim/after/syntax/edp.vim` |
| `burnish-kate.xml` | Kate, KWrite: colors | `~/.local/share/org.kde.syntax-highlighting/syntax/` |
| `keywords.txt` | any other: all names, a line each | |
"""
TITLES = {"statuses": "Exit statuses"}
FILE_TITLES = {"event": "Kinds of events", "fields.vtu": "fields-0.vtu, ..., final.vtu",
               "surface.vtp": "surface-0.vtp, ...", "tools.vtp": "tools-0.vtp, ..."}
NAMES = ["Name", "Type", "Meaning", "Unit", "Default", "Range"]


class Pages:
    """Writes the pages of one reference."""

    def __init__(self, reference):
        self.reference = reference

    def linked(self, text, own=None):
        """Text of a head as Markdown: quoted words as code, names that have an entry as links."""
        parts = re.split(r'("[^"]*"|\brc\w+\.idp\b|\b(?:rc[A-Z]\w+|[tCMS]\.[A-Za-z]+)\b)', text)
        return "".join(self.word(part, own) if k % 2 else escaped(part) for k, part in enumerate(parts))

    def word(self, part, own):
        letter, _, member = part.partition(".")
        key = f"{topics.heads.OBJECTS[letter]}.{member}" if member and letter in topics.heads.OBJECTS else part
        code = part.replace("|", "\\|")
        if key in self.reference.topics and key != own:
            return f"[`{code}`]({self.reference.topics[key].anchor})"
        return f"`{code}`"

    def cells(self, name, kind, line, default=None, anchor=""):
        value = line.default if default is None else default
        target = f'<span id="{anchor}"></span>' if anchor else ""
        code = "`" + name.replace("|", "\\|") + "`"
        return [target + code, f"`{kind}`" if kind else "", self.linked(line.meaning, name), escaped(line.unit),
                self.linked(value), self.linked(line.range)]

    def use(self, use, topic):
        text = f"```text\n{plain.call(use, topic, self.reference)}\n```\n"
        unit = f" [{escaped(use.entry.unit)}]" if use.entry.unit else ""
        text += f"{self.linked(use.entry.meaning, topic.key)}{unit}\n\n"
        listed = list(topics.rows(self.reference, use, topic))
        if listed:
            text += table([self.cells(name, kind, line) for name, kind, line in listed])
        for error in use.entry.errors:
            text += f"- error: {escaped(plain.quoted(error))}\n"
        text += "\n" if use.entry.errors else ""
        if use.entry.examples:
            text += "```text\n" + "\n".join(use.entry.examples) + "\n```\n\n"
        return text

    def topic(self, topic):
        return f"({topic.anchor})=\n### {topic.key}\n" + "".join(self.use(use, topic) for use in topic.uses)

    def values(self, found):
        """Members, constants, settings: a paragraph for each entry of a head."""
        text, done = "", set()
        for topic in found:
            use = topic.uses[0]
            if id(use.entry) in done:
                continue
            done.add(id(use.entry))
            keys = [one.key for one in use.entry.signatures]
            text += "".join(f"({self.reference.topics[key].anchor})=\n" for key in keys)
            names = ", ".join(f"**`{one.text}`**" for one in use.entry.signatures)
            words = [f"`{use.result}`", f"[{escaped(use.entry.unit)}]" if use.entry.unit else ""]
            more = [f"default {self.defaults(keys)}" if use.default else "",
                    f"range {self.linked(use.entry.range)}" if use.entry.range else ""]
            more = "; ".join(one for one in more if one)
            text += " ".join(one for one in [names, *words] if one) + f": {self.linked(use.entry.meaning)}"
            text += f"; {more}\n\n" if more else "\n\n"
        return text

    def defaults(self, keys):
        return ", ".join(f"`{self.reference.topics[key].uses[0].default}`" for key in keys)

    def section(self, head, page):
        """What one head gives to a page."""
        found = [topic for topic in self.reference.topics.values() if topic.page == page and topic.uses[0].path == head.path]
        if not found:
            return ""
        prose = " ".join(line.strip() for line in head.prose if not line.startswith("  "))
        title, rest = (re.split(r"(?<=[^. ])\. ", prose, maxsplit=1) + [""])[:2]
        short = heading(title)
        text = f"## {short}\n"
        if page != "settings":
            prose = rest if short == title.rstrip(".").replace("`", "") else prose
            text += (f"{self.linked(prose)}\n\n" if prose else "") + f"*{head.path}*\n\n"
            text += "```text\n" + "\n".join(head.examples) + "\n```\n\n" if head.examples else ""
        else:
            text += f"*{head.path}*\n\n"
        flat = [topic for topic in found if topic.kind in ("member", "constant", "setting")]
        topics_text = "".join(self.topic(topic) for topic in found if topic not in flat)
        if found[0] in flat:
            return text + self.values(flat) + topics_text
        return text + topics_text + ("### Values\n" + self.values(flat) if flat else "")

    def callable_page(self, page):
        text = f"# {TITLES.get(page, page.capitalize())}\n{INTRO[page]}\n\n{RULE}\n"
        return text + "".join(self.section(head, page) for head in self.reference.heads)

    def files_page(self):
        text = f"# Files of a run\n{INTRO['files']}\n\n"
        for file in topics.FILES:
            found = [topic for topic in self.reference.topics.values() if topic.kind == file]
            anchor = re.sub(r"[^a-z]+", "-", file)
            text += f"({anchor})=\n## {FILE_TITLES.get(file, file)}\n| Name | Unit | Meaning |\n|---|---|---|\n"
            for topic in found:
                name = topic.key.split(" ", 1)[1].replace("|", "\\|")
                entry = topic.uses[0].entry
                text += f'| <span id="{topic.anchor}"></span>`{name}` | {escaped(entry.unit)} | {self.linked(entry.meaning)} |\n'
            text += "\n"
        return text

    def statuses_page(self):
        text = f"(exit)=\n# Exit statuses\n{INTRO['statuses']}\n\n| Status | Meaning |\n|---|---|\n"
        for topic in self.reference.topics.values():
            if topic.kind == "exit":
                status, meaning = topic.key.split()[1], self.linked(topic.uses[0].entry.meaning)
                text += f'| <span id="{topic.anchor}"></span>{status} | {meaning} |\n'
        return text

    def formulas_page(self):
        text = "(formulas)=\n# Formulas\n"
        prose = [head.prose for head in self.reference.heads if head.path.endswith("formulas.txt")][0]
        text += self.linked(" ".join(prose)) + "\n\n| Name | Unit | Meaning |\n|---|---|---|\n"
        for topic in self.reference.topics.values():
            if topic.kind == "formula":
                entry, target = topic.uses[0].entry, f'<span id="{topic.anchor}"></span>'
                text += f"| {target}`{topic.key[8:]}` | {escaped(entry.unit)} | {escaped(entry.meaning)} |\n"
        return text

    def options_page(self):
        text = f"(options)=\n# Options\n{INTRO['options']}\n\n## Every case\n" + self.options(self.reference.common)
        for case, options in sorted(self.reference.cases.items()):
            own = ", ".join(f"`{name} = {value}`" for name, value in self.reference.own[case].items())
            text += f"(options-{case})=\n## {case}\n" + (f"Own defaults: {own}.\n\n" if own else "\n") + self.options(options)
        return text

    def options(self, options):
        rows = []
        for option in options:
            default = topics.default_of(option, self.reference)
            line = topics.heads.Line(option.name, "")
            line.meaning, line.unit, line.range = option.meaning, option.unit, option.range
            shown = "" if default == '""' else default if default.startswith('"') else f'"{default}"'
            rows.append(self.cells(option.name, option.kind, line, shown))
        return table(rows).replace('`"', "`").replace('"`', "`")

    def index(self, pages):
        text = ("(reference)=\n# Reference\nMade from the tables of the plugin and the heads of `plugins/` and `edp/`; "
                "`burnish help NAME` prints the same.\n\n```{toctree}\n:maxdepth: 2\n\n" + "\n".join(pages) + "\n```\n\n{ref}`burnish-names`\n\n")
        return text + EDITORS

    def all(self):
        """{file name: text}."""
        names = ("tool", "contact", "material", "stepcontrol", "functions", "settings")
        pages = {page: self.callable_page(page) for page in names}
        pages.update(options=self.options_page(), files=self.files_page(), statuses=self.statuses_page())
        pages["formulas"] = self.formulas_page()
        pages["index"] = self.index(list(pages))
        return {f"{name}.md": text for name, text in pages.items()}


def heading(sentence):
    """The first words of a head: up to a colon, a bracket, or, of long ones, a comma."""
    short = re.split(r": | \(|; ", sentence)[0].rstrip(".").replace("`", "")
    return short.split(",")[0] if len(short) > 60 else short


def table(rows):
    """Rows of six cells, without the columns that are empty in all of them."""
    used = [k for k in range(6) if k in (0, 2) or any(row[k] for row in rows)]
    lines = [[NAMES[k] for k in used], ["---"] * len(used)] + [[row[k] for k in used] for row in rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines) + "\n"


def escaped(text):
    return re.sub(r"([|*$<\[\]_])", lambda found: {"<": "&lt;"}.get(found[1], "\\" + found[1]), text)
