#!/usr/bin/env bash
# The manual becomes a site without a warning: formulas, references, tables of contents.
make docs || exit 1
# and a PDF of more than a hundred pages and less than 15 MB, whose outline has the first and the last chapter
"$PYTHON" - <<'END'
import os, re, subprocess
assert os.path.getsize("out/docs/burnish.pdf") < 15e6, "large PDF"
pdf = subprocess.run(["qpdf", "--qdf", "--object-streams=disable", "out/docs/burnish.pdf", "-"], stdout=subprocess.PIPE, check=True).stdout
pages, titles = len(re.findall(rb"/Type\s*/Page\b", pdf)), re.findall(rb"/Title\s*\((.*?)\)", pdf)
assert pages > 100, f"{pages} pages"
for chapter in (b"Install", b"Tutorial", b"Theory", b"Developing"):
    assert chapter in titles, f"the outline of the PDF lacks {chapter}"
print(f"PDF of {pages} pages")
END
# No page is wider than a window of 1100 pixels: one with code, shown with a line more that says by how much.
page=out/docs/edp/manual/tutorial.html wide=out/docs/edp/manual/wide.html
{ cat $page; echo '<script>onload = () => { document.title = "beyond: " + (document.documentElement.scrollWidth - innerWidth) }</script>'; } >$wide
said=$(chromium --headless --no-sandbox --disable-gpu --user-data-dir="$SCRATCH/browser" --window-size=1100,900 --dump-dom "file://$PWD/$wide" 2>/dev/null |
  grep -o '<title>beyond: [-0-9]*')
rm $wide
[ "${said#<title>beyond: }" -le 0 ] || { echo "FAILED: $page in a window of 1100 pixels: ${said#<title>}"; exit 1; }
