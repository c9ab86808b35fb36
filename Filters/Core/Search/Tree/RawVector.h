// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_RawVector_h
#define skd_Tree_RawVector_h

#include "LargePages.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace skd
{

/// Does not initialize values constructed without arguments. Large arrays use huge pages.
template <class T>
struct RawAllocator : std::allocator<T>
{
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  template <class U>
  struct rebind
  {
    using other = RawAllocator<U>;
  };

  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>&)
  {
  }

  T* allocate(std::size_t count)
  {
    return IsLarge(count) ? static_cast<T*>(LargePages::Allocate(count * sizeof(T)))
                          : std::allocator<T>::allocate(count);
  }
  void deallocate(T* first, std::size_t count)
  {
    if (IsLarge(count))
    {
      LargePages::Free(first);
    }
    else
    {
      std::allocator<T>::deallocate(first, count);
    }
  }

  template <class U>
  void construct(U*) noexcept
  {
  }
  template <class U, class... Arguments>
  void construct(U* where, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(where)) U(std::forward<Arguments>(arguments)...);
  }

private:
  static_assert(alignof(T) <= LargePages::PageSize);

  /// Impossible sizes are left to std::allocator, which throws.
  static bool IsLarge(std::size_t count)
  {
    return count >= LargePages::Least / sizeof(T) &&
      count <= std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T);
  }
};

/// A vector whose constructor and resize() do not initialize values, so that several threads can
/// write large ones first.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}

#endif
