# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run the commands of the README and the user guide.

readme.py <repository> <work folder> <install prefix> <cmake> <python> <pvpython or nothing>
Python is run as it stands, in the repository; CMake and C++ become a project in the work folder.
Shell commands are checked: what they name is there, and other tests run it (recipes for pvpython of the
guide are run by Testing/Python/TestGuide.py).
"""

import glob
import json
import os
import re
import shutil
import subprocess
import sys

repository, work, prefix, cmake, python, pvpython = sys.argv[1:7]
GUIDE = os.path.join(repository, "Plugin", "Documentation")
SNIPPET = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
RUN_ALL = "import runpy, sys\nfor name in sys.argv[1:]:\n    runpy.run_path(name)\n"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def run(*command, folder=repository):
    print("$", *command, flush=True)
    subprocess.run(command, cwd=folder, check=True)


def write(name, text):
    path = os.path.join(work, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def run_python(interpreter, name, texts):
    """All of them in one process: starting it takes longer than they do."""
    assert texts, name
    scripts = [write(f"{name}{number}.py", text) for number, text in enumerate(texts)]
    run(interpreter, write(f"run_{name}.py", RUN_ALL), *scripts)


def run_cpp(project, texts):
    """A project as the README has it, with its program and one for each of the guide."""
    program, file = re.search(r"add_executable\((\w+) (\S+)\)", project).groups()
    names = [program] + [f"{program}{number}" for number in range(1, len(texts))]
    for name, text in zip(names, texts):
        write(file.replace(program, name), text)
        if name != program:
            project += (f"add_executable({name} {file.replace(program, name)})\n"
                f"target_link_libraries({name} PRIVATE VTK::FiltersSkdTree)\n")
    write("CMakeLists.txt", project)
    build = os.path.join(work, "build")
    run(cmake, "-S", work, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
    run(cmake, "--build", build, "--parallel", "2")
    for name in names:
        run(os.path.join(build, name))


def check_command(line):
    """That a command names what there is."""
    words = line.split("#")[0].split()
    if not words:
        return
    presets = json.loads(read(os.path.join(repository, "CMakePresets.json")))
    options = read(os.path.join(repository, "CMakeLists.txt"))
    known = {preset["name"] for preset in presets["configurePresets"]}
    if words[:4] == ["python3", "-m", "pip", "install"]:
        assert words[4] == "build/wheel/*.whl", line
    elif words[0] in ("bash", "python3"):
        assert os.path.exists(os.path.join(repository, words[1])), line
    elif words[0] == ".":
        assert words[1] == "build/setup.sh" and os.path.exists(
            os.path.join(repository, "Filters", "CMake", "setup.sh.in")), line
    elif words[0] == "cmake":
        assert words[1] in ("--preset", "--build", "--install"), line
        assert words[1] != "--preset" or words[2] in known, line
    elif " ".join(words) != "cd build && cpack":
        raise AssertionError("nothing runs: " + line)
    for option in re.findall(r"-D(SKDTREE_\w+)=", line):
        assert option in options, line


shutil.rmtree(work, ignore_errors=True)
os.makedirs(work)
readme = SNIPPET.findall(read(os.path.join(repository, "README.md")))
guide = [snippet for page in sorted(glob.glob(os.path.join(GUIDE, "*.md")))
    for snippet in SNIPPET.findall(read(page))]
known_languages = {"bash", "python", "cmake", "cpp"}
assert {language for language, _ in readme} == known_languages
assert {language for language, _ in guide} <= known_languages

for language, text in readme + guide:
    if language == "bash":
        for command in text.splitlines():
            check_command(command)

run_python(python, "python", [text for language, text in readme + guide
    if language == "python" and "paraview" not in text])
if pvpython:
    run_python(pvpython, "pvpython", [text for language, text in readme
        if language == "python" and "paraview" in text])
run_cpp(*[text for language, text in readme if language == "cmake"],
    [text for language, text in readme + guide if language == "cpp"])
