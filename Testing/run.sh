#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# On a fresh Debian 12 or later, as root or with sudo: installs missing packages, builds into build/
# and runs all tests; then builds and runs the C++ tests again with AddressSanitizer and
# UndefinedBehaviorSanitizer. With --no-sanitizers it does not, and the test of the remote module
# compiles each source alone instead of in groups.
#
# usage: bash Testing/run.sh [--no-sanitizers] [options of ctest]

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/prepare.sh"
with_sanitizers=yes
if [ "${1:-}" = --no-sanitizers ]; then
  with_sanitizers=no
  shift
fi

failed=()
run_tests() {
  local preset=$1
  shift
  say "Testing ($preset)"
  (cd "$root" && ctest --preset "$preset" -j "$(nproc)" "$@" </dev/null) || failed+=("$preset")
}

[ $with_sanitizers = no ] || export SKDTREE_REMOTE_IN_GROUPS=ON
install_missing "${packages[@]}" "${test_packages[@]}"
configure_and_build default "$build"
run_tests default "$@"
if [ $with_sanitizers = yes ]; then
  configure_and_build asan-ubsan "$build/asan-ubsan"
  run_tests asan-ubsan "$@"
fi

if [ ${#failed[@]} != 0 ]; then
  say "FAILED: ${failed[*]}"
  exit 1
fi
say "All tests passed"
