"""Excerpts in the search of a site that is read from files, where a browser fetches nothing: the text of all pages beside the search page."""
import html
import json
import re
from pathlib import Path

MARKUP = re.compile(r"<(script|style|math)\b.*?</\1>|<[^>]+>", re.DOTALL)
SCRIPT = """if (location.protocol === "file:") window.fetch = url => Promise.resolve({text: () => Promise.resolve(
  `<div role="main">${excerpts[String(url).replace(/^\\.\\//, "").replace(/\\.html$/, "")] || ""}</div>`)});
"""
texts = {}


def keep(app, page, template, context, doctree):
    if page == "search":
        app.add_js_file("excerpts.js")
    elif "body" in context:
        texts[page] = html.escape(" ".join(html.unescape(MARKUP.sub(" ", context["body"])).split()))


def write(app, error):
    if not error:
        (Path(app.outdir) / "_static/excerpts.js").write_text(f"const excerpts = {json.dumps(texts)};\n{SCRIPT}")


def setup(app):
    app.connect("html-page-context", keep)
    app.connect("build-finished", write)
    return {"parallel_read_safe": False}
