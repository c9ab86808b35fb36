#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# play.sh <paraview> <pvpython> <script.xml> <data> <work>
# Plays the script in ParaView, which must find every menu and button that it names, and checks that
# its screenshot is not empty.

set -euo pipefail
paraview=$1 pvpython=$2 script=$3 data=$4 work=$5
picture=$work/$(basename "$script" .xml).png

mkdir -p "$work"
rm -f "$picture"
timeout 300 "$paraview" --dr --data-directory="$data" --test-directory="$work" \
  --test-script="$script" --exit
"$pvpython" "$(dirname "$0")/check_picture.py" "$picture"
