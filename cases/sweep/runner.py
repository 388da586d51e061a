"""Runs variants of a study by GNU parallel and shows how far they are: lines that a terminal renews, plain ones elsewhere."""
import os
import shlex
import signal
import statistics
import subprocess
import sys
import time

from gather import asked_columns, read_summary, why
from request import read_text
from study import ended, finished
from values import SweepError

HERE = os.path.dirname(os.path.abspath(__file__))
PAUSE = 0.3       # seconds between two looks
MOST_SHOWN = 8    # running variants on the screen
TAIL = 4096       # bytes at the end of a history


class Stopped(Exception):
    """Ctrl-C, or SIGTERM."""


def command(study, name):
    return [os.path.join(HERE, "variant.sh"), study.place_of(name), os.environ["BURNISH"], study.request.script, *study.words(name)]


def started(study, listed):
    """The process that runs these variants, in a session of its own: Ctrl-C is ours to pass on. One alone runs by itself, others by GNU
    parallel. If this process is killed it gets a SIGTERM: no other run begins."""
    alone = len(listed) == 1 and not study.request.ssh
    words = command(study, listed[0]) if alone else parallel(study)
    path = os.path.join(study.folder, "commands.txt")
    with open(path, "w", encoding="utf-8") as file:
        file.write("".join(shlex.join(command(study, name)) + "\n" for name in listed))
    try:
        with open(path, encoding="utf-8") as file, open(os.path.join(study.folder, "parallel.txt"), "w", encoding="utf-8") as told:
            return subprocess.Popen(["setpriv", "--pdeathsig", "TERM", *words], stdin=file, stdout=told, stderr=subprocess.STDOUT,
                                    start_new_session=True, close_fds=False)
    except FileNotFoundError as error:
        sys.exit(f"burnish sweep: {error.filename} is missing; the Debian packages parallel and util-linux are needed")


def parallel(study):
    request = study.request
    words = ["parallel", "--will-cite", "--joblog", os.path.join(study.folder, "joblog.txt")]
    if request.ssh:
        words += ["--sshlogin", request.ssh, "--workdir", os.getcwd()]
    if not request.ssh or request.jobs != os.cpu_count():
        words += ["--jobs", str(request.jobs)]
    return words


def stop(process):
    """Runs and GNU parallel are ended at once; the variants under way count as not run."""
    for _ in range(2):  # the first one lets GNU parallel's runs go on to their ends
        process.terminate()
        time.sleep(PAUSE)
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        pass
    try:
        os.killpg(process.pid, signal.SIGKILL)  # the run of a variant that was alone
    except ProcessLookupError:
        pass


def time_of(folder):
    """t of the last line of the history, None without one."""
    try:
        with open(os.path.join(folder, "history.csv"), "rb") as file:
            file.seek(max(0, os.fstat(file.fileno()).st_size - TAIL))
            return float(file.read().decode(errors="replace").splitlines()[-1].split(",")[0])
    except (OSError, ValueError, IndexError):
        return None


def spoken(seconds):
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


class Progress:
    """What the screen says of a list of variants that run."""

    def __init__(self, study, listed, quiet):
        self.study, self.quiet = study, quiet
        self.waiting, self.done = list(listed), len(study.variants) - len(listed)
        self.seconds, self.began, self.drawn = [], {}, 0
        self.failed = 0
        self.terminal = sys.stdout.isatty() and not quiet

    def look(self):
        """Variants that ended since the last look get a line."""
        now = time.monotonic()
        for name in list(self.waiting):
            folder = self.study.place_of(name)
            if ended(folder):
                self.waiting.remove(name)
                self.done += 1
                self.seconds.append(now - self.began.pop(name, now - PAUSE))
                self.failed += not finished(folder)
                self.say(name, folder)
            elif name not in self.began and os.path.exists(os.path.join(folder, "log.txt")):
                self.began[name] = now
        if self.terminal:
            self.draw(now)

    def left(self, now):
        """Seconds to the end by the mean of those that have ended, None before the first one."""
        if not self.seconds or not self.waiting:
            return None
        mean = statistics.mean(self.seconds)
        under_way = sum(min(now - began, 0.9 * mean) for began in self.began.values())
        return (mean * len(self.waiting) - under_way) / min(self.study.request.jobs, len(self.waiting))

    def say(self, name, folder):
        if self.quiet:
            return
        self.clear()
        summary = read_summary(folder)
        results = list((summary.get("results") or {}).items())[:3]
        told = ", ".join(f"{n} {r['value']:.5g} {r.get('unit', '').strip('-')}".rstrip() for n, r in results if r.get("value") is not None)
        told = told if finished(folder) else f"FAILED: {why(folder, summary)}"
        left = self.left(time.monotonic())
        rest = f"; about {spoken(left)} left" if left and not self.terminal else ""
        print(f"[{self.done}/{len(self.study.variants)}] {name}: {told} ({self.seconds[-1]:.1f} s){rest}", flush=True)

    def clear(self):
        if self.drawn:
            print(f"\x1b[{self.drawn}A\x1b[J", end="")
            self.drawn = 0

    def draw(self, now):
        self.clear()
        left = self.left(now)
        lines = [f"{self.study.name}: {self.done} of {len(self.study.variants)} ended, {self.failed} failed, {len(self.began)} running"
                 + (f", about {spoken(left)} left" if left is not None else "")]
        for name, began in list(self.began.items())[:MOST_SHOWN]:
            t = time_of(self.study.place_of(name))
            lines.append(f"  {name}  {now - began:.0f} s" + (f"  t = {t:.3g}" if t is not None else ""))
        width = os.get_terminal_size().columns - 1
        print("\n".join(line[:width] for line in lines), flush=True)
        self.drawn = len(lines)


def raise_stopped(*_):
    raise Stopped


def run(study, listed, quiet=False):
    """Runs these variants to their ends. Stopped: by a signal; the same command goes on. SweepError: -draw names what the first of them
    to finish does not have; the others are ended."""
    for name in [n for n in listed if not os.path.exists(os.path.join(study.place_of(n), "run-1.checkpoint"))]:
        log = os.path.join(study.place_of(name), "log.txt")
        if os.path.exists(log):
            os.remove(log)  # of a run that was killed
    if not listed:
        return
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, raise_stopped)
    process, progress = started(study, listed), Progress(study, listed, quiet)
    unseen = bool(study.request.draw)
    try:
        while process.poll() is None:
            progress.look()
            unseen = unseen and not asked_columns(study)
            time.sleep(PAUSE if not quiet else PAUSE / 6)
        progress.look()
        progress.clear()
    except (Stopped, KeyboardInterrupt):
        progress.clear()
        stop(process)
        raise Stopped from None
    except SweepError:
        progress.clear()
        stop(process)
        raise
    if progress.waiting:
        told = read_text(os.path.join(study.folder, "parallel.txt")).strip().splitlines()
        sys.exit(f"burnish sweep: {len(progress.waiting)} variants did not run: " + (told[-1] if told else "GNU parallel was ended") +
                 "; the same command runs the rest")
