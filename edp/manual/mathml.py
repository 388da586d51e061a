"""Formulas as MathML, which browsers draw without JavaScript: all of a site by one run of pandoc."""
import html
import re
import subprocess

from docutils import nodes
from sphinx.errors import ExtensionError

TAG = re.compile(r"\\tag\{([^}]*)\}")
MATH = re.compile(r"<math.*?</math>", re.DOTALL)


def key(node):
    """What tells formulas apart: the text and whether it stands alone."""
    return (node.astext().strip(), isinstance(node, nodes.math_block))


def converted(formulas):
    """MathML of each formula. A formula that pandoc cannot read is an error."""
    lines = [f"$${TAG.sub('', text)}$$" if alone else f"${text}$" for text, alone in formulas]
    source = "\n\n".join(line.replace("\n", " ") for line in lines)
    done = subprocess.run(["pandoc", "-f", "markdown-auto_identifiers", "-t", "html", "--mathml", "--wrap=none"], input=source, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    found = MATH.findall(done.stdout)
    if done.returncode or done.stderr or len(found) != len(formulas):
        raise ExtensionError(f"pandoc: {len(found)} of {len(formulas)} formulas: {done.stderr}")
    return dict(zip(formulas, (re.sub(r"<annotation.*?</annotation>", "", one, flags=re.DOTALL) for one in found)))


def collect(app, env):
    """Before the pages are written: every formula of every page."""
    formulas = []
    for document in sorted(env.found_docs):
        formulas += [key(node) for kind in (nodes.math, nodes.math_block) for node in env.get_doctree(document).findall(kind)]
    env.mathml = converted(list(dict.fromkeys(formulas))) if formulas else {}


def of(writer, node):
    formula = key(node)
    known = writer.builder.env.mathml
    if formula not in known:     # of a page that another includes
        known.update(converted([formula]))
    return known[formula]


def inline(writer, node):
    writer.body.append(of(writer, node))
    raise nodes.SkipNode


def alone(writer, node):
    tag = TAG.search(node.astext())
    number = f'<span class="equation-number" id="equation-{html.escape(tag[1])}">({html.escape(tag[1])})</span>' if tag else ""
    writer.body.append(f'<div class="math">{number}{of(writer, node)}</div>\n')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (inline, None), (alone, None))
    app.connect("env-updated", collect)
    return {"parallel_read_safe": False}
