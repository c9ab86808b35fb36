#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# deb.sh <build> <work> <cpack> <pvpython> <python>
# Makes the .deb, unpacks it and uses plugin and Python package from what it holds.

set -euo pipefail
build=$1 work=$2 cpack=$3 pvpython=$4 python=$5
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$work"
mkdir -p "$work"
(cd "$build" && "$cpack" -G DEB -B "$work")
package=$(echo "$work"/*.deb)
dpkg-deb --info "$package"
dpkg-deb --field "$package" Depends | grep -q "paraview (>= .*), paraview (<< .*)"

dpkg-deb -x "$package" "$work/root"
plugin=$(find "$work/root" -name SkdTree.so)
package_folder=$(dirname "$(find "$work/root" -type d -name vtkskdtree)")
"$pvpython" "$here/use_plugin.py" "$plugin"
PYTHONPATH=$package_folder:${PYTHONPATH:-} "$python" "$here/use_package.py" "$work/root"
