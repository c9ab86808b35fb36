# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the rooms in Filters/README.md, drawn from plan.txt: python picture.py --update

A box is a family of folders, an arrow what its files may include. Arrows that follow from others are
left out.
"""
import fnmatch
import pathlib
import sys

README = "Filters/README.md"
BEGIN, END = "```mermaid\n", "```\n"
FILTERS, LOCATOR = "filters", "vtkSkdTreeCellLocator"
APART = ("Solids", "Cells")  # families whose folders are boxes of their own


def box_of(row):
    """The box that a row of the plan, or the folder of a file, belongs to; None of public headers."""
    if fnmatch.fnmatchcase(row.rpartition(".")[0], "vtkSkdTree*CellLocator"):
        return LOCATOR if row.endswith(".cxx") else None
    if row.startswith("vtkSkdTree"):
        return None if row.endswith(".h") else FILTERS
    parts = row.split("/")
    return "/".join(parts[:2] if parts[0] in APART + ("Core",) else parts[:1])


def boxes_of(entry, folders):
    """The boxes of what a row may include: a folder, a pattern or a file."""
    if entry.startswith(LOCATOR):
        return {LOCATOR}
    folder = entry.rpartition("/")[0] if entry.endswith(".h") else entry
    return {box_of(name) for name in folders if fnmatch.fnmatchcase(name, folder)}


def find_arrows(plan):
    """The boxes that each box may include."""
    folders = [row for row, _ in plan.folders if not row.startswith("vtk")]
    arrows = {}
    for row, may in plan.folders:
        box = box_of(row)
        if box:
            reached = arrows.setdefault(box, set())
            for entry in may:
                reached |= boxes_of(entry, folders)
            reached.discard(box)
    return arrows


def reach(arrows, box):
    """All boxes that can be reached from one."""
    found, todo = set(), [box]
    while todo:
        for other in arrows.get(todo.pop(), ()):
            if other not in found:
                found.add(other)
                todo.append(other)
    return found


def draw(plan):
    """The picture, in the language of Mermaid."""
    arrows = find_arrows(plan)
    names = {box: "n%d" % i for i, box in enumerate(arrows)}
    lines = ["flowchart TD"]
    for box, name in names.items():
        within = [row.rpartition("/")[2] for row, _ in plan.folders
            if box_of(row) == box and row.startswith(box + "/") and "." not in row]
        lines.append('  %s["%s%s"]' % (name, box, "<br>" + ", ".join(within) if within else ""))
    for box, others in arrows.items():
        implied = set().union(*(reach(arrows, other) for other in others)) if others else set()
        for other in sorted(others - implied):
            lines.append("  %s --> %s" % (names[box], names[other]))
    return "\n".join(lines) + "\n"


def find_picture(text):
    """Where the picture begins and ends in a text, or None."""
    begin = text.find(BEGIN)
    return (begin + len(BEGIN), text.find(END, begin + len(BEGIN))) if begin >= 0 else None


def check(plan, root):
    """What is wrong with the picture of the README."""
    text = (root / README).read_text(encoding="utf8")
    span = find_picture(text)
    if not span or text[slice(*span)] != draw(plan):
        yield README, 1, "the picture is not that of plan.txt: python Testing/Layout/picture.py --update"


def update(plan, root):
    text = (root / README).read_text(encoding="utf8")
    begin, end = find_picture(text)
    (root / README).write_text(text[:begin] + draw(plan) + text[end:], encoding="utf8")


if __name__ == "__main__":
    import check_layout
    the_plan = check_layout.Plan(check_layout.PLAN)
    if "--update" in sys.argv[1:]:
        update(the_plan, pathlib.Path(__file__).resolve().parents[2])
    else:
        print(draw(the_plan), end="")
