#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# with_display.sh <command>...
# Runs a command on a virtual X display of its own. (xvfb-run -a looks for a free number first and
# takes it later: two that start at once may get the same one.)

set -euo pipefail
number=$(mktemp)
Xvfb -noreset -displayfd 3 -screen 0 1600x1000x24 3>"$number" >/dev/null 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null || true; rm -f "$number"' EXIT
trap 'exit 143' TERM
until [ -s "$number" ]; do
  kill -0 "$server" || { echo "Xvfb did not start" >&2; exit 1; }
  sleep 0.05
done

# In the background, so that signals are handled at once.
DISPLAY=:$(cat "$number") "$@" <&0 &
wait $!
