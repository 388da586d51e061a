"""Writes the reference: pages for the site, its text, files for editors.

    generate.py FOLDER    of the results, made if it is missing; FreeFEM is not needed
"""
import sys
from pathlib import Path

import editors
import heads
import pages
import plain
import topics


def main(words):
    if len(words) != 1 or words[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 20
    folder = Path(words[0])
    try:
        reference = topics.read_reference()
        files = {**pages.Pages(reference).all(), **editors.all_files(reference)}
        files["help.txt"] = "\n".join(plain.everything(reference)) + "\n"
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")
    except heads.HeadError as error:
        print(f"reference: {error}", file=sys.stderr)
        return 20
    except OSError as error:
        print(f"reference: {error.filename}: {error.strerror}", file=sys.stderr)
        return 5
    print(f"{len(reference.topics)} topics in {len(files)} files, {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
