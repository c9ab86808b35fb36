#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command in this repository on another release of Debian, as a user would. As root: creates
# a minimal system of that release in a folder, or uses the existing one. Without a command: the two
# commands of the README.
#
# usage: bash Testing/on_debian.sh <bookworm|trixie|sid|...> [command [argument...]]
# as in: bash Testing/on_debian.sh trixie bash Testing/run.sh --no-sanitizers
#
# The repository is seen there as /skdtree, as it is; its build/ is the system's own. Nothing stays
# mounted. These variables may be set:
#   SKDTREE_DEBIAN_DIR      where systems are made, one folder a release (build/debian)
#   SKDTREE_DEBIAN_MIRROR   where packages come from (debootstrap's own default)
#   SKDTREE_EXTRA_DATA_DIR  more real meshes for the tests (../shared/data)

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/prepare.sh"
[ $# -gt 0 ] || { sed -n '/^# Runs/,/^$/s/^# \?//p' "${BASH_SOURCE[0]}"; exit 2; }
[ "$(id -u)" = 0 ] || { echo "Only root can make and enter systems" >&2; exit 1; }
release=$1
shift
system=$(realpath -m "${SKDTREE_DEBIAN_DIR:-$build/debian}")/$release
data=${SKDTREE_EXTRA_DATA_DIR:-$root/../shared/data}

if ! [ -e "$system/etc/apt/apt.conf.d/90skdtree" ]; then
  install_missing debootstrap
  say "Making a bare $release in $system"
  mkdir -p "$system"
  debootstrap --variant=minbase "$release" "$system" ${SKDTREE_DEBIAN_MIRROR:+"$SKDTREE_DEBIAN_MIRROR"}
  # A mirror may be some days behind.
  echo 'Acquire::Check-Valid-Until "false";' >"$system/etc/apt/apt.conf.d/90skdtree"
fi

commands='bash Plugin/demo.sh && bash Testing/run.sh'
[ $# -gt 0 ] || set -- bash -c "$commands"
mkdir -p "$build" "$system"/{skdtree,skdtree-build,shared/data}
export system root build data
say "On $release: $*"
exec unshare --mount --propagation private bash -euc '
  for folder in proc sys dev dev/shm; do
    mountpoint -q "$system/$folder" || mount --rbind "/$folder" "$system/$folder"
  done
  mount --bind "$root" "$system/skdtree"
  mount --bind "$system/skdtree-build" "$system/skdtree/build"
  [ ! -d "$data" ] || mount --bind "$data" "$system/shared/data"
  exec chroot "$system" /usr/bin/env -i HOME=/root TERM="${TERM:-dumb}" LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    bash -c "cd /skdtree && exec \"\$@\"" bash "$@"' bash "$@"
