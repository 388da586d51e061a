"""Holds the tables of cxx/NAMES.md against the tree, and the options of cxx/ALGORITHMS.md against the structures.

    names.py [FOLDER]     of the project; the present one unless given

Every name of the columns C++, Script, CSV and VTU must occur: C++ names in cxx/ (`Type::member` in a file that declares the
type), names of scripts in plugins/ or edp/ (members and named parameters as texts in plugins/, or in the tables of the
core that the plugin reads), columns in the writers of edp/ and cxx/output or in the names of events in cxx/contact. A pair of names in a row that breaks the rule of NAMES.md must be in the table of exceptions; an exception that
no row needs is an error too. Prints file:line and what is wrong; exit status 1 if there is anything.
"""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../edp/manual/reference"))
from settings import SOURCE, read_settings  # noqa: E402

NAMES, ALGORITHMS = "cxx/NAMES.md", "cxx/ALGORITHMS.md"
WRITERS = ["edp/cases/rcHistory.idp", "edp/cases/rcOutput.idp", "edp/cases/rcSummary.idp", "edp/run/rcRunState.idp", "cxx/contact/events.cpp",
           "cxx/output/workpiece_file.cpp", "cxx/output/contact_files.cpp"]
SHORT = [("anderson_memory", "memory"), ("elements", "elementevents")]  # their structures say the rest
OPTION_FILES = ["cxx/iteration/options.hpp", "cxx/run/step_control.hpp", "cxx/run/stepper.hpp",
                "cxx/run/step_scheme.hpp", "cxx/material/update_options.hpp"]


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def tree(root, folders, endings):
    texts = {}
    for folder in folders:
        for at, _, files in os.walk(os.path.join(root, folder), followlinks=True):
            for name in sorted(files):
                if name.endswith(endings):
                    path = os.path.join(at, name)
                    texts[os.path.relpath(path, root)] = read(path)
    return texts


def coded(cell):
    return re.findall(r"`([^`]+)`", cell)


def rows(text):
    """Line number and cells of the rows of all tables, with the header of their table."""
    header = None
    for number, line in enumerate(text.split("\n"), 1):
        if not line.startswith("|"):
            header = None
        elif header is None:
            header = [cell.strip() for cell in line.strip("|").split("|")]
        elif not re.match(r"\|[-| ]+$", line):
            yield number, header, [cell.strip() for cell in re.sub(r"^\||\|$", "", line).split("|")]


def bare(name):
    """The last part of a name, without marks of its column: C.normalforce, tolerance=, "pieces"."""
    return re.split(r"::|\.", name.strip('"').rstrip("="))[-1]


def by_rule(cpp):
    """Names of a script that the rule gives for a C++ name."""
    words = bare(cpp)
    if words.isupper() and len(words) > 1:  # an enumerator: a text, or a constant
        return {words.lower().replace("_", "-"), "rc" + "".join(word.capitalize() for word in words.split("_"))}
    plain = words.replace("_", "")
    return {plain, "rc" + plain[0].upper() + plain[1:]}


class Checker:
    def __init__(self, root):
        self.root, self.errors, self.count = root, [], 0
        core = tree(root, ["cxx"], (".hpp", ".cpp"))
        plugins = "\n".join(tree(root, ["plugins"], (".hpp", ".cpp")).values())
        library = "\n".join(tree(root, ["edp"], (".idp",)).values())
        self.core_words, self.members = set(), {}  # members: words of the files that declare a type
        self.core_text = "\n".join(core.values())
        for text in core.values():
            words = {re.sub("^m_", "", word) for word in re.findall(r"\w+", text)}
            self.core_words |= words
            for kind in re.findall(r"\b(?:struct|class) (\w+)[^;{}()]*\{", text):
                self.members[kind] = self.members.get(kind, set()) | words
        self.components = set(re.findall(r'"(\w+)"', "".join(re.findall(r"stress_names(\{.*?\});", self.core_text))))
        self.core_words |= set(re.findall(r"\w+", plugins))
        self.script_words = set(re.findall(r"\w+", plugins + library))
        texts = lambda text: set(re.findall(r'"[^"\n]*"', text))
        self.plugin_texts, self.core_texts = texts(plugins), texts("\n".join(core.values()))
        self.library_texts = texts(library)
        self.writers = "\n".join(read(os.path.join(root, path)) for path in WRITERS)

    def fail(self, path, line, message):
        self.errors.append("%s:%d: %s" % (path, line, message))

    def has_cpp(self, name):
        kind, _, member = name.rpartition("::")
        return member in (self.members.get(kind, set()) if kind else self.core_words)

    def has_script(self, name):
        text = '"%s"' % bare(name)
        if name.startswith("rc"):
            return name in self.script_words
        if name.endswith("="):  # a named parameter; the core's tables hold some
            return text in self.plugin_texts or text in self.core_texts
        if name.startswith('"'):
            return name in self.plugin_texts | self.library_texts | self.core_texts
        return text in self.plugin_texts

    def has_column(self, name):
        """As it stands, or joined when it is written: a component of a tensor, or of a resultant after what acts."""
        base, _, component = name.rpartition("_")
        if component in self.components and '"%s"' % base in self.writers:
            return True
        if (not base or '"%s_"' % base in self.writers) and re.search('[",]%s[",]' % component, self.writers):
            return True
        return re.search(r"(?<![A-Za-z0-9_-])%s(?![A-Za-z0-9-]|_[a-z])" % re.escape(name), self.writers)

    def check_names(self):
        exceptions, used = {}, set()
        table = list(rows(read(os.path.join(self.root, NAMES))))
        for line, header, cells in table:
            if header[0] in ("C++", "Name"):
                exceptions[(coded(cells[0])[0], coded(cells[1])[0])] = line
        for line, header, cells in table:
            if header[0] == "Quantity":
                if len(cells) != len(header):
                    self.fail(NAMES, line, "%d cells, expected %d" % (len(cells), len(header)))
                    continue
                self.check_row(line, dict(zip(header, cells)), exceptions, used)
        for pair, line in exceptions.items():
            if pair not in used:
                self.fail(NAMES, line, "no row needs the exception %s, %s" % pair)

    def check_row(self, line, row, exceptions, used):
        cpp, script = coded(row["C++"]), coded(row["Script"])
        files = coded(row["CSV, JSON"]) + coded(row["VTU"])
        for column, names, found in [("C++", cpp, self.has_cpp), ("script", script, self.has_script),
                                     ("file", files, self.has_column)]:
            for name in names:
                self.count += 1
                if not found(name):
                    self.fail(NAMES, line, "the %s name %s does not occur" % (column, name))
        if cpp:
            for name in script:
                self.check_pair(line, cpp, bare(name), by_rule, exceptions, used)
        if cpp or script:
            other = cpp or [bare(name) for name in script]
            for name in files:
                self.check_pair(line, other, name, self.in_files, exceptions, used)

    @staticmethod
    def in_files(name):
        """Names of files that the rule gives for a C++ name; for a name that only scripts have: rcReason, reason."""
        words = bare(name)
        if words.isupper() and len(words) > 1:
            return {words.lower().replace("_", "-")}
        if re.match("rc[A-Z]", words):
            words = re.sub("(?<!^)([A-Z])", r"_\1", words[2:]).lower()
        return {words} | {words + "_" + end for end in ("xx", "yy", "zz", "xy", "max", "deg")}

    def check_pair(self, line, cpp, name, rule, exceptions, used):
        """One of the C++ names in the row must give this name by the rule, or be listed with it."""
        self.count += 1
        if any(name in rule(one) for one in cpp):
            return
        listed = [(bare(one), name) for one in cpp if (bare(one), name) in exceptions]
        used.update(listed)
        if not listed:
            self.fail(NAMES, line, "%s and %s break the rule and are no exception" % (", ".join(map(bare, cpp)), name))

    def structures(self):
        """Members of the option structures with their defaults: {structure: {member: default}}."""
        found = {}
        for path in OPTION_FILES:
            text = re.sub(r"//[^\n]*", "", read(os.path.join(self.root, path)))
            for name, body in re.findall(r"struct (\w+Options) \{(.*?)\n\};", text, re.S):
                members = found.setdefault(name, {})
                for kind, declared in re.findall(r"^\s*([\w:<>, ]+?)\s+([A-Za-z_]\w*[^;()]*);", body, re.M):
                    braced = re.match(r"(\w+)\{(.*)\}$", declared.strip())
                    if braced:
                        members[braced[1]] = braced[2]
                        continue
                    for part in declared.split(","):
                        member, _, default = part.partition("=")
                        members[member.strip()] = default.strip() or {"SchemeOptions": "SchemeOptions"}.get(kind, "none")
        return found

    def check_options(self):
        known, structure, seen = self.structures(), None, set()
        for line, header, cells in rows(read(os.path.join(self.root, ALGORITHMS))):
            if header[0] != "Option":
                continue
            title = re.match(r"\*\*(\w+)\*\*", cells[0])
            if title:
                structure = title[1]
                if structure not in known:
                    self.fail(ALGORITHMS, line, "there is no structure %s" % structure)
                    known[structure] = {}
                continue
            name, default = coded(cells[0])[0], cells[1]
            self.count += 1
            seen.add((structure, name))
            if name not in known[structure]:
                self.fail(ALGORITHMS, line, "%s has no member %s" % (structure, name))
            elif not same(default, known[structure][name]):
                self.fail(ALGORITHMS, line, "%s is %s in %s" % (name, known[structure][name], structure))
            for script in coded(cells[3]):
                if not self.has_script(script):
                    self.fail(ALGORITHMS, line, "the script name %s does not occur" % script)
        seen |= self.check_settings(known)
        for structure, members in known.items():
            for name in members:
                if (structure, name) not in seen:
                    self.fail(ALGORITHMS, 1, "%s of %s is neither a setting nor in the table of options" % (name, structure))

    def check_settings(self, known):
        """Names of settings follow the rule of NAMES.md, numbers are the defaults of their structures."""
        owner = {"iteration": "IterationOptions", "control": "StepControlOptions", "stepper": "StepperOptions",
                 "events": "SchemeOptions", "update": "UpdateOptions"}
        seen = set()
        for one in read_settings(self.root):
            structure = owner[one.path.split(".")[-2]]
            self.count += 1
            default = known[structure].get(one.member, "")
            seen.add((structure, one.member))
            if one.name not in by_rule(one.member) | {pair[1] for pair in SHORT if pair[0] == one.member}:
                self.fail(SOURCE, 1, "%s and %s break the rule of NAMES.md" % (one.member, one.name))
            word = bare(default).lower() if one.choices else default
            if default != "0" and not same(one.default.strip('"'), word) and one.name != "update":
                self.fail(SOURCE, 1, "%s is %s in %s" % (one.name, default, structure))
        return seen

    def check_constants(self):
        """`NAME` (number) in ALGORITHMS.md against constexpr NAME = number; of arrays all numbers."""
        known = {}
        for value in re.findall(r"\bconstexpr [\w:<>, ]*? (\w+(?: =\s+|\{)[^;]*);", self.core_text):
            for name, numbers in re.findall(r"([A-Z][A-Z_]+)(?: =\s+|\{)([-\d.e]+(?:, [-\d.e]+)*)", value):
                known.setdefault(name, []).append(numbers)
        for line, text in enumerate(read(os.path.join(self.root, ALGORITHMS)).split("\n"), 1):
            for name, value in re.findall(r"`([A-Z][A-Z_]+)` \((\$10\^\{-\d+\}\$|[\d., ]*\d)\)", text):
                self.count += 1
                value = re.sub(r"\$10\^\{(-\d+)\}\$", r"1e\1", value)
                if not any(same(value, one) for one in known.get(name, [])):
                    self.fail(ALGORITHMS, line, "the constant %s is %s in the code" % (name, known.get(name, ["none"])[0]))

    def run(self):
        self.check_names()
        self.check_options()
        self.check_constants()
        return self.errors


def same(a, b):
    try:
        return float(a) == float(b)
    except ValueError:
        return re.sub(r"\s", "", a) == re.sub(r"\s", "", b)


if __name__ == "__main__":
    checker = Checker(sys.argv[1] if len(sys.argv) > 1 else ".")
    errors = checker.run()
    print("\n".join(errors) if errors else "%d names, pairs and options agree" % checker.count)
    sys.exit(1 if errors else 0)
