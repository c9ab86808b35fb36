#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the wheel, installs it into a virtual environment by pip alone, and uses it there: nothing of
# the build tree is on a path. VTK and numpy are those of the system.
#
# usage: bash wheel.sh <cmake> <build folder> <environment> <python> <script>

set -euo pipefail
cmake=$1 build=$2 environment=$3 python=$4 script=$5

"$cmake" --build "$build" --target wheel
rm -rf "$environment"
"$python" -m venv --system-site-packages "$environment"
"$environment/bin/pip" install --no-index --no-deps --disable-pip-version-check "$build"/wheel/*.whl
unset LD_LIBRARY_PATH
cd /
"$environment/bin/python" "$script" "$environment"
"$environment/bin/pip" show --files vtkskdtree | grep -x "  vtkskdtree/py.typed"
"$environment/bin/python" -c 'import importlib.metadata as metadata
assert any(one.value == "vtkskdtree.accessor" for one in metadata.distribution("vtkskdtree").entry_points)'
"$environment/bin/pip" uninstall --yes --disable-pip-version-check vtkskdtree
