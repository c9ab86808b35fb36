# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants a violation of each kind in a copy of the sources; each must be reported with its location.

    python test_layout.py <root> [<clang-tidy>]

With clang-tidy, lint.py is tested in the same way, on a few sources of its own."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_layout  # noqa: E402
import source_groups  # noqa: E402


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
    """(what, file, text to append, what must be reported)."""
    yield "the core includes VTK", "Filters/Core/Search/Tree/Tree.h", '#include "vtkObject.h"\n', \
        "may not include vtkObject.h"
    yield "the core includes Cells", "Filters/Core/Search/Tree/Node.h", \
        '#include "Cells/Search/SkdCellTree.h"\n', "may not include Cells/Search/SkdCellTree.h"
    yield "a feature includes another", "Filters/Search/Relations/SkdQueryList.h", \
        '#include "Meshing/Refine/SkdCriteria.h"\n', "may not include Meshing/Refine/SkdCriteria.h"
    yield "a shared file includes a public class", "Filters/Pipeline/SkdReport.h", \
        '#include "vtkSkdTreeProbe.h"\n', "may not include vtkSkdTreeProbe.h"
    yield "a public header includes a private one", "Filters/vtkSkdTreeProbe.h", \
        '#include "Pipeline/SkdReport.h"\n', "may not include Pipeline/SkdReport.h"
    yield "a circle", "Filters/Core/Geometry/ForEachAxis.h", '#include "Box.h"\n', "a circle of includes"
    yield "a kernel that many files include", "Filters/Core/Geometry/Box.h", \
        '#include "Core/Geometry/Distance/ClosestPointOnTriangle.h"\n', \
        "objects depend on Filters/Core/Geometry/Distance/ClosestPointOnTriangle.h"
    yield "a new folder", "Filters/Attic/SkdOld.h", "\n", "is in no folder"
    yield "a long file", "Filters/Cells/Read/SkdShape.h", 600 * "\n", "the file has"
    yield "a long XML file", "Plugin/XML/SkdTreeRemap.xml", 600 * "\n", "the file has"
    yield "a long function", "Filters/Cells/Read/SkdShape.cxx", \
        "namespace\n{\ntemplate <class T>\nvoid Long(T t)\n{\n%s}\n}\n" % (60 * "  ++t;\n"), \
        "a function of 6"
    yield "a long method", "Testing/Support/Folders.cxx", \
        "class A\n{\npublic:\n  A()\n    : B{ 1 }\n  {\n%s  }\n  int B;\n};\n" % (60 * "    ++B;\n"), \
        "a function of 6"
    yield "a type in no namespace", "Filters/Pipeline/SkdReport.h", "struct SkdOutside;\n", \
        "in no namespace: struct SkdOutside"
    yield "a function in no namespace", "Filters/vtkSkdTreeProbe.cxx", \
        "std::vector<int> SkdOutside(int i)\n{\n  return { i };\n}\n", \
        "in no namespace: std::vector<int> SkdOutside"
    yield "a method in no namespace", "Filters/Cells/Read/SkdShape.cxx", \
        "void SkdOutside::Run()\n{\n}\n", "in no namespace: void SkdOutside::Run"
    yield "a type of a name that is taken", "Filters/Pipeline/SkdReport.h", \
        "namespace skdtree\n{\nstruct SkdTransport\n  : Other\n{\n};\n}\n", "SkdTransport is also defined in"
    yield "a guard of another name", "Filters/Pipeline/SkdOld.h", \
        "#ifndef SkdOlder_h\n#define SkdOlder_h\n#endif\n", "the include guard is SkdOlder_h"
    yield "an old word in code", "Filters/Cells/Read/SkdShape.cxx", \
        "// a %s\n" % first_word(plan), "'%s'" % first_word(plan)
    yield "an old word in a document", "Filters/README.md", \
        "A %s.\n" % first_word(plan), "'%s'" % first_word(plan)


LINT_SOURCES = {
    "Good.cxx": '#include "Good.h"\nnamespace\n{\nint Shared(int i)\n{\n  return i;\n}\n}\n'
        "int Good() { return Shared(1); }\n",
    # The same name for a function of its own: both cannot be in one group.
    "Other.cxx": "namespace\n{\nint Shared(int i)\n{\n  return i + 1;\n}\n}\n"
        "int Other() { return Shared(1); }\n",
    # The same name, where lint.py does not expect it: the group is halved.
    "Third.cxx": "static int Fixed() { return 1; }\nint Third() { return Fixed(); }\n",
    "Fourth.cxx": "static int Fixed() { return 2; }\nint Fourth() { return Fixed(); }\n",
    "Good.h": "int Good();\n"}
LINT_VIOLATIONS = {
    "Other.cxx": ("int* Nothing() { return 0; }\n", "[modernize-use-nullptr]"),
    "Good.h": ("inline int Unused(int i) { return 1; }\n", "[misc-unused-parameters]"),
    "Fourth.cxx": ("int Broken() { return missing; }\n", "[clang-diagnostic-error]")}


def run_lint(root, clang_tidy):
    run = subprocess.run([sys.executable, str(pathlib.Path(__file__).resolve().parent / "lint.py"),
        str(root), str(root / "build"), clang_tidy], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def test_lint(root, clang_tidy, copied):
    """The failures of lint.py: it must accept the sources, find planted faults, and accept them again."""
    (copied / "Filters").mkdir(parents=True)
    (copied / "build").mkdir()
    shutil.copy(root / ".clang-tidy", copied)
    for name, text in LINT_SOURCES.items():
        (copied / "Filters" / name).write_text(text, encoding="utf8")
    entries = [{"directory": str(copied / "build"), "file": str(copied / "Filters" / name),
        "command": "c++ -std=c++17 -O2 -c %s" % name} for name in LINT_SOURCES if name[-1] == "x"]
    (copied / "build" / "compile_commands.json").write_text(json.dumps(entries), encoding="utf8")
    code, told = run_lint(copied, clang_tidy)
    wrong = ["sources without a fault: " + told] if code != 0 else []
    for name, (text, check) in LINT_VIOLATIONS.items():
        path = copied / "Filters" / name
        path.write_text(LINT_SOURCES[name] + text, encoding="utf8")
        for _ in range(2):  # what was found is found again
            code, told = run_lint(copied, clang_tidy)
            if code != 1 or not any(line.startswith("Filters/%s:" % name) and check in line
                    for line in told.splitlines()):
                wrong.append("%s not found in %s: %s" % (check, name, told))
        path.write_text(LINT_SOURCES[name], encoding="utf8")
    code, told = run_lint(copied, clang_tidy)
    return wrong + (["the same sources again: " + told] if code != 0 else [])


def test_groups(folder):
    """The failures of source_groups.py: of two sources that know a name differently, none may be with the other."""
    own = "namespace\n{\nint Named(int i)\n{\n  return i;\n}\n}\n"
    texts = {"A.cxx": own, "B.cxx": own, "C.cxx": "int C() { return Named(1); }\n", "D.cxx": "int D();\n",
        "vtkE.cxx": "int E();\n", "F.cxx": "// not Named\nint F();\n", "G.cxx": "int G();\n",
        "H.cxx": "namespace\n{\nint operator-(E a, E b)\n{\n  return 0;\n}\n}\n"}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf8")
    groups = source_groups.group([folder / name for name in texts], 3)
    names = [[path.name for path in each] for each in groups]
    expected = [["A.cxx", "D.cxx", "F.cxx"], ["B.cxx", "G.cxx"], ["C.cxx"], ["H.cxx"], ["vtkE.cxx"]]
    return [] if names == expected else ["groups: %s" % names]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if len(sys.argv) > 2:
        with tempfile.TemporaryDirectory() as folder:
            wrong = test_lint(root, sys.argv[2], pathlib.Path(folder).resolve() / "sources")
        print("\n".join(wrong) if wrong else "clang-tidy finds all")
        if wrong:
            return 1
    with tempfile.TemporaryDirectory() as folder:
        wrong = test_groups(pathlib.Path(folder))
    if wrong:
        print("\n".join(wrong))
        return 1
    plan = check_layout.Plan(check_layout.PLAN)
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        copied = pathlib.Path(folder)
        copy(root, copied)
        before = set(check_layout.check(copied, plan))
        for _, name, text, _ in plant(plan):
            path = copied / name
            path.parent.mkdir(parents=True, exist_ok=True)
            with path.open("a", encoding="utf8") as file:
                file.write(text)
        new = [line for line in check_layout.check(copied, plan) if line not in before]
    for what, name, _, told in plant(plan):
        if not any(line.startswith(name + ":") and told in line for line in new):
            print("not found: %s" % what)
            missed += 1
    print("\n".join(new) if missed else "all are found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
