#!/usr/bin/python3
"""Plot of lab 8: plot.py FOLDER [FILE]; FOLDER: results of lab.edp; runs in folders inside of it are drawn beside it"""
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ.get("BURNISH_TOP") or Path(__file__).resolve().parents[3]) / "cases/labs"))
from lab_plot import answers, folder_and_file, option, save, table  # noqa: E402
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, PURPLE, RED, new_figure  # noqa: E402


def main():
    folder, file = folder_and_file()
    runs = [folder, *sorted(f.parent for f in folder.glob("*/answers.csv"))]
    figure, axes = new_figure(6.4, 7.6, nrows=2)
    for run, color in zip(runs, (BLUE, ORANGE, GREEN, RED, PURPLE, GRAY)):
        history, profile = table(run / "history.csv", "depth"), table(run / "profile.csv")
        label = f"r {option(run, 'r'):g} mm, b {option(run, 'b'):g} deg, depth {option(run, 'depth'):.4g} mm"
        axes[0].plot(history["depth"], history["force"], color=color, label=label)
        axes[1].plot(profile["x"], profile["y"], color=color, label=f"groove {answers(run)['groove']:.3f} mm")
    axes[0].set(xlabel="depth of the tool [mm]", ylabel="force [N/mm]", title="Pressed and lifted")
    axes[1].set(xlabel="x [mm]", ylabel="y [mm]", title="The groove that stays (half)", xlim=(0, 4))
    for place in axes:
        place.legend()
    save(figure, file)


if __name__ == "__main__":
    main()
