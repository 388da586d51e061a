"""Links and anchors of a site: links.py FOLDER. Every local link must lead to a file, every #anchor to an id of its page."""
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """Links (href, src) and ids of a page."""

    def __init__(self, file):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            elif name in ("id", "name") and value:
                self.ids.add(value)


def wrong(folder, pages):
    """Messages, one for each link that leads nowhere."""
    for file, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if not target.exists():
                yield f"{file.relative_to(folder)}: {link} leads nowhere"
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].ids:
                yield f"{file.relative_to(folder)}: {link}: no such place on that page"


def main(name):
    folder = Path(name).resolve()
    pages = {file: Page(file) for file in sorted(folder.rglob("*.html"))}
    messages = list(wrong(folder, pages))
    for message in messages:
        print(message)
    print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {len(messages)} lead nowhere")
    return 1 if messages or not pages else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
