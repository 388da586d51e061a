"""burnish sweep SCRIPT.edp NAME=VALUES ... [-option value ...]: runs a script for every combination of some of its options, side by side.

  burnish sweep press.edp R=5:15:3 mu=0.1,0.2 -steps 50
  burnish sweep press.edp target="depth=0.1" force=100:2000
Words: request.py, ways to write values: values.py, goals: goal.py. The study's folder is out/sweep/NAME: its page index.html (page.py),
sweep.csv, and a folder for each variant. The same command goes on with what is missing. Exit status 0: the study is whole, variants
that failed are listed; 1: a goal is not reached, or every variant failed; 20: what cannot be run; 130: stopped, the same command goes on.
"""
import sys

from gather import rows_of, write_csv
from request import read_request
from runner import Stopped, run
from study import Study
from values import Failed, SweepError

USAGE = """usage: burnish sweep SCRIPT.edp NAME=VALUES ... [-option value ...]
  R=14:20:4  E=1e3:1e6:7:log  mu=0.1,0.2  element=P1,P2    values; R=5:15:latin, also random, morris, with -samples 20 -seed 1
  -study NAME    folder out/sweep/NAME       -again 1, -again "-steps 400"    failed variants once more
  -jobs 4        runs at a time              -ssh host1,host2                 other machines
  target="depth=0.1" force=100:2000          the value of an option for a result; also minimize= maximize= where= measured= within=
  burnish help sweep                         the page of the manual"""


def list_failed(study, rows):
    """@returns whether every variant failed"""
    failed = [(name, row) for name, row in zip(study.variants, rows) if row["status"] != "finished"]
    if failed:
        print(f"{len(failed)} of {len(rows)} variants failed; -again 1 tries them once more:")
    for name, row in failed:
        print(f"  {name}: {row.get('reason', row['status'])}")
    return len(failed) == len(rows) > 0


def begin(study):
    """Says what the study is, makes ready what is tried again or lies in other studies."""
    request = study.request
    if request.again is not None:
        print(f"{study.try_again()} failed variants are tried again")
    copied = study.adopt()
    if request.goals:
        print(f"{study.name}: {', '.join(study.request.vary)} for {', '.join(f'{k}={v}' for k, v in request.goals.items())}; {study.folder}")
        return
    done = len(study.variants) - len(study.missing())
    print(f"{study.name}: {len(study.variants)} variants" + (f", {done} ended before" if done else "")
          + (f" ({copied} of them in another study)" if copied else "") + f"; {study.folder}", flush=True)


def finish(study, answer):
    """Table, page, pictures that are asked for."""
    study.write()
    columns, rows = rows_of(study)
    write_csv(f"{study.folder}/sweep.csv", columns, rows)
    try:
        from parquet import write_parquet
        write_parquet(f"{study.folder}/sweep.parquet", columns, rows)
    except ImportError as missing:
        print(f"no sweep.parquet: {missing} (python3-thrift)")
    if list_failed(study, rows):
        print("burnish sweep: every variant failed", file=sys.stderr)
        return 1
    from page import write_page  # what takes long to load: not before it is needed
    print(write_page(study, rows, answer))
    if not study.request.draw:
        return 0
    from plot import draw_asked
    return draw_asked(study, columns, rows)


def main(words):
    if not words or {"-h", "--help"} & {words[0], words[-1]}:
        print(USAGE)
        return 0 if words else 20
    study, goal = Study(read_request(words)), None
    if study.request.goals:
        from goal import chosen_goal, reach
        goal = chosen_goal(study)
    study.open()
    begin(study)
    answer, unreached = None, None
    if goal:
        try:
            answer = reach(study, goal)
        except Failed as error:
            unreached = error
    else:
        run(study, study.missing())
    status = finish(study, answer)
    if unreached:
        print(f"burnish sweep: {unreached}", file=sys.stderr)
    return 1 if unreached else status


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except SweepError as wrong:
        print(f"burnish sweep: {wrong}", file=sys.stderr)
        sys.exit(20)
    except (Stopped, KeyboardInterrupt):
        print("burnish sweep: stopped; the same command runs the rest", file=sys.stderr)
        sys.exit(130)
