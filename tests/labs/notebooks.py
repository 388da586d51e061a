"""Executes the notebooks of the labs, with the solutions in the place of the scripts with gaps: every cell, as Jupyter does.

They are kept without outputs. Then each once more with the gaps open: the cell that runs the script has to name the gap.
"""
import os
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"          # no warnings of the kernel's debugger
TOP = Path(__file__).resolve().parents[2]


def execute(file, out, solution):
    """The notebook with its outputs; the environment goes on to the kernel."""
    os.environ.update(LAB_OUT=str(out), LAB_SOLUTION="1" if solution else "", BURNISH_TOP=str(TOP))
    notebook = nbformat.read(file, as_version=4)
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(file.parent)}}).execute()
    return notebook


def pictures(notebook):
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    return sum("image/png" in output.get("data", {}) for cell in code for output in cell.outputs)


def check(file, out):
    """Faults of a notebook."""
    kept = nbformat.read(file, as_version=4)
    nbformat.validate(kept)
    if any(cell.outputs or cell.execution_count for cell in kept.cells if cell.cell_type == "code"):
        yield "it is kept with outputs"
    try:
        drawn = pictures(execute(file, out, True))
        cells = sum("plt.subplots" in cell.source or "lab.picture()" in cell.source for cell in kept.cells)
        print(f"{file.parent.name}: {len(kept.cells)} cells, {drawn} pictures")
        if drawn != cells:
            yield f"{drawn} pictures are drawn, expected {cells}"
    except CellExecutionError as error:
        yield str(error)[-1500:]
    try:
        execute(file, out / "open", False)
        yield "no cell fails though the gaps are open"
    except CellExecutionError as error:
        if "gap 1 is open" not in str(error):
            yield f"the gap that is open is not named: {str(error)[-500:]}"


def main():
    files, wrong = sorted((TOP / "cases/labs").glob("*/*.ipynb")), 0
    with tempfile.TemporaryDirectory(dir=os.environ["SCRATCH"]) as out:
        for file in files:
            for fault in check(file, Path(out)):
                print(f"FAILED: {file.relative_to(TOP)}: {fault}")
                wrong += 1
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
