"""The pictures of a case. A plot.py needs three lines after its docstring:

    import os, sys
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
    from plotting.case import main; sys.exit(main(sys.argv[1:]))

main(arguments, mu=None, columns=None, pictures=(), without=())
    mu        name of the option that holds the friction coefficient, for the bounds in the pressure picture
    columns   {column: (label, unit, factor)} of the history, None to leave it out; see plotting/units.py
    pictures  functions of the run that return a figure, drawn after the default ones into function-name.png
    without   names of default pictures not wanted
Default pictures: final (plotting/final.py), scene, stress, plastic_strain, stress_error, sequence, history, pressure, expected (see DEFAULT below); of a run in space those
of space/case.py. A script without a
plot.py gets them from plotting/scene.py.
"""
import os
import signal
import sys

from plotting import curves, fields
from plotting.figure import apply_style, save
from plotting.final import at_work, final_figure, gallery_figure
from plotting.inputs import InputError, MissingInput
from plotting.movie import write_movie
from plotting.run import Run
from plotting.start import start_figure


def final(run):
    return final_figure(run)


def gallery(run):
    return gallery_figure(run)


def work(run):
    """final.png of the last frame in which as many tools touch as ever."""
    return final_figure(run, at_work(run))


def scene(run):
    return start_figure(run)


def stress(run):
    return fields.field_figure(run, fields.STRESS)


def plastic_strain(run):
    if not run.field.data["plastic_strain_eq"].max() > 0:
        return None
    return fields.field_figure(run, fields.STRAIN)


def stress_error(run):
    """Where the mesh is coarser than the stress gradient, see ALGORITHMS.md 17."""
    if "stress_error" not in run.field.data or not run.field.data["stress_error"].max() > 0:
        return None
    return fields.field_figure(run, fields.ERROR)


def sequence(run):
    if len(run.series) < 3:
        return None
    plastic = run.field.data["plastic_strain_eq"].max() > 1e-3
    return fields.sequence_figure(run, fields.STRAIN if plastic else fields.STRESS)


def history(run):
    return curves.history_figure(run)


def pressure(run):
    return curves.pressure_figure(run, run.mu)


def expected(run):
    return curves.expected_figure(run)


DEFAULT = (final, scene, stress, plastic_strain, stress_error, sequence, history, pressure, expected)


def say(text):
    print(f"{os.path.basename(sys.argv[0])}: {text}", file=sys.stderr)


def draw_one(run, picture, folder, patient):
    """1 if the picture could not be drawn. One of an earlier run does not stay where there is none now."""
    name = picture.__name__.replace("_", "-")
    old = os.path.join(folder, name + ".png")
    if os.path.isfile(old):
        os.remove(old)
    try:
        figure = picture(run)
        if figure is not None:
            print(save(figure, folder, name), flush=True)
    except Exception as error:  # the other pictures may still be drawn
        if patient and isinstance(error, MissingInput):
            return 0
        say(f"{name}.png not made: {type(error).__name__}: {error}")
        return 1
    return 0


def draw_all(run, pictures, folder, patient=False):
    """Each picture into folder/function-name.png, whose path is printed; None: no picture. 1 if one could not be drawn.
    patient: a picture whose files are missing is left out."""
    apply_style()
    return max([draw_one(run, picture, folder, patient) for picture in pictures], default=0)


def make_movie(run, folder, write=write_movie):
    """movie.html and movie.gif, whose paths are printed; 1 if they could not be made."""
    apply_style()
    try:
        for path in write(run, folder):
            print(path, flush=True)
    except Exception as error:
        say(f"no movie: {type(error).__name__}: {error}")
        return 1
    return 0


def as_in_space(run, pictures):
    """The run as one in space, the default pictures of space in place of those of the plane, who writes the movie."""
    try:
        from plotting.space import case
    except ImportError as error:
        raise InputError(f"{error}; pictures of a run in space need the Debian packages python3-vtk9 and xvfb") from None
    if len(pictures) == 1:   # by its name
        return case.space_run(run), [getattr(case, pictures[0].__name__, pictures[0])], case.write_movie
    left_out = {p.__name__ for p in DEFAULT} - {p.__name__ for p in pictures}
    chosen = [p for p in case.DEFAULT if p.__name__ not in left_out] + [p for p in pictures if p not in DEFAULT]
    return case.space_run(run), chosen, case.write_movie


def draw(arguments, read_run, pictures, patient=False, read_plain=None):
    """The body of a plot.py OUTDIR [PICTURE|movie]: reads the run and draws its pictures, the one of that name alone, gallery and work too, or
    its movie; returns the exit code. read_plain: reads the Run of these three where read_run makes something else."""
    for name in (signal.SIGINT, signal.SIGPIPE):
        signal.signal(name, signal.SIG_DFL)  # stop quietly
    movie, named = arguments[1:] == ["movie"], {p.__name__.replace("_", "-"): p for p in (gallery, work, *pictures)}
    if not 0 < len(arguments) < 3 or arguments[0].startswith("-") or arguments[1:] and not movie and arguments[1] not in named:
        print(f"usage: {os.path.basename(sys.argv[0])} OUTDIR [movie|{'|'.join(named)}]    (the folder of a run's results)", file=sys.stderr)
        return 2
    if arguments[1:] and not movie:
        pictures = (named[arguments[1]],)
    try:
        plain = read_plain and arguments[1:] and arguments[1] in ("movie", "gallery", "work")
        run, write = (read_plain if plain else read_run)(arguments[0]), write_movie
        if isinstance(run, Run) and run.in_space:
            run, pictures, write = as_in_space(run, pictures)
    except InputError as error:
        say(error)
        return 1
    return make_movie(run, arguments[0], write) if movie else draw_all(run, pictures, arguments[0], patient)


def read_case(folder, mu, columns):
    """A run of a case; an InputError names every file that is missing."""
    missing = [path for path in (os.path.join(folder, name) for name in Run.FILES) if not os.path.isfile(path)]
    if os.path.isdir(folder) and missing:
        raise MissingInput("missing: " + ", ".join(missing))
    return Run(folder, mu, columns)


def main(arguments, mu=None, columns=None, pictures=(), without=()):
    chosen = [p for p in DEFAULT if p.__name__ not in without] + list(pictures)
    return draw(arguments, lambda folder: read_case(folder, mu, columns), chosen)
