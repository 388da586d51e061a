"""The names of scripts as a Sphinx domain: in objects.inv, in the search, in an index, and as links from the code of all pages.

Their places are the anchors of the reference, which edp/manual/reference/pages.py has written; other sites refer to them as burnish:name.
"""
import re
import sys
from pathlib import Path

from sphinx.domains import Domain, Index, ObjType

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "reference"))
import topics  # noqa: E402

FOLDER = "out/reference"
KINDS = ("constructor", "method", "member", "function", "macro", "setting", "constant")
# in the code that Pygments has colored: a word, or one behind a point
WORD = re.compile(r'(?<!">)(<span class="n[cfv]?">)(rc[A-Z]\w+)(</span>)|'
                  r'(<span class="n">\w+</span><span class="p">\.</span><span class="n">)(\w+)(</span>)')
CODE = re.compile(r'<div class="highlight-cpp.*?</pre>', re.DOTALL)


def places():
    """{name: (kind, page, anchor)} of what is called in a script."""
    return {key: (topic.kind, f"{FOLDER}/{topic.page}", topic.anchor)
            for key, topic in topics.read_reference().topics.items() if topic.kind in KINDS}


class Names(Index):
    name, localname, shortname = "names", "Names of scripts", "names"

    def generate(self, docnames=None):
        letters = {}
        for key, (kind, page, anchor) in sorted(self.domain.places.items(), key=lambda one: one[0].split(".")[-1].lower()):
            entry = (key.split(".")[-1], 0, page, anchor, key.split(".")[0] if "." in key else kind, "", "")
            letters.setdefault(entry[0].removeprefix("rc")[:1].upper(), []).append(entry)
        return sorted(letters.items()), True


class Burnish(Domain):
    name, label, indices = "burnish", "Burnish", [Names]
    object_types = {kind: ObjType(kind, "name") for kind in KINDS}
    places = {}

    def get_objects(self):
        for key, (kind, page, anchor) in self.places.items():
            yield key, key, kind, page, anchor, 1

    def resolve_any_xref(self, env, fromdocname, builder, target, node, contnode):
        return []               # pages refer to the reference by its anchors

    def merge_domaindata(self, docnames, otherdata):
        pass


def linked(app, page, template, context, doctree):
    """Names in the code of a page lead to their entries; a member does where one type alone has it."""
    if "body" not in context or page.startswith(FOLDER):
        return
    members = {}
    for key in Burnish.places:
        members.setdefault(key.split(".")[-1], []).append(key)

    def link(word):
        before, name, after = [part for part in word.groups() if part is not None]
        keys = members.get(name, []) if word[4] else [name] if name in Burnish.places else []
        if len(keys) != 1:
            return word[0]
        _, target, anchor = Burnish.places[keys[0]]
        return f'{before}<a class="name" href="{app.builder.get_relative_uri(page, target)}#{anchor}">{name}</a>{after}'

    context["body"] = CODE.sub(lambda code: WORD.sub(link, code[0]), context["body"])


def setup(app):
    Burnish.places = places()
    app.add_domain(Burnish)
    app.connect("html-page-context", linked)
    return {"parallel_read_safe": False}
