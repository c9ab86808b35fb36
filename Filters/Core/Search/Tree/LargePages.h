// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_LargePages_h
#define skd_Tree_LargePages_h

#include <cstddef>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace skd
{

/// Memory of a large array in huge pages, where the system provides them (Linux: transparent huge
/// pages, unless set to "never"). Queries in a tree of a million elements access scattered memory;
/// with pages of 4 kB most accesses miss the processor's address translation cache, which takes
/// longer than the access itself.
///
/// Only pages that the array fills are requested, so it never takes more memory.
class LargePages
{
public:
  static constexpr std::size_t PageSize = std::size_t(1) << 21;
  /// Smaller arrays do not benefit.
  static constexpr std::size_t Least = 2 * PageSize;

  static void* Allocate(std::size_t bytes)
  {
    void* const first = ::operator new(bytes, std::align_val_t(PageSize));
#if defined(MADV_HUGEPAGE)
    // Only a hint: what it returns does not matter.
    (void)madvise(first, bytes / PageSize * PageSize, MADV_HUGEPAGE);
#endif
    return first;
  }

  static void Free(void* first)
  {
    ::operator delete(first, std::align_val_t(PageSize));
  }
};

}

#endif
