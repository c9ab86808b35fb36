# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shared by Plugin/demo.sh and Testing/run.sh, which source it; for bash on Debian 12 and later.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
with_display=$root/.ci/with_display.sh

# Packages for the build and its use, and packages for the tests only. They include those that
# ParaView's build requires although its package does not depend on them; icons need Qt's SVG
# library.
packages=(
  cmake ninja-build g++ paraview paraview-dev python3-paraview python3-dev
  libopenmpi-dev libutfcpp-dev libdouble-conversion-dev libnetcdf-dev xvfb)
qt5=(qtbase5-dev qttools5-dev qtxmlpatterns5-dev-tools libqt5svg5)
qt6=(
  qt6-base-dev qt6-tools-dev qt6-5compat-dev qt6-declarative-dev qt6-svg-dev qt6-svg-plugins
  xsltproc)
case $(. /etc/os-release && echo "${VERSION_ID:-later}") in
  12) packages+=("${qt5[@]}") ;;                                 # ParaView 5.11
  13) packages+=("${qt6[@]}") ;;                                 # ParaView 5.13
  *) packages+=("${qt6[@]}" libvtk9-dev python3-vtk9) ;;         # ParaView 6, on Debian's own VTK
esac
test_packages=(
  libgtest-dev libbenchmark-dev libexpat1-dev libjpeg-dev liblzma-dev zlib1g-dev dpkg-dev file
  clang-format clang-tidy git mypy valgrind python3-numpy python3-venv)

say() { printf '\n== %s\n' "$*"; }

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

# install_missing <package>...: does nothing if all are installed.
install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed ||
      missing+=("$package")
  done
  [ ${#missing[@]} = 0 ] && return
  say "Installing ${missing[*]}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}" </dev/null
}

# configure_and_build <preset> <folder> [<target>...]: as is quickest for a build that nobody will edit.
configure_and_build() {
  local preset=$1 folder=$2
  shift 2
  command -v ccache >/dev/null &&
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache
  say "Building ($preset) into ${folder#"$root"/}"
  (cd "$root" && cmake --preset "$preset" -DSKDTREE_UNITY_BUILD=ON)
  cmake --build "$folder" ${*:+--target "$@"}
}
