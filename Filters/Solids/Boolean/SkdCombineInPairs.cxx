// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdCombineInPairs.h"

#include "Pipeline/SkdLoop.h"
#include "Solids/Boolean/SkdFacePoints.h"
#include "Solids/Boolean/SkdJoinPieces.h"
#include "Solids/Boolean/SkdSlivers.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
constexpr std::uint32_t None = 0xffffffffu;

/// A closed surface of pieces of a set's triangles. Points below the number of the set's points are
/// these, further ones new (with the set's scale).
struct Surface
{
  std::vector<Corners> Triangles;
  std::vector<std::uint32_t> Parents;
  std::vector<signed char> Signs; // of each: as its parent (1) or reversed
  std::vector<skd::Vector3> NewPoints;
};

/// Two surfaces as one set of triangles: those of the first come first.
class TwoSurfaces
{
public:
  TwoSurfaces(const SkdTriangleSet& origin, const Surface& first, const Surface& second)
    : Origin(origin)
  {
    const std::size_t count = first.Triangles.size() + second.Triangles.size();
    this->Read.Triangles.reserve(count);
    this->Read.Cells.push_back({ 0, 0 });
    this->Read.CellOf.assign(count, 0);
    for (const Surface* surface : { &first, &second })
    {
      this->Parents.insert(this->Parents.end(), surface->Parents.begin(), surface->Parents.end());
      this->Signs.insert(this->Signs.end(), surface->Signs.begin(), surface->Signs.end());
      this->SurfaceOf.resize(this->Parents.size(), surface == &second ? 1u : 0u);
      this->Add(*surface);
    }
    this->Set = SkdTriangleSet(std::move(this->Read));
    this->Set.LeaveOutCopies(1);
    this->FindGivenPoints();
  }

  SkdTriangleSet& GetSet() { return this->Set; }
  const std::vector<std::uint32_t>& GetSurfaces() const { return this->SurfaceOf; }
  std::uint32_t ParentOf(std::uint32_t triangle) const { return this->Parents[triangle]; }
  int SignOf(std::uint32_t triangle) const { return this->Signs[triangle]; }

  /// The point of the origin that a point of the set is, or None.
  std::uint32_t GivenPointOf(std::uint32_t point) const { return this->Given[point]; }

private:
  void Add(const Surface& surface)
  {
    const auto& points = this->Origin.GetPoints();
    std::vector<std::uint32_t> slots(points.size() + surface.NewPoints.size(), None);
    for (const Corners& triangle : surface.Triangles)
    {
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t point = triangle[i];
        if (slots[point] == None)
        {
          slots[point] = static_cast<std::uint32_t>(this->Read.Points.size());
          const bool isGiven = point < points.size();
          this->Read.Points.push_back(
            isGiven ? points[point] : surface.NewPoints[point - points.size()]);
          this->Sources.push_back(isGiven ? point : None);
        }
        corners[i] = slots[point];
      }
      this->Read.Triangles.push_back(corners);
    }
  }

  /// Of points that are merged, one of the origin counts.
  void FindGivenPoints()
  {
    this->Given.assign(this->Set.GetPoints().size(), None);
    for (std::uint32_t i = 0; i < this->Sources.size(); ++i)
    {
      std::uint32_t& given = this->Given[this->Set.GetPointOf(i)];
      given = std::min(given, this->Sources[i]);
    }
  }

  const SkdTriangleSet& Origin;
  SkdReadTriangles Read;
  SkdTriangleSet Set;
  std::vector<std::uint32_t> Parents;
  std::vector<signed char> Signs;
  std::vector<std::uint32_t> SurfaceOf;
  std::vector<std::uint32_t> Sources; // of points as they were read
  std::vector<std::uint32_t> Given;
};

/// Two surfaces, and the regions between them.
class Step
{
public:
  Step(
    const SkdTriangleSet& origin, SkdFaceSets& faces, const Surface& first, const Surface& second)
    : Surfaces(origin, first, second)
    , Origin(origin)
    , Faces(faces)
    , Placement(SkdMakePlacement(this->Surfaces.GetSet(), nullptr, std::nullopt))
  {
  }

  /// False after an abort, or if there are no winding numbers.
  bool Split(vtkAlgorithm* filter, double progress)
  {
    SkdLoop loop(filter, 0, progress, progress, 64);
    auto pairs = SkdFindSelfPairs(this->Surfaces.GetSet(), this->Placement, loop, filter);
    if (!pairs)
    {
      return false;
    }
    auto arrangement = SkdArrange(this->Placement, *pairs, loop);
    if (!arrangement)
    {
      return false;
    }
    this->Arrangement = *std::move(arrangement);
    this->Arrangement.Facets.Edges = skd::EdgeTable<>(); // which nobody asks for here
    this->Windings =
      SkdFindWindingNumbers(this->Placement, this->Arrangement, this->Surfaces.GetSurfaces());
    return this->Windings.size() == this->Arrangement.NumberOfRegions;
  }

  /// What bounds the regions that are solid.
  Surface Select(const SkdBooleanRule& rule, vtkIdType& numberFolded) const
  {
    const SkdFacets& facets = this->Arrangement.Facets;
    const SkdFacetSigns signs = SkdFindBoundary(this->Arrangement, this->Windings,
      [&rule](const SkdRegionWindings& windings) { return rule.IsSolid(windings); });
    const std::vector<std::uint32_t> equal = SkdFindEqualPoints(this->Placement, facets);
    std::optional<SkdRoundedFacets> rounded;
    if (!equal.empty())
    {
      rounded = SkdUniteEqualPoints(SkdMakeRounded(facets, signs), equal, false);
    }
    SkdRemoveSlivers(this->Placement, facets, signs, rounded);
    if (!rounded)
    {
      return this->Join(facets, signs);
    }
    numberFolded += rounded->NumberFolded;
    return this->Join(rounded->Facets, rounded->Signs);
  }

  template <class IsSolid>
  SkdBoundaryMeasures Measure(const IsSolid& isSolid) const
  {
    SkdBoundaryMeasures measures = SkdMeasureBoundary(this->Placement.First,
      this->Arrangement.Facets, SkdFindBoundary(this->Arrangement, this->Windings, isSolid));
    measures.Area /= std::pow(this->Placement.Scale, 2);
    measures.Volume /= std::pow(this->Placement.Scale, 3);
    return measures;
  }

  vtkIdType GetNumberSplit() const { return this->Arrangement.NumberSplit; }

private:
  Surface Join(const SkdFacets& facets, const SkdFacetSigns& signs) const
  {
    std::vector<std::uint32_t> origins(this->Surfaces.GetSurfaces().size());
    for (std::uint32_t triangle = 0; triangle < origins.size(); ++triangle)
    {
      origins[triangle] =
        2 * this->Surfaces.ParentOf(triangle) + (this->Surfaces.SignOf(triangle) < 0 ? 1 : 0);
    }
    const auto joined = SkdJoinPieces(this->Placement, facets, signs, origins, this->Faces);
    return joined ? this->Gather(joined->Facets, joined->Signs) : this->Gather(facets, signs);
  }

  Surface Gather(const SkdFacets& facets, const SkdFacetSigns& signs) const
  {
    Surface surface;
    const double unscaled = 1.0 / this->Placement.Scale;
    const std::size_t before = this->Placement.First.GetPoints().size();
    const std::size_t given = this->Origin.GetPoints().size();
    std::vector<std::uint32_t> numbers(before + facets.NewPoints.size(), None);
    const auto numberOf = [&](std::uint32_t point)
    {
      std::uint32_t& number = numbers[point];
      if (number == None)
      {
        number = point < before ? this->Surfaces.GivenPointOf(point) : None;
      }
      if (number == None)
      {
        number = static_cast<std::uint32_t>(given + surface.NewPoints.size());
        surface.NewPoints.push_back(unscaled * facets.GetPosition(this->Placement.First, point));
      }
      return number;
    };
    for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
    {
      if (signs[facet] != 0)
      {
        const Corners& from = facets.Corners[facet];
        Corners corners{ numberOf(from[0]), numberOf(from[1]), numberOf(from[2]) };
        if (signs[facet] < 0)
        {
          std::swap(corners[1], corners[2]);
        }
        surface.Triangles.push_back(corners);
        const std::uint32_t parent = facets.Parents[facet];
        surface.Parents.push_back(this->Surfaces.ParentOf(parent));
        surface.Signs.push_back(
          static_cast<signed char>(signs[facet] * this->Surfaces.SignOf(parent)));
      }
    }
    return surface;
  }

  TwoSurfaces Surfaces;
  const SkdTriangleSet& Origin;
  SkdFaceSets& Faces;
  SkdPlacement Placement;
  SkdArrangement Arrangement;
  std::vector<SkdRegionWindings> Windings;
};

Surface MakeLeaf(const SkdTriangleSet& set, const std::vector<std::uint32_t>& triangles)
{
  Surface surface;
  surface.Parents = triangles;
  surface.Signs.assign(triangles.size(), 1);
  for (const std::uint32_t triangle : triangles)
  {
    surface.Triangles.push_back(set.GetTriangles()[triangle]);
  }
  return surface;
}

/// How far all is, by solids that are combined.
struct Progress
{
  double Total;
  double Done = 0.0;
  double Get() const { return 0.6 + 0.2 * this->Done / this->Total; }
};

/// Combines the solids of groups, each from the leaves of a balanced tree on.
class SolidTree
{
public:
  SolidTree(const SkdTriangleSet& set, SkdFaceSets& faces, const SkdBooleanRule& rule,
    vtkAlgorithm* filter, Progress& progress)
    : Set(set)
    , Faces(faces)
    , Rule(rule)
    , Filter(filter)
    , Done(progress)
  {
  }

  /// The regions between the two groups, each combined; none after an abort, or if there are no
  /// winding numbers.
  std::unique_ptr<Step> Combine(const std::array<SkdSolidGroup, 2>& groups)
  {
    const std::optional<Surface> first = this->Combine(groups[0]);
    const std::optional<Surface> second = first ? this->Combine(groups[1]) : std::nullopt;
    return second ? this->Split(*first, *second) : nullptr;
  }

  vtkIdType NumberSplit = 0;
  vtkIdType NumberFolded = 0;

private:
  struct Leaf
  {
    const std::vector<std::uint32_t>* Solid;
    skd::Vector3 Center;
    std::size_t Number;
  };

  std::optional<Surface> Combine(const SkdSolidGroup& group)
  {
    std::vector<Leaf> leaves;
    for (const std::vector<std::uint32_t>& solid : group)
    {
      leaves.push_back({ &solid, this->CenterOf(solid), leaves.size() });
    }
    return leaves.empty() ? Surface() : this->Combine(leaves.data(), leaves.data() + leaves.size());
  }

  skd::Vector3 CenterOf(const std::vector<std::uint32_t>& solid) const
  {
    skd::Box3 box;
    for (const std::uint32_t triangle : solid)
    {
      for (const std::uint32_t corner : this->Set.GetTriangles()[triangle])
      {
        box.Add(this->Set.GetPoints()[corner]);
      }
    }
    return solid.empty() ? skd::Vector3{} : 0.5 * (box.Min + box.Max);
  }

  /// Solids near each other are combined first: halves by their centres along the longest axis.
  static Leaf* Halve(Leaf* first, Leaf* last)
  {
    skd::Box3 box;
    std::for_each(first, last, [&box](const Leaf& leaf) { box.Add(leaf.Center); });
    const skd::Vector3 size = box.Max - box.Min;
    const int axis = static_cast<int>(std::max_element(size.X, size.X + 3) - size.X);
    Leaf* const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
      [axis](const Leaf& a, const Leaf& b)
      {
        return a.Center[axis] != b.Center[axis] ? a.Center[axis] < b.Center[axis]
                                                : a.Number < b.Number;
      });
    return middle;
  }

  std::optional<Surface> Combine(Leaf* first, Leaf* last)
  {
    if (last - first == 1)
    {
      return MakeLeaf(this->Set, *first->Solid);
    }
    Leaf* const middle = Halve(first, last);
    std::optional<Surface> a = this->Combine(first, middle);
    std::optional<Surface> b = a ? this->Combine(middle, last) : std::nullopt;
    if (!b)
    {
      return std::nullopt;
    }
    const std::unique_ptr<Step> step = this->Split(*a, *b);
    return step ? std::make_optional(step->Select(this->Rule, this->NumberFolded)) : std::nullopt;
  }

  std::unique_ptr<Step> Split(const Surface& a, const Surface& b)
  {
    auto step = std::make_unique<Step>(this->Set, this->Faces, a, b);
    this->Done.Done += 1.0;
    if (!step->Split(this->Filter, this->Done.Get()))
    {
      return nullptr;
    }
    this->NumberSplit += step->GetNumberSplit();
    return step;
  }

  const SkdTriangleSet& Set;
  SkdFaceSets& Faces;
  const SkdBooleanRule Rule;
  vtkAlgorithm* Filter;
  Progress& Done;
};

/// A surface as facets, in the order of the triangles that they are of.
SkdRoundedFacets MakeFacets(
  const SkdPlacement& placement, SkdFaceSets& faces, const Surface& surface)
{
  const SkdMovedTriangles& set = placement.First;
  const std::size_t given = set.GetPoints().size();
  std::vector<std::uint32_t> order(surface.Triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return surface.Parents[a] < surface.Parents[b]; });
  SkdRoundedFacets rounded;
  SkdFacets& facets = rounded.Facets;
  std::vector<SkdSplitPoint> points;
  const std::vector<std::uint32_t> sameOrigins;
  SkdFacePoints onFaces(set, faces, sameOrigins);
  std::vector<std::uint32_t> numbers(surface.NewPoints.size(), None);
  for (const std::uint32_t i : order)
  {
    Corners corners = surface.Triangles[i];
    for (std::uint32_t& corner : corners)
    {
      if (corner >= given)
      {
        std::uint32_t& number = numbers[corner - given];
        if (number == None)
        {
          number = static_cast<std::uint32_t>(given + points.size());
          points.push_back(onFaces.PointAt(
            surface.Parents[i], placement.Scale * surface.NewPoints[corner - given]));
        }
        corner = number;
      }
    }
    if (surface.Signs[i] < 0)
    {
      std::swap(corners[1], corners[2]);
    }
    facets.Corners.push_back(corners);
    facets.Parents.push_back(surface.Parents[i]);
    rounded.Signs.push_back(surface.Signs[i]);
  }
  facets.NewPoints = std::move(points);
  return rounded;
}

SkdBooleanRule RuleOfTwo(SkdBooleanOperation operation, const SkdBooleanRule& rule)
{
  return { operation, rule.Inside, 2, 1 };
}

SkdBoundaryMeasures MeasureUnion(const Step& step, const SkdBooleanRule& rule)
{
  return step.Measure(
    [&rule](const SkdRegionWindings& windings) { return rule.CountSolids(windings) > 0; });
}

SkdBoundaryMeasures MeasureOperand(
  const Step& step, const SkdBooleanRule& rule, std::uint32_t operand)
{
  return step.Measure([&rule, operand](const SkdRegionWindings& windings)
    { return rule.IsInside(windings, operand); });
}
}

//------------------------------------------------------------------------------
std::optional<SkdCombinedSolids> SkdCombineInPairs(const SkdPlacement& placement,
  SkdFaceSets& faces, const SkdOperands& operands, const SkdBooleanRule& rule, vtkAlgorithm* filter)
{
  const SkdTriangleSet& set = placement.First.GetSet();
  const bool areUnited = operands.Within == SkdBooleanOperation::Union;
  const std::size_t count = operands.Groups[0].size() + operands.Groups[1].size();
  Progress progress{ static_cast<double>(areUnited ? count : 2 * count) };
  SolidTree tree(set, faces, RuleOfTwo(operands.Within, rule), filter, progress);
  std::unique_ptr<Step> last = tree.Combine(operands.Groups);
  if (!last)
  {
    return std::nullopt;
  }
  const SkdBooleanRule ofTwo = RuleOfTwo(rule.Operation, rule);
  const Surface result = last->Select(ofTwo, tree.NumberFolded);
  SkdCombinedSolids combined{ {},
    { MeasureOperand(*last, ofTwo, 0), MeasureOperand(*last, ofTwo, 1) },
    MeasureUnion(*last, ofTwo), tree.NumberSplit };
  last.reset();
  combined.Boundary = MakeFacets(placement, faces, result);
  combined.Boundary.NumberFolded = tree.NumberFolded;
  if (!areUnited)
  {
    // What is made on the way says nothing of the union.
    SkdFaceSets others = faces;
    const SkdBooleanRule unite = RuleOfTwo(SkdBooleanOperation::Union, rule);
    const auto all = SolidTree(set, others, unite, filter, progress).Combine(operands.Groups);
    if (!all)
    {
      return std::nullopt;
    }
    combined.Union = MeasureUnion(*all, unite);
  }
  return combined;
}
}
