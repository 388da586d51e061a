"""burnish new NAME: a folder NAME with a scene that runs, to be changed.

The last word of NAME, a path, names script and case: letters, digits, dashes. What exists is not overwritten: exit status 20.
"""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def made(path, name):
    """Writes the files of the template into a new folder; returns their names."""
    path.mkdir(parents=True)
    for template, target in (("scene.edp", f"{name}.edp"), ("README.md", "README.md"), ("plot.py", "plot.py")):
        text = (HERE / template).read_text()
        (path / target).write_text(re.sub(r"\bNAME\b", name, text).replace("FOLDER", str(path)))
        yield path / target


def main(words):
    if len(words) != 1:
        return "burnish new: expected one word, the name of the folder to be made"
    path = Path(words[0])
    name = path.name
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9-]*", name):
        return f'burnish new: the name is "{name}", expected a letter, then letters, digits, dashes'
    if path.exists():
        return f'burnish new: "{path}" exists already; nothing was changed'
    try:
        files = [str(file) for file in made(path, name)]
    except OSError as error:
        return f"burnish new: {error}"
    print(f"made {', '.join(files)}\nrun it:  burnish {files[0]}        its options:  burnish {files[0]} -h")
    return 0


if __name__ == "__main__":
    status = main(sys.argv[1:])
    if status:
        print(status, file=sys.stderr)
    sys.exit(20 if status else 0)
