// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_ElementReader_h
#define skd_Tree_ElementReader_h

#include "TreeInput.h"

#include <array>
#include <numeric>
#include <vector>

namespace skd
{

/// Calls visit(element) for the elements first .. last - 1.
template <int D, class Visit>
void ReadInRow(
  const ElementReader<D>& read, std::uint32_t first, std::uint32_t last, const Visit& visit)
{
  constexpr std::uint32_t some = 256;
  std::array<std::uint32_t, some> indices;
  std::array<Element<D>, some> elements;
  for (; first < last; first += std::min(some, last - first))
  {
    const std::uint32_t number = std::min(some, last - first);
    std::iota(indices.begin(), indices.begin() + number, first);
    read(indices.data(), number, elements.data());
    std::for_each(elements.begin(), elements.begin() + number, visit);
  }
}

/// About `size` of the first `count` elements, evenly spread.
template <int D>
std::vector<Element<D>> ReadSample(
  const ElementReader<D>& read, std::uint32_t count, std::uint32_t size)
{
  std::vector<std::uint32_t> indices;
  for (std::uint64_t i = 0; i < count; i += 1 + count / size)
  {
    indices.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<Element<D>> sample(indices.size());
  read(indices.data(), indices.size(), sample.data());
  return sample;
}

/// The first `count` elements. `loop` as of Tree.
template <int D, class Loop>
RawVector<Element<D>> ReadAll(const ElementReader<D>& read, std::uint32_t count, Loop& loop)
{
  constexpr std::uint32_t piece = 1 << 14;
  RawVector<Element<D>> elements(count);
  loop((std::size_t(count) + piece - 1) / piece,
    [&](std::size_t i)
    {
      const auto first = static_cast<std::uint32_t>(i) * piece;
      ReadInRow<D>(read, first, first + std::min(piece, count - first),
        [&](const Element<D>& element) { elements[element.Index] = element; });
    });
  return elements;
}

}

#endif
