// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Element_h
#define skd_Tree_Element_h

#include "../../Geometry/TwoDoubles.h"
#include "Frame.h"

#include <cstdint>

namespace skd
{

/// An element of a tree: its safety box in the tree's frame, and its index.
template <int D>
struct alignas(16) Element
{
  FloatBox<D> Box;
  std::uint32_t Index;
};

/// Enclose() for a box that stays in memory: of boxes in space by vectors.
template <int D>
void EncloseInMemory(FloatBox<D>& box, const Element<D>& element)
{
#if SKD_HAS_DOUBLE_LANES
  if constexpr (D == 3)
  {
    const __m128 a = _mm_loadu_ps(box.Min), b = _mm_load_ps(element.Box.Min); // x, y, z, x
    const __m128 least = _mm_min_ps(a, b), greatest = _mm_max_ps(a, b);
    const __m128 zx = _mm_shuffle_ps(least, greatest, _MM_SHUFFLE(3, 3, 2, 2));
    const auto read = [](const float* yz)
    { return _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(yz))); };
    const __m128 yz = _mm_max_ps(read(box.Max + 1), read(element.Box.Max + 1));
    _mm_storeu_ps(box.Min, _mm_shuffle_ps(least, zx, _MM_SHUFFLE(2, 0, 1, 0)));
    _mm_storel_pi(reinterpret_cast<__m64*>(box.Max + 1), yz);
    return;
  }
#endif
  Enclose(box, element.Box);
}

}

#endif
