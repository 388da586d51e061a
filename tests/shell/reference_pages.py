"""Pages, help and files for editors of the reference are whole; writes the snippets as scripts beside them.

    reference_pages.py FOLDER    that generate.py has written

Every topic has its target in a page and is found by burnish help, every link has a target, JSON and XML are read.
"""
import json
import re
import sys
import xml.dom.minidom
from pathlib import Path

sys.path.insert(0, "edp/manual/reference")
import editors  # noqa: E402
import help as reference_help  # noqa: E402
import topics  # noqa: E402

# what a part of a scene needs around it
BEFORE = """include "burnish.idp"
mesh Th = square(12, 4, [0.02*x - 0.01, 0.01*(y - 1)]);
fespace Vh(Th, [P1, P1]);
Vh [u, v] = [0, 0];
varf bottom([u, v], [p, q]) = on(1, u=1, v=1);
real[int] held = bottom(0, Vh, tgv=1);
"""
PARTS = ["tool", "contact", "material", "program", "record"]
AFTER = "stepcontrol S(1., dtmax=0.5);\nrcRun(C, M, u[], S, program, record)\n"


def check_pages(folder, reference):
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.md")))
    targets = re.findall(r"^\(([\w-]+)\)=$", text, re.M) + re.findall(r'<span id="([\w-]+)">', text)
    wrong = [f"two targets {name}" for name in {name for name in targets if targets.count(name) > 1}]
    wrong += [f"no target for {key}" for key, topic in reference.topics.items() if topic.anchor not in targets]
    wrong += [f"no target of the link {name}" for name in set(re.findall(r"`\]\(([\w-]+)\)", text)) - set(targets)]
    return wrong


def check_help(reference):
    wrong = []
    for name in reference_help.all_names(reference) | set(reference.topics):
        lines = reference_help.lookup(name, reference)
        if lines is None or not "".join(lines).strip():
            wrong.append(f"burnish help {name} prints nothing")
    return wrong


def check_editors(folder, reference):
    json.loads((folder / "burnish.code-snippets").read_text(encoding="utf-8"))
    xml.dom.minidom.parse(str(folder / "burnish-kate.xml"))
    words = set((folder / "keywords.txt").read_text(encoding="utf-8").split())
    vim = (folder / "burnish.vim").read_text(encoding="utf-8")
    wanted = {"rcRun", "rcContact", "contact", "approach", "gaptolerance", "rcConverged", "rcQuiet"}
    return [f"no {word} for editors" for word in wanted if word not in words or not re.search(rf"\b{word}\b", vim)]


def write_scripts(folder):
    """Those that are whole as they are, and one of the parts."""
    bodies = {name: editors.filled(body) for name, _, body in editors.snippets()}
    for name in ("scene", "case"):
        coarse = bodies[name].replace("square(60, 20", "square(15, 5")
        (folder / f"snippet-{name}.edp").write_text(coarse + "\n", encoding="utf-8")
    parts = BEFORE + "\n".join(bodies[name] for name in PARTS) + "\n" + bodies["crank"] + "\n" + AFTER
    (folder / "snippet-parts.edp").write_text(parts, encoding="utf-8")


def main():
    folder, reference = Path(sys.argv[1]), topics.read_reference(Path(".").resolve())
    wrong = check_pages(folder, reference) + check_help(reference) + check_editors(folder, reference)
    write_scripts(folder)
    print("\n".join(wrong) if wrong else f"{len(reference.topics)} topics have pages and help")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
