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

/// Memory of a large array, in the large pages of the processor where the system gives them when
/// asked (Linux: transparent huge pages, unless they are set to "never"). A query in a tree of a
/// million elements reads memory here and there; with pages of 4 kB the processor has forgotten
/// where most of them are, and looks for a page longer than for what is in it.
///
/// Only pages that the array fills are asked for: it never takes more memory than without.
class LargePages
{
public:
  static constexpr std::size_t PageSize = std::size_t(1) << 21;
  /// Below so many bytes there is nothing to gain.
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
