#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# On a fresh Debian 12 or later, as root or with sudo: installs missing packages, builds into
# build/, and finds the closest points of a scanned surface by ParaView's own server with the plugin
# loaded.
#
# usage: bash Plugin/demo.sh [picture.png [points along an edge of the grid]]

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/prepare.sh"
picture=$(realpath -m "${1:-$build/closest_point.png}")
resolution=${2:-128}

install_missing "${packages[@]}"
configure_and_build default "$build" SkdTree vtkFiltersSkdTreePython
. "$build/setup.sh"

say "Starting ParaView's server"
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
log=$build/pvserver.log
: >"$log"
VTK_SMP_BACKEND_IN_USE=STDThread setsid "$with_display" pvserver --server-port="$port" >"$log" 2>&1 &
server=$!
trap 'kill -- "-$server" 2>/dev/null || true' EXIT
for _ in $(seq 300); do
  grep -q "Accepting connection" "$log" && break
  kill -0 "$server" 2>/dev/null || { cat "$log"; exit 1; }
  sleep 0.1
done

"$with_display" pvpython "$root/Plugin/Examples/ClosestPointDemo.py" \
  --server "127.0.0.1:$port" --data "$root/Data" --picture "$picture" --resolution "$resolution"
