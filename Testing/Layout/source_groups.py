# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which sources a compiler may read as one:

    python source_groups.py <size> <source>...

prints groups of at most that many sources, one a line, separated by commas. Sources that give the same
name to something of their own are kept apart, neighbours in the list together where that allows it: they
include the same headers. Public classes are kept apart from others, in whose namespace they are not.
"""
import pathlib
import re
import sys

import check_layout

OWN_SCOPE = re.compile(r"\bnamespace\s*\{")
TYPE = re.compile(r"\b(?:class|struct|union|enum|enum class|using)\s+(\w+)")
OTHER = re.compile(r"(\w+)\s*$")
OPERATOR = re.compile(r"\boperator\b")
TEST = re.compile(r"(TYPED_)?TEST|INSTANTIATE_")  # of GoogleTest: a class named by the test
MACRO = re.compile(r"^\s*#\s*define\s+(\w+)", re.M)


def read_own_names(text):
    """What a source declares in namespaces without a name, on their outermost level, and its macros."""
    names = set(MACRO.findall(text))
    text = check_layout.blank_out(text)
    for match in OWN_SCOPE.finditer(text):
        depth, outermost = 1, []
        for char in text[match.end():]:
            depth += {"{": 1, "}": -1}.get(char, 0)
            if depth == 0:
                break
            if depth == 1:
                outermost.append(";" if char == "}" else char)
        for statement in "".join(outermost).split(";"):
            head = re.split(r"[({=]", statement)[0]
            if re.match(r"\s*using\b", head) and "=" not in statement:
                continue  # another's name, which several may use
            if TEST.match(head.strip()):
                continue
            names.update(TYPE.findall(head) + OTHER.findall(head) + OPERATOR.findall(head))
    return names


class Source:
    """What a source calls its own, and all names in it: of two that are compiled as one, no name of the one
    may occur in the other, which might mean another thing by it. An operator of its own has no name to tell
    by, so its source is alone."""

    def __init__(self, path):
        text = path.read_text(encoding="utf8")
        self.path, self.is_public = path, path.name.startswith("vtk")
        self.own = read_own_names(text)
        self.used = set(re.findall(r"\w+", check_layout.blank_out(text)))

    def goes_with(self, other):
        return (self.is_public == other.is_public and "operator" not in self.own | other.own and
            not self.own & other.used and not other.own & self.used)


def group(paths, size):
    """Lists of paths: each source in the first list that has room and nothing against it."""
    groups = []
    for source in sorted(map(Source, paths), key=lambda each: (each.is_public, each.path)):
        fitting = next((each for each in groups
            if len(each) < size and all(source.goes_with(other) for other in each)), None)
        if fitting is None:
            fitting = []
            groups.append(fitting)
        fitting.append(source)
    return [[source.path for source in each] for each in groups]


def main():
    for paths in group([pathlib.Path(name) for name in sys.argv[2:]], int(sys.argv[1])):
        print(",".join(path.as_posix() for path in paths))


if __name__ == "__main__":
    main()
