"""The pictures of a run in space: final, scene, sequence, pressure, section, history, expected; see plotting/case.py."""
from plotting import curves
from plotting.final import frame_at_work
from plotting.space import final as finals
from plotting.space import maps
from plotting.space import scene as scenes
from plotting.space.movie import write_movie  # noqa: F401
from plotting.space.run import SpaceRun


def final(run):
    return finals.final_figure(run)


def gallery(run):
    return finals.gallery_figure(run)


def work(run):
    frame = frame_at_work(run)
    return finals.final_figure(run, [t for t, _ in run.frames].index(frame[0]) if frame else -1)


def scene(run):
    return scenes.scene_figure(run)


def sequence(run):
    return scenes.sequence_figure(run)


def pressure(run):
    return maps.pressure_figure(run)


def section(run):
    return maps.section_figure(run)


def history(run):
    return curves.history_figure(run)


def expected(run):
    return curves.expected_figure(run)


DEFAULT = (final, scene, sequence, pressure, section, history, expected)


def space_run(run):
    """The same run, read as one in space."""
    other = SpaceRun(run.folder, None, run.given)
    other.mu = run.mu
    return other
