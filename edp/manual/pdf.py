"""The manual as a PDF, from the pages of the site: pdf.py SINGLE.html FILE.pdf     SINGLE.html: of Sphinx' singlehtml, theme basic.

Chromium prints it, with page numbers, an outline and a table of contents whose lines are links, pictures with the pixels that print; qpdf packs it. An
error where they do not.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

WIDE, HIGH = 180, 90       # of a printed picture, at most [mm]
DPI, COLORS = 115, 128     # of it, before Chromium shrinks the page to its widest table, to three quarters: 150
IMAGE = re.compile(r'(<img [^>]*src=")([^"]*\.png)"')
BODY = re.compile(r'<div class="body" role="main">(.*)<div class="clearer"></div>\s*</div>\s*</div>\s*</div>', re.DOTALL)
CONTENTS = re.compile(r'<h3><a href="[^"]*">Table of Contents</a></h3>\s*(.*?)\s*</div>\s*</div>', re.DOTALL)
STYLE = """
@page { size: A4; margin: 17mm 15mm; @bottom-center { content: counter(page); font: 9pt sans-serif; } }
body { font: 9.5pt/1.35 sans-serif; min-width: 0; margin: 0; background: white; }
h1 { break-before: page; } h1, h2, h3 { break-after: avoid; font-family: sans-serif; }
div.body { min-width: 0; max-width: none; padding: 0; } a.headerlink { display: none; }
pre, code { font-size: 7.2pt; } pre { white-space: pre-wrap; overflow-wrap: anywhere; padding: 4pt; background: #f6f6f6; }
code { overflow-wrap: anywhere; }
table { max-width: 100%%; font-size: 8pt; } td, th { overflow-wrap: anywhere; vertical-align: top; }
img { max-width: 100%%; max-height: %dmm; } figure { margin: 6pt 0; break-inside: avoid; } figcaption { font-size: 8.5pt; }
.equation-number { float: right; } math[display="block"] { margin: 5pt 0; }
.front { text-align: center; padding-top: 90mm; font-size: 20pt; } .contents { break-before: page; } a { color: #14456b; text-decoration: none; }
""" % HIGH


def one(pattern, page):
    found = pattern.search(page)
    if not found:
        sys.exit(f"pdf.py: the page of Sphinx has no {pattern.pattern[:40]}")
    return found[1]


def printed(single):
    """The page as it is printed: title, contents, chapters."""
    title = one(re.compile(r"<title>(.*?)</title>", re.DOTALL), single)
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
            f'<link rel="stylesheet" href="../../_static/pygments.css"><style>{STYLE}</style></head><body>'
            f'<div class="front">{title}<br><small>the manual</small></div>'
            f'<div class="contents"><h2>Contents</h2>{one(CONTENTS, single)}</div><div class="body">{one(BODY, single)}</div></body></html>')


def run(*words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit(f"pdf.py: {words[0]} ended with exit status {done.returncode}: {done.stdout[-400:]}")


def lighter(picture, folder):
    """The picture with no more pixels than are printed, in a folder; itself if it has no more."""
    with Image.open(picture) as drawn:
        shown = min(WIDE / 25.4, HIGH / 25.4 * drawn.width / drawn.height, drawn.width / 96)
        part = shown * DPI / drawn.width
        if part >= 1:
            return picture
        size = [max(1, round(part * side)) for side in drawn.size]
        drawn.convert("RGB").resize(size, Image.Resampling.LANCZOS).quantize(COLORS, dither=Image.Dither.NONE).save(folder / picture.name)
    return folder / picture.name


def main(source, target):
    page, pictures = Path(source).with_name("print.html"), Path(source).with_name("pictures")
    pictures.mkdir(exist_ok=True)

    def source_of(mark):
        return f'{mark[1]}{lighter((page.parent / mark[2]).resolve(), pictures.resolve()).as_uri()}"'

    page.write_text(IMAGE.sub(source_of, printed(Path(source).read_text())))
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / "plain.pdf"
        run("chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}", "--no-pdf-header-footer",
            "--generate-pdf-document-outline", f"--print-to-pdf={plain}", page.resolve().as_uri())
        run("qpdf", "--object-streams=generate", "--recompress-flate", "--compression-level=9", plain, target)
    print(target)


if __name__ == "__main__":
    main(*sys.argv[1:])
