# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants a violation of each kind in a copy of the sources: each must be found, with its place.

python test_layout.py <root>"""
import pathlib
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_layout  # noqa: E402


def copy(root, to):
    for name in check_layout.list_files(root):
        if name.startswith(("Filters/", "Plugin/XML/", "Testing/Support/")):
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / name, to / name)


def first_word(plan):
    """A banned word as it stands in a text."""
    return next(word.pattern.replace("\\b", "") for word, _ in plan.words
        if word.pattern.replace("\\b", "").isalpha())


def plant(plan):
    """(what, file, text to append, what must be told)."""
    yield "the core includes VTK", "Filters/Core/Tree/Tree.h", '#include "vtkObject.h"\n', \
        "may not include vtkObject.h"
    yield "the core includes the bridge", "Filters/Core/Tree/Node.h", \
        '#include "Cells/SkdCellTree.h"\n', "may not include Cells/SkdCellTree.h"
    yield "a room includes another", "Filters/Relations/SkdQueryList.h", \
        '#include "Refine/SkdCriteria.h"\n', "may not include Refine/SkdCriteria.h"
    yield "what is shared includes a face", "Filters/Pipeline/SkdReport.h", \
        '#include "vtkSkdTreeProbe.h"\n', "may not include vtkSkdTreeProbe.h"
    yield "a public header includes the inside", "Filters/vtkSkdTreeProbe.h", \
        '#include "Pipeline/SkdReport.h"\n', "may not include Pipeline/SkdReport.h"
    yield "a circle", "Filters/Core/Geometry/ForEachAxis.h", '#include "Box.h"\n', "a circle of includes"
    yield "a new room", "Filters/Attic/SkdOld.h", "\n", "is in no room"
    yield "a long file", "Filters/Cells/SkdShape.h", 600 * "\n", "the file has"
    yield "a long function", "Filters/Cells/SkdShape.cxx", \
        "namespace\n{\ntemplate <class T>\nvoid Long(T t)\n{\n%s}\n}\n" % (60 * "  ++t;\n"), \
        "a function of 6"
    yield "a long method", "Testing/Support/Folders.cxx", \
        "class A\n{\npublic:\n  A()\n    : B{ 1 }\n  {\n%s  }\n  int B;\n};\n" % (60 * "    ++B;\n"), \
        "a function of 6"
    yield "an old word in code", "Filters/Cells/SkdShape.cxx", \
        "// a %s\n" % first_word(plan), "'%s'" % first_word(plan)
    yield "an old word in a document", "Filters/README.md", \
        "A %s.\n" % first_word(plan), "'%s'" % first_word(plan)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    plan = check_layout.Plan(check_layout.PLAN)
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        house = pathlib.Path(folder)
        copy(root, house)
        before = set(check_layout.check(house, plan))
        for _, name, text, _ in plant(plan):
            path = house / name
            path.parent.mkdir(parents=True, exist_ok=True)
            with path.open("a", encoding="utf8") as file:
                file.write(text)
        new = [line for line in check_layout.check(house, plan) if line not in before]
    for what, name, _, told in plant(plan):
        if not any(line.startswith(name + ":") and told in line for line in new):
            print("not found: %s" % what)
            missed += 1
    print("\n".join(new) if missed else "all are found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
