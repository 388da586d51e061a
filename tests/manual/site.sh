#!/usr/bin/env bash
# The manual becomes a site without a warning: formulas, references, tables of contents.
make docs || exit 1
# and a PDF of more than a hundred pages, whose outline has the first and the last chapter
"$PYTHON" - <<'END'
import re
pdf = open("out/docs/burnish.pdf", "rb").read()
pages, titles = len(re.findall(rb"/Type\s*/Page\b", pdf)), re.findall(rb"/Title\s*\((.*?)\)", pdf)
assert pages > 100, f"{pages} pages"
for chapter in (b"Install", b"Tutorial", b"Theory", b"Developing"):
    assert chapter in titles, f"the outline of the PDF lacks {chapter}"
print(f"PDF of {pages} pages")
END
