# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write type stubs of a VTK module, by VTK's generator.

stubs.py <package> <folder> <module>

VTK's generator names classes of other modules as if they were defined in the stub, unless these are of
the same package: here they are imported.
"""

import os
import re
import sys

from vtkmodules import generate_pyi


def imported_names(text):
    """{module: names} of the classes of VTK that a stub uses and does not define."""
    modules = [module for name, module in sorted(sys.modules.items()) if name.startswith("vtkmodules.vtk")]
    defined = set(re.findall(r"^class (\w+)", text, flags=re.M))
    used = set(re.findall(r"(?<![\w.])vtk[A-Z]\w*", text)) - defined
    names = {}
    for name in sorted(used):
        module = next((module.__name__ for module in modules if hasattr(module, name)), None)
        if module:
            names.setdefault(module, []).append(name)
    return names


def main(package, folder, module):
    generate_pyi.main(["generate_pyi", "-p", package, "-o", folder, module])
    stub = os.path.join(folder, module + ".pyi")
    with open(stub, encoding="utf-8") as file:
        text = file.read()
    imports = "".join(f"from {where} import {', '.join(names)}\n" for where, names in imported_names(text).items())
    # Where VTK has no stubs its classes are of any type, also as base classes.
    with open(stub, "w", encoding="utf-8") as file:
        file.write("# mypy: disallow-subclassing-any=False\n" + imports + text)


main(*sys.argv[1:])
