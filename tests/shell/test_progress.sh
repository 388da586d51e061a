#!/usr/bin/env bash
# The progress line: on a terminal only, erased before record prints, gone at the end; nothing of it in a file.
set -eu
awk '/^```freefem/ { inside = 1; next } /^```/ && inside { exit } inside' README.md | sed 's/dtmax=0.05/dtmax=0.01/' >"$SCRATCH/run.edp"
"${PYTHON:-/usr/bin/python3}" - "$SCRATCH" "$BURNISH" <<'END'
import os, pty, re, subprocess, sys

os.chdir(sys.argv[1])
command = [sys.argv[2], "run.edp"]
told = bytearray()


def read(source):
    data = os.read(source, 4096)
    told.extend(data)
    return data


out, sys.stdout = os.dup(1), None
null = os.open(os.devnull, os.O_WRONLY)
os.dup2(null, 1)                                 # pty.spawn copies to its own output
status = os.waitstatus_to_exitcode(pty.spawn(command, read, lambda source: b""))
os.dup2(out, 1)
text = told.decode().replace("\r\n", "\n")
assert status == 0, (status, text[-500:])
lines = text.split("\n")
progress = re.findall(r"\r\x1b\[K  t = [0-9.e-]+  [0-9]+ %  steps [0-9]+  about [0-9]+ s left", text)
assert progress, "no progress on a terminal:\n" + text[:500]
for line in lines:
    shown = line.rpartition("\r\x1b[K")[2]       # what is left on the screen
    if shown.startswith("burnish: "):            # the end of the run: warnings, report
        break
    assert not shown or shown.startswith("t "), repr(line)
    assert "s left" not in shown, repr(line)
logged = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
assert logged.returncode == 0 and "\r" not in logged.stdout and "left" not in logged.stdout, logged.stdout[-500:]
os.write(1, f"{len(progress)} progress lines, {len(lines)} lines printed\n".encode())
END
