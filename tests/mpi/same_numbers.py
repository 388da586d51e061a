"""Each scene on 1 process, on 2 whose work is not divided (the same bits), and on 2 and 3 that divide all of it (1e-8)."""
import sys

import ranks

ALLOWED = 1e-8
SCENES = [("tests/support/mpi-plane.edp", ["-pictures", "0", "-series", "0", "-check", "0"]),
          ("tests/support/mpi-plane.edp", ["-pictures", "0", "-series", "0", "-check", "0", "-scheme", "event"]),
          ("tests/support/mpi-space.edp", [])]


def main():
    scratch, wrong = sys.argv[1], 0
    for number, (script, options) in enumerate(SCENES):
        def output(processes, divided):
            out = ["-out", f"{scratch}/{number}-{processes}-{divided}"] if options else []
            status, text = ranks.run(processes, script, [*options, *out], divided)
            if status != 0:
                raise SystemExit(f"FAILED: {script} on {processes}: status {status}\n{text}")
            return text
        alone = output(1, False)
        runs = [(2, False, 0), (2, True, ALLOWED), (3, True, ALLOWED)]
        for processes, divided, allowed in runs[number > 0:]:
            apart = ranks.difference(alone, output(processes, divided))
            print(f"{script} {' '.join(options[6:])}, {processes} processes, divided {divided}: {apart:.1e} apart")
            wrong += not apart <= allowed
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
