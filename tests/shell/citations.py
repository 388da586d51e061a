"""Follows every citation of the project's documents: sections, equations, keys of references.bib, links, paths.

    citations.py [FOLDER]     of the project; the present one unless given

Looks into cxx plugins edp cases tests and all .md files. What is cited as
    METHOD.md 3.2, 3.4   ALGORITHMS.md 5.3   METHOD.md (3.4)   article (1.11)   [Morev2007]
must exist, and so must the target of every relative link and every path in code marks of an .md file. An equation in a
comment must say whose it is. Prints file:line and what is wrong; exit status 1 if there is anything.
"""
import os
import re
import sys

FOLDERS = ["cxx", "plugins", "edp", "cases", "tests"]
SOURCES = (".hpp", ".h", ".cpp", ".idp", ".edp", ".py", ".sh")
DOCUMENTS = {"METHOD.md": "cxx/METHOD.md", "ALGORITHMS.md": "cxx/ALGORITHMS.md"}
BIBLIOGRAPHY = "cxx/references.bib"
ITEM = r"(?:\(\d+\.\d+\)|\d+(?:\.\d+)?(?![\d.]*\d))"
LIST = ITEM + r"(?:(?:,\s+|\s+and\s+|\s+to\s+|-)" + ITEM + r")*"
CITED = re.compile(r"(\[(?:METHOD|ALGORITHMS)\.md\]\([^)]*\)|\b(?:METHOD|ALGORITHMS)\.md|\barticle,?)"
                   r"(\s+eq\.)?(\s+sections?)?\s+(" + LIST + ")")
EQUATION = re.compile(r"\(([1-9]\d?)\.([1-9]\d?)\)")
KEYS = re.compile(r"\[([A-Z][A-Za-z]+(?:18|19|20)\d\d(?:, [A-Z][A-Za-z]+(?:18|19|20)\d\d)*)\](?!\()")
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:cxx|plugins|edp|cases|tests|\.ci)/[\w./-]*)`")


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


class Document:
    """Sections and equations that a document has; `article` holds the article's equations in the table of METHOD.md."""

    def __init__(self, text):
        self.sections = set(re.findall(r"^#+ (\d+(?:\.\d+)?)[. ]", text, re.M))
        self.equations = set(re.findall(r"\\tag\{(\d+\.\d+)\}", text))


def article_equations(text):
    found = set()
    for first in re.findall(r"^\| (\(\d+\.\d+\)[^|]*) \|", text, re.M):
        ends = re.findall(r"\((\d+)\.(\d+)\)", first)
        found.update("%s.%s" % end for end in ends)
        for (a, m), (_, n) in zip(ends, ends[1:]):
            if "(%s.%s)-(%s.%s)" % (a, m, a, n) in first:
                found.update("%s.%d" % (a, k) for k in range(int(m), int(n) + 1))
    return found


class Checker:
    def __init__(self, root):
        self.root = root
        self.errors = []
        self.documents = {name: Document(read(os.path.join(root, path))) for name, path in DOCUMENTS.items()}
        self.article = article_equations(read(os.path.join(root, DOCUMENTS["METHOD.md"])))
        self.keys = re.findall(r"^@\w+\{(\w+),", read(os.path.join(root, BIBLIOGRAPHY)), re.M)
        self.cited_keys = set()
        self.count = 0

    def files(self):
        names = [name for name in sorted(os.listdir(self.root)) if name.endswith(".md")]
        for folder in FOLDERS:
            for at, folders, files in os.walk(os.path.join(self.root, folder), followlinks=True):
                folders[:] = sorted(name for name in folders if name != "__pycache__")
                names += [os.path.relpath(os.path.join(at, name), self.root) for name in sorted(files)
                          if name.endswith(SOURCES + (".md",))]
        return names

    def fail(self, name, text, offset, message):
        self.errors.append("%s:%d: %s" % (name, text.count("\n", 0, offset) + 1, message))

    def check_item(self, name, text, offset, document, item):
        self.count += 1
        known = self.documents.get(document)
        if item[0] == "(":
            there = self.article if known is None else known.equations
            if item[1:-1] not in there:
                self.fail(name, text, offset, "%s has no equation %s" % (document, item))
        elif known is not None and item not in known.sections:
            self.fail(name, text, offset, "%s has no section %s" % (document, item))

    def check_cited(self, name, text):
        """Citations with their document; returns the offsets of their equations."""
        seen = set()
        for found in CITED.finditer(text):
            document = re.search(r"METHOD\.md|ALGORITHMS\.md|article", found[1])[0]
            if document != "article" and (found[2] or found[3]):
                self.fail(name, text, found.start(), "write \"%s %s\"" % (document, found[4]))
            for item in re.finditer(ITEM, found[4]):
                offset = found.start(4) + item.start()
                seen.add(offset)
                self.check_item(name, text, offset, document, item[0])
        return seen

    def check_keys(self, name, text):
        for found in KEYS.finditer(text):
            for key in found[1].split(", "):
                self.count += 1
                self.cited_keys.add(key)
                if key not in self.keys:
                    self.fail(name, text, found.start(), "references.bib has no key %s" % key)

    def check_old_names(self, name, text):
        for found in re.finditer(r"\b(method|algorithms)" + r"\.md", text):
            self.fail(name, text, found.start(), "write %s.md" % found[1].upper())

    def check_source(self, name):
        whole = read(os.path.join(self.root, name))
        text = comments(whole, name)
        seen = self.check_cited(name, text)
        self.check_keys(name, text)
        self.check_old_names(name, whole)
        for found in EQUATION.finditer(text):
            if found.start() not in seen:
                self.fail(name, text, found.start(), "whose equation is %s? METHOD.md, ALGORITHMS.md or article"
                          % found[0])

    def check_document(self, name):
        text = read(os.path.join(self.root, name))
        seen = self.check_cited(name, text)
        self.check_keys(name, text)
        self.check_old_names(name, text)
        folder = os.path.dirname(os.path.join(self.root, name))
        for found in LINK.finditer(text):
            target = found[1].split("#")[0]
            if re.match(r"\w+:", found[1]) or not target:
                continue
            self.count += 1
            if not os.path.exists(os.path.join(folder, target)):
                self.fail(name, text, found.start(), "link to %s, which does not exist" % target)
        for found in PATH.finditer(text):
            self.count += 1
            if not os.path.exists(os.path.join(self.root, found[1])) and not re.search(r"\b[A-Z]{3,}\b", found[1]):
                self.fail(name, text, found.start(), "path %s, which does not exist" % found[1])
        for document, path in DOCUMENTS.items():
            if os.path.normpath(name) == os.path.normpath(path):
                self.check_own(name, text, seen, document)

    def check_own(self, name, text, seen, document):
        """Equations and sections that a document cites of itself."""
        article_rows = re.compile(r"^\| \(\d+\.\d+\).*?\|", re.M)
        rows = [found.span() for found in article_rows.finditer(text)]
        for found in EQUATION.finditer(text):
            inside = any(begin <= found.start() < end for begin, end in rows)
            default = text[found.start() - 2:found.start()] == "` "  # an option's value
            if found.start() not in seen and not inside and not default:
                self.check_item(name, text, found.start(), document, found[0])
        for found in re.finditer(r"(article,? )?\b(?:sections? (\d+(?:\.\d+)?)|(?:see|of) ([1-9]\d?\.\d+))\b", text):
            if not found[1]:
                group = 2 if found[2] else 3
                self.check_item(name, text, found.start(group), document, found[group])
        if document != "ALGORITHMS.md":
            return
        for row in re.finditer(r"^\| `\w+` \|[^|]*\|([^|]*)\|", text, re.M):  # the options' sections
            own = re.sub(r"METHOD\.md [\d.]+", "", row[1].split(":")[0])
            for item in re.finditer(r"\b\d+(?:\.\d+)?\b", own):
                self.check_item(name, text, row.start(1), document, item[0])

    def run(self):
        for name in self.files():
            (self.check_document if name.endswith(".md") else self.check_source)(name)
        text = read(os.path.join(self.root, BIBLIOGRAPHY))
        for key in self.keys:
            if key not in self.cited_keys:
                self.fail(BIBLIOGRAPHY, text, text.index("{" + key), "nobody cites %s" % key)
        return self.errors


def comments(text, name):
    """The text with everything but comments blanked out, comment marks too; offsets stay. Of .py files all lines without
    a comment are kept, since doc texts are among them."""
    mark = "#" if name.endswith((".py", ".sh")) else "//"
    lines = []
    for line in text.split("\n"):
        at = line.find(mark)
        if at < 0:
            lines.append(line if name.endswith(".py") else " " * len(line))
            continue
        begin = at + re.match(r"[/#<! ]*", line[at:]).end()
        lines.append(" " * begin + line[begin:])
    return "\n".join(lines)


if __name__ == "__main__":
    checker = Checker(sys.argv[1] if len(sys.argv) > 1 else ".")
    errors = checker.run()
    print("\n".join(errors) if errors else "%d citations, links and paths exist" % checker.count)
    sys.exit(1 if errors else 0)
