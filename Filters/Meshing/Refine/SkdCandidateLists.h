// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCandidateLists_h
#define SkdCandidateLists_h

#include "Core/Search/Queries/CandidateLists.h"

#include <vector>

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

  struct Range
  {
    const Span* First;
    const Span* Last;
    const Span* begin() const { return this->First; }
    const Span* end() const { return this->Last; }
  };

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

  std::size_t GetNumberOfBoxes() const { return this->Boxes.size() - 1; }
  Range Of(std::size_t box) const
  {
    const Span* spans = this->Spans.data();
    return { spans + this->Boxes[box], spans + this->Boxes[box + 1] };
  }
  const skd::CandidateLanes* GetLanes() const { return this->Lanes.data(); }

  ///@{
  /// A box at the end: append the lanes of each part and end its span, then end the box.
  std::vector<skd::CandidateLanes>& GetOpenSpan() { return this->Lanes; }
  std::size_t GetSize() const { return this->Lanes.size(); }
  void EndSpan(std::uint32_t part, std::size_t first)
  {
    this->Spans.push_back({ part, first, this->Lanes.size() });
  }
  void EndBox() { this->Boxes.push_back(this->Spans.size()); }
  ///@}

  /// Appends the boxes of another sequence.
  void Append(const SkdCandidateLists& other)
  {
    const std::size_t lanes = this->Lanes.size();
    const std::size_t spans = this->Spans.size();
    this->Lanes.insert(this->Lanes.end(), other.Lanes.begin(), other.Lanes.end());
    for (const Span& span : other.Spans)
    {
      this->Spans.push_back({ span.Part, span.First + lanes, span.Last + lanes });
    }
    for (std::size_t box = 1; box < other.Boxes.size(); ++box)
    {
      this->Boxes.push_back(other.Boxes[box] + spans);
    }
  }

private:
  std::vector<std::size_t> Boxes{ 0 }; // a box has the spans from its entry to the next
  std::vector<Span> Spans;
  std::vector<skd::CandidateLanes> Lanes;
};

#endif
