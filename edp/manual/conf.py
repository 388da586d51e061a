"""The site of the manual: Sphinx with MyST reads the pages where they lie in the tree; make docs."""
import re
import sys
from pathlib import Path

import furo

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path.insert(0, str(HERE))
import runs  # noqa: E402

project, author, copyright = "Burnish", "the authors of Burnish", "the authors of Burnish, GPL-3.0-or-later"
release = version = re.search(r'BURNISH_VERSION "(.*)"', (TOP / "cxx/base/version.hpp").read_text())[1]
root_doc = "edp/manual/index"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "cxx/*.md", "cases/README.md", "cases/*/README.md", "cases/labs/*.md",
                    "cases/labs/*/*.md", "tests/chart/*.md", "tests/peers/README.md", "edp/manual/*.md", "edp/manual/*/*.md", "out/reference/*.md"]
exclude_patterns = ["build/**", "**/key.md", "out/docs/**"]
extensions = ["myst_parser", "mathml", "sphinx_copybutton", "domain", "excerpts"]
source_suffix = {".md": "markdown"}
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 4
myst_dmath_allow_labels = False
suppress_warnings = ["misc.highlighting_failure"]
highlight_language = "none"
html_theme = "basic" if "singlehtml" in sys.argv else "furo"   # for pdf.py
# Debian's style sheet lacks the colors of a system that is dark, its theme's sources have them
dark = re.search(r"@mixin colors-dark \{(.*?)\n\}", (Path(furo.__file__).parent / "assets/styles/variables/_colors.scss").read_text(), re.DOTALL)[1]
html_theme_options = {} if html_theme == "basic" else {"dark_css_variables": dict(re.findall(r"--([\w-]+): ([^;]+);", dark))}
html_title = f"Burnish {version}"
html_static_path = ["static"]
html_css_files, html_js_files = ["burnish.css"], ["theme.js"]
html_copy_source = False
html_domain_indices = ["burnish-names"]
html_show_sphinx = False
html_math_renderer = "mathml"

TARGET = re.compile(r"\]\(([^)#\s]+/)\)")
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)#\s]+/)\)")
FENCES = {"freefem": "cpp"}


def to_site(app, document, source):
    """Links to a folder go to its README, or are left out; scripts are colored as C++; the page of a case ends with its scripts."""
    folder = TOP / Path(document).parent

    def readme(link):
        page = Path(link[1]) / "README.md"
        return f"]({page})" if (folder / page).is_file() else link[0]

    text = runs.shown(LINK.sub(r"\2", TARGET.sub(readme, source[0])), TOP / "out/manual")
    for name, other in FENCES.items():
        text = re.sub(rf"^```{name}\b.*$", f"```{other}", text, flags=re.MULTILINE)
    if app.builder.name == "html":   # pdf.py writes it
        text = text.replace("<!-- the manual as a PDF -->", '<a href="../../burnish.pdf">The manual as a PDF</a>')
    scripts = sorted(folder.glob("*.edp")) if document.startswith("cases/") else []
    if scripts:
        text += "\n\nScripts: " + ", ".join(f"{{download}}`{script.name}`" for script in scripts) + "\n"
    source[0] = text


def setup(app):
    app.connect("source-read", to_site)
