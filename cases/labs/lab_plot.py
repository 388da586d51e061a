"""What the plot.py of labs share: folder and file of the command line, answers, tables, a picture of fixed size."""
import csv
import io
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from plotting.figure import apply_style  # noqa: E402
from PIL import Image  # noqa: E402


def folder_and_file():
    """plot.py FOLDER [FILE]: the run's results, the picture; FOLDER/plot.png unless given. Ends with a line on bad input."""
    if len(sys.argv) < 2 or not Path(sys.argv[1]).is_dir():
        sys.exit(f"usage: {Path(sys.argv[0]).name} FOLDER [FILE]; FOLDER holds the results of a run: "
                 + (f"{sys.argv[1]} is none" if len(sys.argv) > 1 else "none is given"))
    folder = Path(sys.argv[1])
    apply_style()
    return folder, Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "plot.png"


def answers(folder):
    """{name: value} of answers.csv."""
    file = Path(folder) / "answers.csv"
    if not file.is_file():
        sys.exit(f"{file} is not there: the run has not come to its answers")
    with open(file, encoding="utf-8") as rows:
        return {row["name"]: float(row["value"]) for row in csv.DictReader(rows)}


def table(file, *needed):
    """{column: list of numbers} of a CSV file; needed: columns that it must have."""
    if not Path(file).is_file():
        sys.exit(f"{file} is not there")
    with open(file, encoding="utf-8") as text:
        rows = list(csv.DictReader(text))
    missing = [name for name in needed if not rows or name not in rows[0]]
    if missing:
        sys.exit(f"{file} has no column {missing[0]!r}: it is of another script")
    return {name: [float(row[name]) for row in rows] for name in (rows[0] if rows else {})}


def option(folder, name):
    """Value of an option of the run."""
    return json.loads((Path(folder) / "summary.json").read_text())["options"][name]


def save(figure, file):
    """The picture, always of the figure's size, in 256 colors."""
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=140)
    with Image.open(drawn) as picture:
        picture.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(file, optimize=True)
    print(file)
