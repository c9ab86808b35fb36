# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Put a wheel together from what was installed.

wheel.py <folder with installed/> <licence> <name of the library> <version> <summary> <requirement>...

The library goes beside the Python module, whose runpath says to look there. The wheel is for the
Python that runs this, and for the VTK that the module was built with: that is part of its version.
"""

import base64
import glob
import hashlib
import os
import sys
import sysconfig
import zipfile

NAME = "vtkskdtree"


def installed_files(folder, library):
    """{name in the wheel: path} of the package and its library."""
    init, = glob.glob(os.path.join(folder, "**", NAME, "__init__.py"), recursive=True)
    package = os.path.dirname(init)
    files = {f"{NAME}/{name}": os.path.join(package, name) for name in sorted(os.listdir(package))
        if name != "__pycache__"}
    found = glob.glob(os.path.join(folder, "**", library), recursive=True)
    files[f"{NAME}/{library}"] = found[0]
    return files


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def metadata(version, summary, requirements):
    lines = ["Metadata-Version: 2.1", f"Name: {NAME}", f"Version: {version}", f"Summary: {summary}",
        "License: BSD-3-Clause", f"Requires-Python: =={sys.version_info.major}.{sys.version_info.minor}.*"]
    return "\n".join(lines + [f"Requires-Dist: {one}" for one in requirements]) + "\n"


def main(folder, licence, library, version, summary, *requirements):
    contents = {}
    for name, path in installed_files(os.path.join(folder, "installed"), library).items():
        with open(path, "rb") as file:
            contents[name] = file.read()
    about = f"{NAME}-{version}.dist-info"
    contents[f"{about}/METADATA"] = metadata(version, summary, requirements).encode()
    contents[f"{about}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: wheel.py\nRoot-Is-Purelib: false\n"
        f"Tag: {tag()}\n").encode()
    contents[f"{about}/entry_points.txt"] = f"[pyvista.accessors]\nskd = {NAME}.accessor\n".encode()
    with open(licence, "rb") as file:
        contents[f"{about}/LICENSE"] = file.read()
    record = ""
    for name, content in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    contents[f"{about}/RECORD"] = f"{record}{about}/RECORD,,\n".encode()
    wheel = os.path.join(folder, f"{NAME}-{version}-{tag()}.whl")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            archive.writestr(name, content)
    print(wheel)


main(*sys.argv[1:])
