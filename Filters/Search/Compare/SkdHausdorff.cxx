// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdHausdorff.h"

#include "Search/Compare/SkdWeightedValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
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
  Search(const SkdComparedSet& from, const SkdComparedSet& to, const SkdHausdorffLimits& limits,
    const SkdReduction& all)
    : From(from)
    , To(to)
    , Limits(limits)
    , All(all)
  {
  }

  bool Start(SkdLoop loop);
  SkdHausdorff Run(vtkAlgorithm* self, double first, double last);

private:
  Sample FindNearest(const skd::Vector3& x, double maxDistance) const;
  double GetBound(const std::array<Sample, 3>& corners) const;
  Sample Halve(const Piece& piece, int edge) const;
  void Bisect(const Piece& piece, Piece* halves) const;
  vtkIdType CountWider(double bound) const;
  double FindLimit() const;
  Pieces TakeWidest();
  bool BisectAll(const Pieces& pieces, SkdLoop loop);
  void Keep(const Piece& piece);
  bool Share(bool isWhole, std::size_t bisected);
  SkdHausdorff MakeResult() const;

  const SkdComparedSet& From;
  const SkdComparedSet& To;
  SkdHausdorffLimits Limits;
  const SkdReduction& All;
  Pieces Open;
  Sample Farthest{ {}, -1.0, -1 };
  vtkIdType FarthestElement = -1;
  double Settled = 0.0; // the largest bound of pieces that are not divided any more
  ///@{
  /// Of all processes.
  double Distance = 0.0;
  double UpperBound = 0.0;
  vtkIdType NumberOpen = 0;
  vtkIdType Bisections = 0;
  ///@}
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
  const double known = std::max(this->Farthest.Distance, this->Distance);
  if (piece.Bound > known + this->Limits.Tolerance)
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
  const std::vector<unsigned char> isOwn = this->From.FindOwnPoints();
  std::vector<Sample> samples(points.size());
  const auto findNearest = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      samples[i] = isOwn[i] ? this->FindNearest(points[i], std::numeric_limits<double>::max())
                            : Sample{ points[i], 0.0, -1 };
    }
  };
  bool isWhole = loop.For(static_cast<vtkIdType>(samples.size()), findNearest);
  const std::vector<SkdTriangleIds>& elements = this->From.GetElements();
  Pieces pieces(static_cast<std::size_t>(this->From.GetNumberOfOwn()));
  const auto bound = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType element = this->From.GetOwn(i);
      const SkdTriangleIds& ids = elements[element];
      pieces[i] = { { samples[ids[0]], samples[ids[1]], samples[ids[2]] }, 0.0, element };
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

// What all processes know of the distance, and what they have bisected, in one message: each takes
// its time. Returns whether all have come to the end.
bool Search::Share(bool isWhole, std::size_t bisected)
{
  double bound = std::max(this->Settled, this->Farthest.Distance);
  for (const Piece& piece : this->Open)
  {
    bound = std::max(bound, piece.Bound);
  }
  const std::vector<double> own{ this->Farthest.Distance, bound, isWhole ? 1.0 : 0.0,
    static_cast<double>(this->Open.size()), static_cast<double>(bisected) };
  const std::vector<double> all = this->All.Gather(own);
  this->Distance = all[0];
  this->UpperBound = all[1];
  this->NumberOpen = 0;
  bool areWhole = true;
  for (std::size_t at = 0; at < all.size(); at += own.size())
  {
    this->Distance = std::max(this->Distance, all[at]);
    this->UpperBound = std::max(this->UpperBound, all[at + 1]);
    areWhole = areWhole && all[at + 2] != 0.0;
    this->NumberOpen += static_cast<vtkIdType>(all[at + 3]);
    this->Bisections += static_cast<vtkIdType>(all[at + 4]);
  }
  return areWhole;
}

/// How many pieces all processes have that may hold more.
vtkIdType Search::CountWider(double bound) const
{
  return static_cast<vtkIdType>(
    this->All.Sum(static_cast<long long>(std::count_if(this->Open.begin(), this->Open.end(),
      [=](const Piece& piece) { return piece.Bound > bound; }))));
}

// Those that may hold much more than was found are bisected; the others may be excluded by what
// these hold. Of too many the widest.
double Search::FindLimit() const
{
  constexpr vtkIdType round = 1 << 18; // limited, so that little is done in vain
  const double limit =
    this->Distance + std::max(this->Limits.Tolerance, 0.25 * (this->UpperBound - this->Distance));
  const vtkIdType left = this->Limits.Bisections - this->Bisections;
  if (this->NumberOpen <= std::min(round, left))
  {
    return limit;
  }
  const vtkIdType wider = this->CountWider(limit);
  if (wider <= std::min(round, left))
  {
    return limit;
  }
  const SkdWeightedValues bounds(
    [&](const auto& visit)
    {
      for (const Piece& piece : this->Open)
      {
        if (piece.Bound > limit)
        {
          visit(SkdWeightedDistance{ piece.Bound, 1, 0 });
        }
      }
    },
    this->All);
  const double least =
    bounds.Find({ { wider - std::min(round, left), &SkdWeightedDistance::Fine } })[0];
  if (this->CountWider(least) > 0)
  {
    return least;
  }
  const double below = std::nextafter(least, 0.0); // many with the same bound
  return this->CountWider(below) <= left ? below : std::numeric_limits<double>::max();
}

Pieces Search::TakeWidest()
{
  const double limit = this->FindLimit();
  const auto isLeft = [&](const Piece& piece) { return !(piece.Bound > limit); };
  const auto first = std::stable_partition(this->Open.begin(), this->Open.end(), isLeft);
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
  this->Share(true, 0);
  bool isGoing = true;
  while (isGoing && this->UpperBound - this->Distance > this->Limits.Tolerance &&
    this->Bisections < this->Limits.Bisections)
  {
    const Pieces taken = this->TakeWidest();
    const double middle = (first + last) / 2.0;
    const bool isWhole = this->BisectAll(
      taken, SkdLoop(self, static_cast<vtkIdType>(taken.size()), first, middle, 1024));
    const vtkIdType before = this->Bisections;
    isGoing = this->Share(isWhole, taken.size()) && this->Bisections > before;
    first = middle;
  }
  return this->MakeResult();
}

// That of the process with the farthest, and in order: a tie goes to the lowest block and cell, and
// in it, which is on one process or on some that follow each other, to the first element.
SkdHausdorff Search::MakeResult() const
{
  std::vector<double> own(11, -1.0);
  own[0] = this->Farthest.Distance;
  const auto nearest = this->To.FindNearest(this->Farthest.At, std::numeric_limits<double>::max());
  if (this->FarthestElement >= 0 && nearest)
  {
    const SkdComparedSet::Origin& from = this->From.GetOrigin(this->FarthestElement);
    const SkdComparedSet::Origin& to = this->To.GetOrigin(nearest->CellId);
    own[1] = from.Block;
    own[2] = static_cast<double>(from.CellId);
    own[3] = to.Block;
    own[4] = static_cast<double>(to.CellId);
    std::copy_n(this->Farthest.At.X, 3, &own[5]);
    std::copy_n(nearest->Point, 3, &own[8]);
  }
  const std::vector<double> all = this->All.Gather(own);
  const double* best = all.data();
  for (std::size_t at = own.size(); at < all.size(); at += own.size())
  {
    const double* const other = &all[at];
    const bool isBefore = std::tie(other[1], other[2]) < std::tie(best[1], best[2]);
    best = other[0] > best[0] || (other[0] == best[0] && isBefore) ? other : best;
  }
  SkdHausdorff result;
  result.Distance = this->Distance;
  result.UpperBound = this->UpperBound;
  result.Bisections = this->Bisections;
  result.FromOrigin = { static_cast<int>(best[1]), static_cast<vtkIdType>(best[2]) };
  result.ToOrigin = { static_cast<int>(best[3]), static_cast<vtkIdType>(best[4]) };
  std::copy_n(best + 5, 3, result.From.X);
  std::copy_n(best + 8, 3, result.To.X);
  return result;
}
}

SkdHausdorff SkdHausdorffOf(const SkdComparedSet& from, const SkdComparedSet& to,
  const SkdHausdorffLimits& limits, const SkdReduction& all, vtkAlgorithm* self, double first,
  double last)
{
  const auto steps = static_cast<vtkIdType>(from.GetPoints().size() + from.GetElements().size());
  const double middle = (first + last) / 2.0;
  Search search(from, to, limits, all);
  return all.IsAny(!search.Start(SkdLoop(self, steps, first, middle)))
    ? SkdHausdorff()
    : search.Run(self, middle, last);
}
}
