# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions that skdtree_instructions takes for each kind of work, by valgrind, and
compares them with a file: more than 5 % more or less is a failure, and so is work that one of the
two does not know. With --write they become that file.

Counted is what our own library and program execute; what VTK and the C library do on the way
depends on how these were built, and on the processor.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

TOLERANCE = 0.05
SKIPPED = 77


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def own_instructions(dump, objects):
    """The name of the work, and what the named objects executed, of a file that callgrind wrote."""
    name, total, is_ours, is_inclusive = None, 0, False, False
    for line in dump.read_text().splitlines():
        if line.startswith("desc: Trigger: Client Request: "):
            name = line.split(": ", 3)[3]
        elif line.startswith("ob="):
            is_ours = pathlib.Path(line[3:]).name.startswith(objects)
        elif line.startswith("calls="):
            is_inclusive = True  # the next line is what the callee did
        elif re.match(r"[+*-]?\d*\s+\d+$", line):
            total += int(line.split()[-1]) if is_ours and not is_inclusive else 0
            is_inclusive = False
    return name, total


def count(valgrind, program, objects):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind"
        command = [valgrind, "--tool=callgrind", "--instr-atstart=no", "--compress-strings=no",
                   "--compress-pos=no", f"--callgrind-out-file={out}", program]
        # One thread, and the walks that every processor of the kind can run.
        environment = {**os.environ, "VTK_SMP_BACKEND_IN_USE": "Sequential",
                       "SKDTREE_BASELINE": "1"}
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        if done.returncode == SKIPPED:
            skip(done.stdout.strip())
        if done.returncode != 0:
            sys.exit(f"{done.stdout}{done.stderr}The program ended with {done.returncode}.")
        dumps = sorted(pathlib.Path(folder).glob("*.*"), key=lambda dump: int(dump.suffix[1:]))
        counts = [own_instructions(dump, objects) for dump in dumps]
    return {name: total for name, total in counts if name}


def read(expected):
    pairs = (line.rsplit(None, 1) for line in expected.read_text().splitlines())
    return {name.strip(): int(total) for name, total in pairs}


def compare(counts, expected):
    """Prints a line for each work; returns how many are not as expected."""
    wrong = 0
    for name in sorted(counts.keys() | expected.keys()):
        found, wanted = counts.get(name), expected.get(name)
        change = found / wanted - 1.0 if found and wanted else None
        is_good = change is not None and abs(change) <= TOLERANCE
        wrong += not is_good
        told = "of one only" if change is None else f"{100.0 * change:+.1f} %"
        print(f"{name:32} {found!s:>12} expected {wanted!s:>12} {told:>12}", "" if is_good else "<--")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--valgrind", required=True)
    parser.add_argument("--program", required=True)
    parser.add_argument("--objects", nargs="+", required=True, help="file names whose code counts")
    parser.add_argument("--expected", type=pathlib.Path, required=True)
    parser.add_argument("--unfit", default="", help="why the numbers do not hold for this build")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    if options.unfit:
        skip(options.unfit)
    if not options.valgrind or options.valgrind.endswith("NOTFOUND"):
        skip("valgrind is not installed")
    counts = count(options.valgrind, options.program, tuple(options.objects))
    if not counts:
        sys.exit("Nothing was counted.")
    if options.write:
        lines = (f"{name:32} {total:12}\n" for name, total in counts.items())
        options.expected.write_text("".join(lines))
        return
    wrong = compare(counts, read(options.expected))
    if wrong:
        sys.exit(f"{wrong} kinds of work are not as expected. Where that is meant, build the target "
                 "skdtree_expect_instructions and say why.")


main()
