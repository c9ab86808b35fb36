# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run what the README tells its readers to type.

readme.py <repository> <work folder> <install prefix> <cmake> <python> <pvpython or nothing>
Python is run as it stands, in the repository; CMake and C++ become a project in the work folder.
"""

import os
import re
import shutil
import subprocess
import sys

repository, work, prefix, cmake, python, pvpython = sys.argv[1:7]
with open(os.path.join(repository, "README.md"), encoding="utf-8") as file:
    snippets = re.findall(r"^```(\w+)\n(.*?)^```$", file.read(), re.MULTILINE | re.DOTALL)


def run(*command, folder=repository):
    print("$", *command, flush=True)
    subprocess.run(command, cwd=folder, check=True)


def write(name, text):
    path = os.path.join(work, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


shutil.rmtree(work, ignore_errors=True)
os.makedirs(work)
ran = set()
for number, (language, text) in enumerate(snippets):
    if language == "python":
        needs_paraview = "paraview" in text
        interpreter = pvpython if needs_paraview else python
        if interpreter:
            run(interpreter, write(f"snippet{number}.py", text))
            ran.add("pvpython" if needs_paraview else "python")
    elif language == "cmake":
        write("CMakeLists.txt", text)
        program = re.search(r"add_executable\((\w+) (\S+)\)", text)
    elif language == "cpp":
        write(program.group(2), text)
        run(cmake, "-S", work, "-B", os.path.join(work, "build"), f"-DCMAKE_PREFIX_PATH={prefix}")
        run(cmake, "--build", os.path.join(work, "build"))
        run(os.path.join(work, "build", program.group(1)))
        ran.add("cpp")

assert ran == {"python", "cpp"} | ({"pvpython"} if pvpython else set()), ran
