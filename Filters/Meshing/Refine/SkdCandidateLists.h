// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCandidateLists_h
#define SkdCandidateLists_h

#include "Core/Geometry/Rows.h"
#include "Core/Search/Queries/CandidateLanes.h"

#include <vector>

namespace skdtree
{
/// The candidates of each part for each box in a sequence.
class SkdCandidateLists
{
public:
  /// The candidates of one part for a box.
  struct Span
  {
    std::uint32_t Part;
    std::size_t First; // in Lanes
    std::size_t Last;
  };

  using Range = skd::Rows<Span>::Row;

  /// One box: all of so many parts.
  static SkdCandidateLists OfAll(std::uint32_t parts)
  {
    SkdCandidateLists all;
    for (std::uint32_t part = 0; part < parts; ++part)
    {
      all.Lanes.push_back(skd::AllCandidates().front());
      all.EndSpan(part, part);
    }
    all.EndBox();
    return all;
  }

  std::size_t GetNumberOfBoxes() const { return this->Spans.size(); }
  Range Of(std::size_t box) const { return this->Spans[box]; }
  const skd::CandidateLanes* GetLanes() const { return this->Lanes.data(); }

  ///@{
  /// A box at the end: append the lanes of each part and end its span, then end the box.
  std::vector<skd::CandidateLanes>& GetOpenSpan() { return this->Lanes; }
  std::size_t GetSize() const { return this->Lanes.size(); }
  void EndSpan(std::uint32_t part, std::size_t first)
  {
    this->Open.push_back({ part, first, this->Lanes.size() });
  }
  void EndBox()
  {
    this->Spans.Add(this->Open.begin(), this->Open.end());
    this->Open.clear();
  }
  ///@}

  /// Appends the boxes of another sequence.
  void Append(const SkdCandidateLists& other)
  {
    const std::size_t lanes = this->Lanes.size();
    this->Lanes.insert(this->Lanes.end(), other.Lanes.begin(), other.Lanes.end());
    for (std::size_t box = 0; box < other.GetNumberOfBoxes(); ++box)
    {
      for (const Span& span : other.Of(box))
      {
        this->Open.push_back({ span.Part, span.First + lanes, span.Last + lanes });
      }
      this->EndBox();
    }
  }

private:
  skd::Rows<Span> Spans;  // of each box
  std::vector<Span> Open; // of a box that has not ended
  std::vector<skd::CandidateLanes> Lanes;
};
}

#endif
