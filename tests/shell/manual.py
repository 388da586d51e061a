"""The manual's code: every block of a script occurs, line for line, in the script that the comment before it names, and that
script is run; every command names a target, a script and options that exist.

manual.py           checks edp/manual/*.md; prints what is wrong, exit status 1
manual.py --scripts prints the scripts of edp/manual/examples that pages show, for the test that runs them
"""
import re
import shlex
import subprocess
import sys
from os import environ
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
MANUAL = TOP / "edp/manual"
BLOCK = re.compile(r"(?:<!-- from (\S+) -->\n)?^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
RUN = ("edp/manual/examples/", "cases/", "tests/verification/")   # folders whose scripts a test runs


def scripts_of(page):
    """Origin and lines of the blocks that show a script."""
    for origin, kind, text in BLOCK.findall(page.read_text()):
        if origin or kind == "freefem":
            yield origin, [line.rstrip() for line in text.splitlines()]


def occurs(lines, whole):
    return any(whole[k:k + len(lines)] == lines for k in range(len(whole) - len(lines) + 1))


def wrong_scripts(page):
    for origin, lines in scripts_of(page):
        if not origin.startswith(RUN):
            yield f"a block does not say which script it is from: {lines[0]}"
        elif not (TOP / origin).is_file():
            yield f"{origin} does not exist"
        elif not occurs(lines, [line.rstrip() for line in (TOP / origin).read_text().splitlines()]):
            yield f"{origin} does not have these lines: {lines[0]} ..."


def options_of(script):
    """Names of the options that a script has."""
    said = subprocess.run([environ["BURNISH"], str(script), "-options", "list"], cwd=TOP, stdout=subprocess.PIPE, text=True)
    return re.findall(r'"(-?[\w-]+)":', said.stdout)


def wrong_command(words, targets):
    """What is wrong with one command of a sh block, or ""."""
    if words[0] == "make":
        goals = [w for w in words[1:] if not w.startswith("-") and "=" not in w]
        unknown = [g for g in goals if g not in targets and not (g.startswith("case-") and (TOP / "cases" / g[5:]).is_dir())]
        return f"no target {unknown[0]}" if unknown else ""
    if words[0] == "build/burnish" and len(words) > 1 and words[1].endswith(".edp"):
        script = TOP / words[1]
        if words[1] == "press/press.edp":    # what `burnish new press` makes
            script = Path(environ["SCRATCH"]) / words[1]
        if not script.is_file():
            return f"no script {words[1]}"
        known = options_of(script)
        unknown = [w for w in words[2:] if re.fullmatch(r"-[a-zA-Z]\w*", w) and w != "-h" and w.lstrip("-") not in known and w not in known]
        return f"{words[1]} has no option {unknown[0]}" if unknown else ""
    if words[0] == "/usr/bin/python3":
        return "" if len(words) > 1 and (TOP / words[1]).is_file() else f"no script {words[1:2]}"
    return "" if words[0] in ("build/burnish", "burnish") else f"unknown command {words[0]}"


def wrong_commands(page, targets):
    for origin, kind, text in BLOCK.findall(page.read_text()):
        if kind == "sh":
            for line in text.splitlines():
                words = shlex.split(line, comments=True)
                said = wrong_command(words, targets) if words else ""
                if said:
                    yield f"{line}: {said}"


def said():
    """All texts in quotation marks of the core and the library, joined where one goes on in the next."""
    files = [*TOP.glob("cxx/**/*.cpp"), *TOP.glob("plugins/*.cpp"), *TOP.glob("edp/**/*.idp")]
    source = "\n".join(path.read_text() for path in files).replace('\\"', "'")
    return re.sub(r'"\s*\n?\s*(?:<<)?\s*"', "", source)


def wrong_words(page, sources):
    """Messages of a run that a page quotes, the first cells of its tables in italics, are those of the code."""
    for cell in re.findall(r"^\| (\*.*?\*) \|", page.read_text(), re.MULTILINE):
        for words in re.findall(r"\*([^*]+)\*", cell):
            for part in re.split(r"\.\.\.|\"[^\"]*\"|\d+", words):
                if len(part.strip()) > 3 and part.strip(" ,") not in sources:
                    yield f"no message holds \"{part.strip()}\""


def main(pages):
    targets = set(re.findall(r"^([a-z-]+):", (TOP / "Makefile").read_text(), re.MULTILINE))
    sources = said()
    messages = [f"{page.name}: {text}" for page in pages
                for text in [*wrong_scripts(page), *wrong_commands(page, targets), *wrong_words(page, sources)]]
    blocks = sum(len(list(scripts_of(page))) for page in pages)
    print(*messages, f"{len(pages)} pages, {blocks} blocks of scripts, {len(messages)} wrong", sep="\n")
    return 1 if messages or not blocks else 0


if __name__ == "__main__":
    if "--scripts" in sys.argv:
        shown = {origin for page in MANUAL.glob("*.md") for origin, _ in scripts_of(page) if origin.endswith(".edp")}
        print(*sorted(name for name in shown if name.startswith(RUN[0])), sep="\n")
    else:
        folders = [Path(a) for a in sys.argv[1:]] or [MANUAL]
        sys.exit(main([page for folder in folders for page in sorted(folder.glob("*.md"))]))
