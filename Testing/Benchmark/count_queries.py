# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts, by valgrind, the instructions of queries in skdtree_benchmark, of every structure that it
has, VTK and the library of the structure included:

    python3 count_queries.py build/Testing/Benchmark/skdtree_benchmark --scene "noisy sphere" \\
      --work hit --structure skD-tree --structure Embree
"""

import argparse
import pathlib
import re
import subprocess
import tempfile


def count(options, structure, folder):
    """Pairs of work and instructions a query."""
    command = ["valgrind", "--tool=callgrind", "--instr-atstart=no",
               f"--callgrind-out-file={folder}/callgrind", options.program,
               "--profile", str(options.queries), "--scene", options.scene, "--structure", structure]
    command += ["--work", options.work] if options.work else []
    command += ["--load-cells"] if options.load_cells else []
    subprocess.run(command, check=True, capture_output=True)
    for dump in sorted(folder.glob("*.*"), key=lambda dump: int(dump.suffix[1:])):
        text = dump.read_text()
        name = re.search(r"^desc: Trigger: Client Request: (.*)$", text, re.MULTILINE)
        total = re.search(r"^totals: (\d+)$", text, re.MULTILINE)
        dump.unlink()
        if name and total:
            yield name[1], int(total[1]) / options.queries


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--scene", default="noisy sphere")
    parser.add_argument("--work", default="")
    parser.add_argument("--structure", action="append", default=[], help="any number of them")
    parser.add_argument("--load-cells", action="store_true", help="by VTK's full calls")
    parser.add_argument("--queries", type=int, default=2000)
    options = parser.parse_args()
    for structure in options.structure or ["skD-tree"]:
        with tempfile.TemporaryDirectory() as folder:
            for name, instructions in count(options, structure, pathlib.Path(folder)):
                print(f"{name:50} {instructions:10.0f}")


main()
