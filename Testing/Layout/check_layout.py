# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks a source tree against plan.txt: python check_layout.py <root>

Prints "file:line: what is wrong" and returns 1 where the tree departs from the plan:
- an include that the table of folders does not allow,
- a circle of includes (a header and the sources of the same name count as one),
- an include by which too many objects depend on a kernel, a query or a builder of trees,
- a file or a function that is too long,
- a declaration outside of all namespaces that is not named as VTK's classes are,
- a type that two headers define by the same name,
- an include guard that is not named as its header is,
- a word that is no longer used,
- the picture of the folders in Filters/README.md.

Functions are found by a brace scanner: a function is a block in braces that opens in a file, a
namespace or a class and has a parameter list before it. It is counted from the line on which its
declaration begins to the line of its closing brace; lambdas and local classes count as part of the
function that they are in.
"""
import fnmatch
import pathlib
import re
import subprocess
import sys

import picture

INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
TYPE = re.compile(r"^(?:template\b.*>\s+)?(?:class|struct|union|enum(?: class)?)\s+"
    r"(?:alignas\(.*?\)\s+|[A-Z_]+\s+)?(\w+)(?:\s+final)?(?:\s*:[^:].*)?$", re.M)
GUARD = re.compile(r'^#ifndef (\w+)\n#define \1$', re.M)
PLAN = pathlib.Path(__file__).resolve().parent / "plan.txt"


class Plan:
    """The sections of plan.txt: [folders], [dependents], [limits], [words], [allowed]."""

    def __init__(self, path):
        self.folders, self.dependents, self.limits, self.words, self.allowed = [], [], {}, [], []
        section = None
        for line in path.read_text(encoding="utf8").splitlines():
            line = line.partition(" # ")[0].strip()
            if not line or line.startswith("#"):
                continue
            if line.startswith("["):
                section = line.strip("[]")
            elif section == "folders":
                row, _, may = line.partition("|")
                self.folders.append((row.strip(), may.split()))
            elif section == "dependents":
                row, _, number = line.partition("|")
                self.dependents.append((row.strip(), float(number)))
            elif section == "limits":
                name, _, number = line.partition("|")
                self.limits[name.strip()] = int(number)
            elif section == "words":
                word, _, instead = line.partition("::")
                self.words.append((re.compile(word.strip()), instead.strip()))
            elif section == "allowed":
                name, _, text = line.partition("::")
                self.allowed.append((name.strip(), text.strip()))
            else:
                raise ValueError("plan.txt: a line outside of the sections: " + line)

    def folder_of(self, path):
        """The first row that a path below Filters matches, by its folder or by its own name."""
        folder = path.rpartition("/")[0]
        for row, may in self.folders:
            if row == folder or fnmatch.fnmatchcase(path, row):
                return row, may
        return None, None

    def most_dependents_of(self, path):
        """By the first row that a path below Filters matches."""
        return next((most for row, most in self.dependents if fnmatch.fnmatchcase(path, row)),
            float("inf"))

    def is_allowed(self, name, line):
        return any(fnmatch.fnmatchcase(name, where) and text in line for where, text in self.allowed)


def list_files(root):
    """The files that git tracks below root or, outside a repository, all files."""
    if (root / ".git").exists():
        names = subprocess.run(["git", "-C", str(root), "ls-files"], check=True,
            capture_output=True, text=True).stdout.splitlines()
    else:
        names = [path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()]
    return sorted(name for name in names if (root / name).is_file())


def resolve(name, included, headers):
    """The header that an include refers to, beside the file or from the top, or None."""
    here = pathlib.PurePosixPath(name).parent
    parts = []
    for part in (here / included).parts:
        if part == "..":
            parts = parts[:-1]
        else:
            parts.append(part)
    for candidate in ("/".join(parts), included, "Filters/" + included, "Testing/" + included):
        if candidate in headers:
            return candidate
    return None


def read_includes(folder, headers):
    """Of each file below a folder: (line, spelling, file or None)."""
    includes = {}
    for name in headers:
        includes[name] = []
        text = (folder / name).read_text(encoding="utf8")
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            if match:
                found = resolve(name, match.group(2), headers)
                includes[name].append((number, match.group(2), found))
    return includes


def may_include(row, may, name, spelling, target):
    """Whether the plan lets a file of a row include this."""
    if target is None:
        return not spelling.startswith("vtk") or "VTK" in may
    folder = target.rpartition("/")[0]
    own = name.rpartition("/")[0]
    if folder == own and folder:
        return True
    stem = name.rpartition(".")[0]
    if target == stem + ".h":
        return True
    return any(folder == entry or fnmatch.fnmatchcase(target, entry) for entry in may)


def check_folders(plan, includes):
    for name, lines in includes.items():
        row, may = plan.folder_of(name)
        if row is None:
            yield name, 1, "is in no folder of Testing/Layout/plan.txt"
            continue
        for number, spelling, target in lines:
            if not may_include(row, may, name, spelling, target):
                yield name, number, "%s may not include %s" % (row, spelling)


def check_circles(includes):
    """Cycles of includes; a header and sources of its name count as one."""
    edges, where = {}, {}
    for name, lines in includes.items():
        unit = name.rpartition(".")[0]
        for number, _, target in lines:
            other = target.rpartition(".")[0] if target else unit
            if other != unit:
                edges.setdefault(unit, set()).add(other)
                where.setdefault((unit, other), (name, number))
    state, path = {}, []

    def visit(unit):
        state[unit] = "open"
        path.append(unit)
        for other in sorted(edges.get(unit, ())):
            if state.get(other) == "open":
                circle = path[path.index(other):] + [other]
                yield where[(unit, other)] + ("a circle of includes: " + " > ".join(circle),)
            elif other not in state:
                yield from visit(other)
        path.pop()
        state[unit] = "done"

    for unit in sorted(edges):
        if unit not in state:
            yield from visit(unit)


def find_included(name, includes):
    """{all that a source includes: by which file and line}, itself left out."""
    included, ahead = {}, [name]
    for file in ahead:
        for number, _, target in includes[file]:
            if target and target != name and target not in included:
                included[target] = file, number
                ahead.append(target)
    return included


def read_twice_compiled(root):
    """The tests of the core that are compiled for plain lanes, too."""
    path = root / "Testing/Core/CMakeLists.txt"
    text = path.read_text(encoding="utf8") if path.exists() else ""
    tests = re.search(r"set\(lanes_tests ([^)]*)\)", text)
    return {"Testing/Core/%s.cxx" % name for name in ["CoreSupport"] +
        ["Test" + test for test in (tests.group(1).split() if tests else [])]}


def check_dependents(plan, root, names):
    """The include that is told of is the one by which most objects depend on the header."""
    includes = read_includes(root, {name for name in names if name.endswith((".h", ".cxx")) and
        name.startswith(("Filters/", "Testing/")) and not name.startswith("Testing/Benchmark/")})
    twice = read_twice_compiled(root)
    dependents = {}  # of each header: objects by the include that leads to it
    for source in sorted(name for name in includes if name.endswith(".cxx")):
        for header, where in find_included(source, includes).items():
            objects = dependents.setdefault(header, {})
            objects[where] = objects.get(where, 0) + (2 if source in twice else 1)
    for header, objects in sorted(dependents.items()):
        count = sum(objects.values())
        if count > plan.most_dependents_of(header.replace("Filters/", "", 1)):
            where = max(objects, key=objects.get)
            yield where + ("%d objects depend on %s, %d of them by this include" % (
                count, header, objects[where]),)


def blank_out(text):
    """The text without comments, strings, characters and preprocessor lines, line by line."""
    pattern = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'
        r"(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*",
        re.S | re.M)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)


def find_functions(text):
    """(first line, last line, head) of each function."""
    text = blank_out(text)
    blocks = []  # kind of each open brace, where its head begins
    begin, line, depth = 0, 1, 0
    for at, char in enumerate(text):
        if char == "\n":
            line += 1
        elif char in "([":
            depth += 1
        elif char in ")]":
            depth -= 1
        elif char == "{":
            head = text[begin:at]
            outer = blocks[-1][0] if blocks else "scope"
            kind = outer
            if outer == "scope" and depth == 0:
                if re.search(r"\b(namespace|extern)\b[^()]*$", head):
                    kind = "scope"
                elif re.match(r"[^()=]*\b(class|struct|union|enum)\b", strip_template(head)):
                    kind = "scope"
                elif "(" in head and not re.search(r"(^|[^=!<>])=\s*$", head):
                    kind = "function"
                else:
                    kind = "value"
            elif outer == "scope":
                kind = "value"
            first = line - head.lstrip().count("\n")
            blocks.append((kind, first, head.strip(), depth, outer))
            depth = 0
            if kind == "scope":
                begin = at + 1
        elif char == "}" and blocks:
            kind, first, head, depth, outer = blocks.pop()
            if kind == "function" and outer == "scope":
                # a member's initialiser in braces is followed by the body
                rest = text[at + 1:].lstrip()
                if not (rest.startswith(("{", ",")) and re.search(r"\)\s*(noexcept\s*)?:", head)):
                    yield first, line, head
                    begin = at + 1
            elif outer == "scope" and kind != "value":
                begin = at + 1
        elif char == ";" and depth == 0 and (not blocks or blocks[-1][0] == "scope"):
            begin = at + 1


def strip_template(head):
    """The head without its template parameters, among which may be the word class."""
    head = head.strip()
    while head.startswith("template"):
        depth, at = 0, head.find("<")
        while at < len(head):
            depth += {"<": 1, ">": -1}.get(head[at], 0)
            at += 1
            if depth == 0:
                break
        head = head[at:].strip()
    return re.sub(r"^(public|protected|private)\s*:", "", head).strip()


def check_lengths(plan, root, names):
    for name in names:
        if not name.endswith((".h", ".cxx", ".py", ".xml")):
            continue
        text = (root / name).read_text(encoding="utf8")
        count = text.count("\n")
        if count > plan.limits["lines of a file"]:
            yield name, count, "the file has %d lines" % count
        if name.endswith((".py", ".xml")):
            continue
        for first, last, head in find_functions(text):
            length = last - first + 1
            if length > plan.limits["lines of a function"]:
                what = " ".join(head.split())[:60]
                yield name, first, "a function of %d lines: %s" % (length, what)


def find_globals(text):
    """(line, head) of each declaration and definition that is in no namespace."""
    text = blank_out(text)
    text = re.sub(r"\bVTK_ABI_NAMESPACE_(BEGIN|END)\b", lambda m: " " * len(m.group(0)), text)
    begin, depth = 0, 0
    for at, char in enumerate(text):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(char, 0)
        if depth == 0 and char == ";" or depth == 1 and char == "{":
            head = strip_template(text[begin:at])
            if head and not re.match(r"(using )?namespace\b|static_assert\b|,", head):
                yield text.count("\n", 0, at) - text[begin:at].lstrip().count("\n") + 1, head
        if depth == 0 and char in ";}" or depth == 1 and char == "{":
            begin = at + 1


def name_of(head):
    """The name that a declaration declares, with what qualifies it first."""
    match = re.match(r"(?:class|struct|union|enum(?: class)?)\s+(?:[A-Z_]+\s+)?(\w+)", head)
    if not match:
        match = re.match(r"using\s+(\w+)", head) or \
            re.search(r"(\w+)(?:::~?\w+)*\s*(?:operator\s*\S+\s*)?(?:\(|=|$)", head)
    return match.group(1) if match else head


def check_namespaces(root, names):
    for name in names:
        text = (root / "Filters" / name).read_text(encoding="utf8")
        for number, head in find_globals(text):
            if not name_of(head).startswith("vtk"):
                yield name, number, "in no namespace: " + " ".join(head.split())[:60]


def check_guards(root, names):
    """Include guards end with the name of the header: a renamed file takes its guard along."""
    for name in names:
        if not name.endswith(".h"):
            continue
        guard = GUARD.search((root / name).read_text(encoding="utf8"))
        if guard and not guard.group(1).endswith(pathlib.PurePath(name).stem + "_h"):
            yield name, 1, "the include guard is %s" % guard.group(1)


def check_types(root, names):
    """No two headers define a type of one name: if both were of one namespace, neither the compiler
    nor the linker would say so, and functions of one would be called for the other."""
    homes = {}
    for name in sorted(names):
        if name.endswith(".h"):
            text = blank_out((root / "Filters" / name).read_text(encoding="utf8"))
            for match in TYPE.finditer(text):
                home = homes.setdefault(match.group(1), name)
                if home != name:
                    yield name, text.count("\n", 0, match.start()) + 1, \
                        "%s is also defined in %s" % (match.group(1), home)


def check_words(plan, root, names):
    for name in names:
        if not name.endswith((".h", ".cxx", ".py", ".md", ".xml", ".txt", ".cmake", ".sh", ".in")):
            continue
        if name.startswith(("Testing/Layout/", "Data/")):
            continue
        text = (root / name).read_text(encoding="utf8")
        for number, line in enumerate(text.splitlines(), 1):
            for word, instead in plan.words:
                match = word.search(line)
                if match and not plan.is_allowed(name, line):
                    yield name, number, "'%s': say %s" % (match.group(0), instead)


def check(root, plan):
    names = [name for name in list_files(root) if name.startswith(("Filters/", "Testing/", "Plugin/"))
        or name.endswith(".md")]
    headers = {name[len("Filters/"):] for name in names
        if name.startswith("Filters/") and name.endswith((".h", ".cxx"))}
    includes = read_includes(root / "Filters", headers)
    found = ["Filters/%s:%d: %s" % each for each in check_folders(plan, includes)]
    found += ["Filters/%s:%d: %s" % each for each in check_circles(includes)]
    found += ["Filters/%s:%d: %s" % each for each in check_namespaces(root, headers)]
    found += ["Filters/%s:%d: %s" % each for each in check_types(root, headers)]
    found += ["%s:%d: %s" % each for each in check_dependents(plan, root, names)]
    found += ["%s:%d: %s" % each for each in check_lengths(plan, root, names)]
    found += ["%s:%d: %s" % each for each in check_guards(root, names)]
    found += ["%s:%d: %s" % each for each in check_words(plan, root, names)]
    found += ["%s:%d: %s" % each for each in picture.check(plan, root)]
    return found


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = check(root, Plan(PLAN))
    print("\n".join(found) if found else "the sources follow the plan")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
