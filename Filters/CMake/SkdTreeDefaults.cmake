# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Defaults of a build: optimized, with C++17, outputs in bin/ and lib/.

get_property(is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if (NOT CMAKE_BUILD_TYPE AND NOT is_multi_config)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif ()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if (SKDTREE_SANITIZE)
  list(JOIN SKDTREE_SANITIZE "," sanitizers)
  add_compile_options(
    -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
  # AddressSanitizer finds such an address when it is used; to look for it everywhere takes a quarter
  # of the time to compile.
  if ("address" IN_LIST SKDTREE_SANITIZE AND "undefined" IN_LIST SKDTREE_SANITIZE)
    add_compile_options(-fno-sanitize=null,pointer-overflow,object-size,vptr)
  endif ()
endif ()
