// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdHausdorff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace skdtree
{
namespace
{
/// A point of the one set and the nearest of the other.
struct Sample
{
  skd::Vector3 At;
  double Distance;
  vtkIdType Nearest; // the element of the other set
};

/// A piece of a triangle. No point of it is farther away than Bound.
struct Piece
{
  std::array<Sample, 3> Corners;
  double Bound;
  vtkIdType Element;
};

using Pieces = std::vector<Piece>;

/// Ties go to the lowest element, and in it to the first point in lexicographic order.
bool IsFarther(const Sample& a, vtkIdType elementOfA, const Sample& b, vtkIdType elementOfB)
{
  if (a.Distance != b.Distance)
  {
    return a.Distance > b.Distance;
  }
  return elementOfA != elementOfB ? elementOfA < elementOfB : a.At < b.At;
}

class Search
{
public:
  Search(const SkdComparedSet& from, const SkdComparedSet& to, const SkdHausdorffLimits& limits)
    : From(from)
    , To(to)
    , Limits(limits)
  {
  }

  bool Start(SkdLoop loop);
  SkdHausdorff Run(vtkAlgorithm* self, double first, double last);

private:
  Sample FindNearest(const skd::Vector3& x, double maxDistance) const;
  double GetBound(const std::array<Sample, 3>& corners) const;
  Sample Halve(const Piece& piece, int edge) const;
  void Bisect(const Piece& piece, Piece* halves) const;
  Pieces TakeWidest(vtkIdType most);
  bool BisectAll(const Pieces& pieces, SkdLoop loop);
  void Keep(const Piece& piece);
  double GetUpperBound() const;

  const SkdComparedSet& From;
  const SkdComparedSet& To;
  SkdHausdorffLimits Limits;
  Pieces Open;
  Sample Farthest{ {}, -1.0, -1 };
  vtkIdType FarthestElement = -1;
  double Settled = 0.0; // the largest bound of pieces that are not divided any more
  vtkIdType Bisections = 0;
};

Sample Search::FindNearest(const skd::Vector3& x, double maxDistance) const
{
  const auto nearest = this->To.FindNearest(x, maxDistance);
  return nearest ? Sample{ x, std::sqrt(nearest->Distance2), nearest->CellId }
                 : Sample{ x, 0.0, -1 };
}

double Search::GetBound(const std::array<Sample, 3>& corners) const
{
  double bound = std::numeric_limits<double>::max();
  for (const Sample& corner : corners)
  {
    double toCorner2 = 0.0;
    double toNearest2 = 0.0;
    for (const Sample& other : corners)
    {
      toCorner2 = std::max(toCorner2, skd::Distance2(corner.At, other.At));
      toNearest2 = std::max(toNearest2,
        other.Nearest == corner.Nearest ? other.Distance * other.Distance
                                        : this->To.GetDistance2(corner.Nearest, other.At));
    }
    bound = std::min({ bound, corner.Distance + std::sqrt(toCorner2), std::sqrt(toNearest2) });
  }
  return bound;
}

// The middle of an edge. The nearest elements of the corners limit how far to search.
Sample Search::Halve(const Piece& piece, int edge) const
{
  const skd::Vector3& a = piece.Corners[edge].At;
  const skd::Vector3& b = piece.Corners[(edge + 1) % 3].At;
  const skd::Vector3 middle = b < a ? skd::Lerp(b, a, 0.5) : skd::Lerp(a, b, 0.5);
  double maxDistance2 = std::numeric_limits<double>::max();
  for (const Sample& corner : piece.Corners)
  {
    maxDistance2 = std::min(maxDistance2, this->To.GetDistance2(corner.Nearest, middle));
  }
  const Sample near = this->FindNearest(middle, SkdRadiusIncluding(maxDistance2));
  const bool isMissed = near.Nearest < 0; // the search rounds otherwise
  return isMissed ? this->FindNearest(middle, std::numeric_limits<double>::max()) : near;
}

void Search::Bisect(const Piece& piece, Piece* halves) const
{
  int longest = 0;
  double length2 = -1.0;
  for (int edge = 0; edge < 3; ++edge)
  {
    const double next = skd::Distance2(piece.Corners[edge].At, piece.Corners[(edge + 1) % 3].At);
    if (next > length2)
    {
      length2 = next;
      longest = edge;
    }
  }
  const Sample middle = this->Halve(piece, longest);
  for (int half = 0; half < 2; ++half)
  {
    halves[half] = piece;
    halves[half].Corners[(longest + half) % 3] = middle;
    halves[half].Bound = std::min(piece.Bound, this->GetBound(halves[half].Corners));
  }
}

void Search::Keep(const Piece& piece)
{
  for (const Sample& corner : piece.Corners)
  {
    if (IsFarther(corner, piece.Element, this->Farthest, this->FarthestElement))
    {
      this->Farthest = corner;
      this->FarthestElement = piece.Element;
    }
  }
  if (piece.Bound > this->Farthest.Distance + this->Limits.Tolerance)
  {
    this->Open.push_back(piece);
  }
  else
  {
    this->Settled = std::max(this->Settled, piece.Bound);
  }
}

bool Search::Start(SkdLoop loop)
{
  const std::vector<skd::Vector3>& points = this->From.GetPoints();
  std::vector<Sample> samples(points.size());
  const auto findNearest = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      samples[i] = this->FindNearest(points[i], std::numeric_limits<double>::max());
    }
  };
  bool isWhole = loop.For(static_cast<vtkIdType>(samples.size()), findNearest);
  const std::vector<SkdTriangleIds>& elements = this->From.GetElements();
  Pieces pieces(elements.size());
  const auto bound = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const SkdTriangleIds& ids = elements[i];
      pieces[i] = { { samples[ids[0]], samples[ids[1]], samples[ids[2]] }, 0.0, i };
      pieces[i].Bound = this->GetBound(pieces[i].Corners);
    }
  };
  isWhole = isWhole && loop.For(static_cast<vtkIdType>(pieces.size()), bound);
  for (std::size_t i = 0; isWhole && i < pieces.size(); ++i)
  {
    this->Keep(pieces[i]);
  }
  return isWhole;
}

double Search::GetUpperBound() const
{
  double bound = std::max(this->Settled, this->Farthest.Distance);
  for (const Piece& piece : this->Open)
  {
    bound = std::max(bound, piece.Bound);
  }
  return bound;
}

// Those that may hold much more than was found; the others may be excluded by what these hold.
Pieces Search::TakeWidest(vtkIdType most)
{
  const double least = this->Farthest.Distance;
  const double limit =
    least + std::max(this->Limits.Tolerance, 0.25 * (this->GetUpperBound() - least));
  const auto isLeft = [&](const Piece& piece) { return !(piece.Bound > limit); };
  const auto middle = std::stable_partition(this->Open.begin(), this->Open.end(), isLeft);
  const auto first = this->Open.end() - std::min<std::ptrdiff_t>(most, this->Open.end() - middle);
  Pieces taken(first, this->Open.end());
  this->Open.erase(first, this->Open.end());
  return taken;
}

bool Search::BisectAll(const Pieces& pieces, SkdLoop loop)
{
  Pieces halves(2 * pieces.size());
  const bool isWhole = loop.For(static_cast<vtkIdType>(pieces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Bisect(pieces[i], &halves[2 * i]);
      }
    });
  this->Bisections += static_cast<vtkIdType>(pieces.size());
  const Pieces former = std::exchange(this->Open, {});
  for (const Pieces* list : { &former, isWhole ? &halves : &pieces })
  {
    for (const Piece& piece : *list)
    {
      this->Keep(piece);
    }
  }
  return isWhole;
}

// Each round takes half of the progress that is left, for nobody knows how many there will be.
SkdHausdorff Search::Run(vtkAlgorithm* self, double first, double last)
{
  constexpr vtkIdType round = 1 << 18; // limited, so that little is done in vain
  bool isGoing = true;
  while (isGoing && !this->Open.empty() && this->Bisections < this->Limits.Bisections)
  {
    const Pieces taken =
      this->TakeWidest(std::min(round, this->Limits.Bisections - this->Bisections));
    const double middle = (first + last) / 2.0;
    isGoing = this->BisectAll(
      taken, SkdLoop(self, static_cast<vtkIdType>(taken.size()), first, middle, 1024));
    first = middle;
  }
  SkdHausdorff result;
  result.Distance = this->Farthest.Distance;
  result.UpperBound = this->GetUpperBound();
  result.From = this->Farthest.At;
  result.FromElement = this->FarthestElement;
  result.Bisections = this->Bisections;
  if (const auto nearest = this->To.FindNearest(result.From, std::numeric_limits<double>::max()))
  {
    std::copy_n(nearest->Point, 3, result.To.X);
    result.ToElement = nearest->CellId;
  }
  return result;
}
}

SkdHausdorff SkdHausdorffOf(const SkdComparedSet& from, const SkdComparedSet& to,
  const SkdHausdorffLimits& limits, vtkAlgorithm* self, double first, double last)
{
  if (from.IsEmpty() || to.IsEmpty())
  {
    return {};
  }
  const auto steps = static_cast<vtkIdType>(from.GetPoints().size() + from.GetElements().size());
  const double middle = (first + last) / 2.0;
  Search search(from, to, limits);
  return search.Start(SkdLoop(self, steps, first, middle)) ? search.Run(self, middle, last)
                                                           : SkdHausdorff();
}
}
