// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellTree_h
#define SkdCellTree_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Cells/Kernels/SkdCellSource.h"
#include "Cells/Search/SkdCellStore.h"
#include "Cells/Search/SkdEqualCells.h"
#include "Cells/Search/SkdLeafFilters.h"
#include "Cells/Search/SkdPieceRuns.h"
#include "Cells/Search/SkdWideWalks.h"
#include "Core/Geometry/Plane.h"
#include "Core/Geometry/RigidMotion.h"
#include "Core/Geometry/Segment.h"
#include "Core/Search/Tree/Tree.h"
#include "Core/Search/Tree/TreeInput.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class vtkDoubleArray;
class vtkIdList;

namespace skd
{
class SegmentView;
struct CandidateLanes;
struct SimplexSet;
template <int D>
class LazyTree;
template <int D>
struct PaperTree;
}

namespace skdtree
{
struct SkdTreeSettings
{
  double Epsilon = 1e-9; ///< relative to the diagonal
  SkdMeshExtent Whole;   ///< of the mesh that this is a part of; empty: it is all
  int Capacity = 8;      ///< cells a leaf
  bool IsLazy = false;
  bool IsBare = false; ///< there is no tree: only queries of single cells work
  bool SkipsGhosts = true;
  SkdMagnitudes Magnitudes = SkdMeasurable;        ///< of coordinates; others count as not finite
  skd::SplitRule Rule = skd::SplitRule::Automatic; ///< of trees that are built whole
};

/// The cell that answers a query about a point; Id is -1 when there is none.
struct SkdFoundCell : SkdCellPoint
{
  vtkIdType Id = -1;
};

/// A cell hit by a segment.
struct SkdHitCell : SkdLineHit
{
  vtkIdType Id = -1;
};

/// A cell that one of several lines hits.
struct SkdHitOfLine
{
  int Line;
  double T;
  vtkIdType Id;
};

/// A crossing of a segment and a surface: the cells Cells[First .. Last) of its list.
struct SkdCrossing
{
  double T;
  std::size_t First;
  std::size_t Last;
  bool Passes;
};

/// A facet that a segment passes through, and the direction: 1 along its normal, -1 against it.
struct SkdPass
{
  double T;
  vtkIdType Id;
  int Direction;
};

/// All crossings of a segment; the vectors are reused from call to call.
struct SkdCrossings
{
  std::vector<SkdCrossing> List;
  std::vector<vtkIdType> Cells;
};

/// The number of lines that SkdCellTree::FindFirstHits and FindHitsOfLines take.
constexpr int SkdLinesAtOnce = 8;

/// The test for the intersection of a cell and a box: by the cell itself, or by its safety box
/// ("blind", section 6.5).
enum class SkdOverlapTest
{
  Exact,
  Blind
};

/// The candidates of a box after NarrowCandidates.
struct SkdCandidateRange
{
  const skd::CandidateLanes* First;
  const skd::CandidateLanes* Last;
};

/// The cells of a data set, their skD-tree, and all queries of the public classes. Immutable;
/// thread-safe if each thread has its own cell source. It keeps no reference to the data set, which
/// is an argument of queries.
///
/// A distance that is "0 to within rounding" is at most Rounding(): 8 units in the last place of
/// the largest coordinate.
class SkdCellTree
{
public:
  SkdCellTree(vtkDataSet* data, const SkdTreeSettings& settings);
  SkdCellTree(SkdCellStore&& store, const SkdTreeSettings& settings);
  SkdCellTree(const SkdCellTree&) = delete; // a tree that is built on query reads these cells
  SkdCellTree& operator=(const SkdCellTree&) = delete;
  ~SkdCellTree();

  const SkdCellStore& Cells() const { return this->Store; }
  bool IsBare() const { return this->Bare; }
  double Rounding() const { return this->TheRounding; }
  double AbsoluteEpsilon() const { return this->TheEpsilon; }

  ///@{
  /// Statistics. Depth: the number of nodes from the root to the lowest, both counted.
  std::size_t NumberOfNodes() const;
  int Depth() const;
  std::size_t MemorySize() const;
  skd::SplitRule Rule() const; ///< what divided it: never Automatic
  /// So many do queries that need one of equal cells look at (SkdEqualCells), instead of all.
  std::uint32_t NumberOfDistinctCells() const { return this->WithoutEqual().Store.NumberOfCells(); }
  ///@}

  ///@{
  /// SkdPointQueries.cxx. Ties go to the lowest id; nothing is found for points that are not
  /// finite or so large that their distances overflow (SkdHasDistances).
  SkdFoundCell FindNearest(const skd::Vector3& x, double limit2, const SkdCellSource& source) const;
  SkdFoundCell FindContaining(
    const skd::Vector3& x, double tolerance2, vtkIdType hint, const SkdCellSource& source) const;
  /// Nearest first; all within the limit, at most `number`. In a thread-local vector.
  std::vector<std::pair<double, vtkIdType>>& FindNearestCells(
    const skd::Vector3& x, std::size_t number, double limit2, const SkdCellSource& source) const;
  /// The sub-id, pcoords and (unless nullptr) weights at the point of a found cell.
  void Interpolate(SkdFoundCell& found, double* weights, const SkdCellSource& source) const;
  /// The parametric coordinates at x of a cell after the motion (or nullptr), given those in the
  /// tree: a polyhedron's are relative to its bounds, which change with a rotation.
  skd::Vector3 MovedPCoords(const skd::RigidMotion* motion, vtkIdType id, const skd::Vector3& x,
    const skd::Vector3& pcoords) const
  {
    return motion ? this->PCoordsAfter(*motion, id, x, pcoords) : pcoords;
  }
  ///@}

  ///@{
  /// SkdLineQueries.cxx. A negative tolerance counts as zero. Vectors are the calling thread's.
  SkdHitCell FindFirstHit(
    const skd::Segment<3>& segment, double tolerance, const SkdCellSource& source) const;
  /// Whether lines begin and end so near each other that it pays to walk once for all. Of triangles
  /// only.
  bool AreAlike(const skd::Segment<3>* segments, int count) const;
  /// FindFirstHit of at most SkdLinesAtOnce lines, into as many answers that have found nothing
  /// yet. False: they are not alike, or run different ways, and each is to be asked by itself.
  bool FindFirstHits(
    const skd::Segment<3>* segments, int count, double tolerance, SkdHitCell* firsts) const;
  const std::vector<SkdHitCell>& FindHits(
    const skd::Segment<3>& segment, double tolerance, const SkdCellSource& source) const;
  /// FindHits of at most SkdLinesAtOnce lines, line by line. nullptr: as false of FindFirstHits.
  const std::vector<SkdHitOfLine>* FindHitsOfLines(
    const skd::Segment<3>* segments, int count, double tolerance) const;
  /// Of the bounds that the cells have after the motion, unless nullptr; the segment is there, too.
  const std::vector<SkdHitCell>& FindBoundsHits(
    const skd::Segment<3>& segment, double tolerance, const skd::RigidMotion* motion) const;
  const SkdCrossings& FindCrossings(
    const skd::Segment<3>& segment, const SkdCellSource& source) const;
  /// Sorted by (T, Id); the direction is 0 for non-linear cells.
  const std::vector<SkdPass>& FindPasses(
    const skd::Segment<3>& segment, const SkdCellSource& source) const;
  ///@}

  ///@{
  /// SkdBorderQueries.cxx. FindBorders adds the parameters, in any order, at which the segment may
  /// pass from one cell to another: 0 and 1, where it crosses faces of volumes, and edges of
  /// surfaces and ends of curves that it comes near to the tolerance. There may be others among
  /// them; none of a segment of no length. Evaluate: the point of one cell nearest to x; Id -1 of a
  /// cell that is not in the tree.
  void FindBorders(const skd::Segment<3>& segment, double tolerance, const SkdCellSource& source,
    std::vector<double>& parameters) const;
  SkdFoundCell Evaluate(vtkIdType id, const skd::Vector3& x, const SkdCellSource& source) const;
  ///@}

  /// @{ SkdBoxQueries.cxx. Exact on the cells' bounds (as if moved by `motion`, unless nullptr), or
  /// on their safety boxes. In the order of the tree, which is reproducible.
  void FindWithinBounds(const skd::Box3& box, const skd::RigidMotion* motion, vtkIdList* ids) const;
  void FindAlongPlane(const skd::Plane<3>& plane, double tolerance, const skd::RigidMotion* motion,
    vtkIdList* ids) const;
  bool BoundsHold(
    const skd::Vector3& x, vtkIdType id, double tolerance, const skd::RigidMotion* motion) const;
  void FindNearestCandidates(
    const skd::Vector3& x, const skd::Vector3* reference, vtkIdList* ids) const;
  void FindSafetyBoxesAlong(const skd::Segment<3>& segment, vtkIdList* ids) const;
  void FindSafetyBoxesWithin(const skd::Box3& box, vtkIdList* ids) const;
  void FindSafetyBoxesWithin(const skd::Vector3& x, double radius, vtkIdList* ids) const;
  void FindSafetyBoxesAlong(const skd::Plane<3>& plane, double tolerance, vtkIdList* ids) const;
  /// Adds cells whose safety boxes may be within the distance, without testing each: all that are,
  /// and some more.
  void FindMaybeWithin(const skd::Box3& box, std::vector<std::uint32_t>& cells) const;
  void FindMaybeWithin(
    const skd::Vector3& x, double radius, std::vector<std::uint32_t>& cells) const;
  ///@}

  ///@{
  /// SkdPairQueries.cxx. Pairs whose safety boxes overlap, by (id here, id there); `motion` takes
  /// the other's world to this one's. Pairs of cells whose bounds overlap, in parts: these and
  /// their order depend on the two trees alone.
  using CellPair = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<std::pair<vtkIdType, vtkIdType>> FindOverlappingPairs(
    const SkdCellTree& other, const skd::RigidMotion& motion) const;
  std::vector<std::vector<CellPair>> FindBoundsPairs(const SkdCellTree& other) const;
  ///@}

  ///@{
  /// SkdFamilyQueries.cxx: boxes that are parts of boxes (section 6.5,
  /// Core/Search/Queries/CandidateLists.h). Whether the cell and the closed box have a point in
  /// common. A quad is two triangles, and a polygon flat, as they are for segments; a volume cell
  /// is what its faces enclose, so taken; cells of shape Generic are taken for their boxes.
  bool Overlaps(std::uint32_t cell, const skd::Box3& box) const;
  bool IsMet(std::uint32_t cell, const skd::Box3& box, SkdOverlapTest test) const;
  /// Whether a cell intersects the box; the candidates for its sub-boxes are appended to `below`.
  bool NarrowCandidates(const SkdCandidateRange& above, const skd::Box3& box, SkdOverlapTest test,
    std::vector<skd::CandidateLanes>& below) const;
  /// The number of cells that intersect the box.
  std::uint32_t CountListed(
    const SkdCandidateRange& above, const skd::Box3& box, SkdOverlapTest test) const;
  /// SkdNormalDeviation.cxx: the largest deviation, in radians, of the normals of surface cells
  /// that intersect the box from their mean; pi if other than planar surface cells intersect it, or
  /// if there is no mean. Normals are as the order of the cells' points has them.
  double FindNormalDeviation(
    const SkdCandidateRange& above, const skd::Box3& box, SkdOverlapTest test) const;
  /// The same for the candidates of the box for which `isMet(cell)` is true.
  double FindNormalDeviation(
    const skd::Box3& box, const std::function<bool(std::uint32_t)>& isMet) const;
  /// Calls visit(cell) for the listed cells that may intersect the box: SkdVisitCandidates.h has
  /// it.
  template <class Visit>
  void VisitCandidates(const SkdCandidateRange& above, const skd::Box3& box, Visit visit) const;
  ///@}

  /// SkdCellSimplices.cxx: the cell as what triangles enclose, or as triangles, segments or points.
  /// A quad is two triangles, and a polygon flat, as they are for boxes; a curved cell is what 8
  /// straight pieces along each of its parameters make of it. The rim is not found. Of no dimension
  /// but 0 to 3 is a cell that VTK cannot take apart: it is its points.
  void GetSimplices(
    std::uint32_t cell, const SkdCellSource& source, skd::SimplexSet& simplices) const;
  /// Whether the cell, as above, has a point in common with a set. Curved cells count by their
  /// boxes.
  bool Meets(std::uint32_t cell, const skd::SimplexSet& set) const;
  /// Whether the cell, as what GetSimplices() makes of it, is that near to a set.
  bool IsWithin(std::uint32_t cell, const SkdCellSource& source, const skd::SimplexSet& set,
    double maxDistance2) const;

  /// Algorithm 3.1 as printed, on the safety boxes; elements are cells of the store.
  skd::PaperTree<3> MakePaperTree() const;

  /// SkdCellStore::Load, of the cell with VTK's id.
  bool Load(vtkIdType id, vtkGenericCell* loaded) const
  {
    const std::int64_t cell = this->Store.CellOfId(id);
    return cell >= 0 && this->Store.Load(static_cast<std::uint32_t>(cell), loaded);
  }

  /// The bounds of the cell's points, moved by the motion unless nullptr.
  skd::Box3 WorldBoundsOf(std::uint32_t cell, const skd::RigidMotion* motion) const;

  skd::Box3 SafetyBoxOf(std::uint32_t cell) const
  {
    return this->Store.ExtentOf(cell).Inflated(2.0 * this->TheEpsilon);
  }
  /// By how much the boxes of the tree are wider, at most, than those of the cells, on each side.
  double BoxExcess() const { return this->SafetyMargin() + this->View.Widening(); }
  /// Of safety boxes, and what their rounding adds: less than an eighth of epsilon.
  double SafetyMargin() const { return (2.0 + 1.0 / 8.0) * this->TheEpsilon; }

private:
  skd::ReadInput<3> MakeInput(const SkdTreeSettings& settings);
  void ReadElements(const skd::Frame<3>& frame, const std::uint32_t* cells, std::size_t count,
    skd::Element<3>* to) const;
  void FindEqualCells(const SkdTreeSettings& settings);
  double MaxSpreadOfLines() const;
  /// The tree for queries that need one of equal cells only.
  const SkdCellTree& WithoutEqual() const { return this->Distinct ? *this->Distinct : *this; }

  ///@{
  /// SkdCellTreeWalk.h: runs a query on whichever tree there is; the frame of that.
  template <class Query>
  void Walk(Query& query) const;
  const skd::Frame<3>& GetFrame() const;
  ///@}
  /// Calls wide(tree) if AVX2 queries are available for it (SkdWideWalks.h); else returns false.
  template <class Wide>
  bool WalkWide(Wide wide) const
  {
    if (this->Lazy || !SkdWideWalks::AreOn())
    {
      return false;
    }
    wide(SkdWideTree{ &this->View, &this->Packets });
    return true;
  }
  /// skd::Nearest and skd::AlongSegment in their fastest available form.
  template <bool OnlyNearest, class Visitor>
  void WalkNearest(const skd::Vector3& x, double limit2, Visitor& visitor) const;
  template <bool InOrder, class Visitor>
  void WalkAlong(const skd::Segment<3>& segment, double margin, Visitor& visitor) const;
  /// skd::VisitTriangleHits, if all cells are triangles whose corners are at hand. False if not.
  template <bool InOrder, class Visitor>
  bool VisitTriangleHits(const skd::Segment<3>& segment, double tolerance, Visitor& visitor) const;
  /// skd::VisitPacketHits, under the same condition.
  template <bool InOrder, class Visitor>
  bool VisitPacketHits(
    const skd::Segment<3>* segments, int count, double tolerance, Visitor& visitor) const;

  /// GetSimplices() of a cell that is not curved; false for others.
  bool GetStraightSimplices(std::uint32_t cell, skd::SimplexSet& simplices) const;
  skd::Vector3 PCoordsAfter(const skd::RigidMotion& motion, vtkIdType id, const skd::Vector3& x,
    const skd::Vector3& pcoords) const;
  SkdCellPoint Measure(
    std::uint32_t cell, const skd::Vector3& x, double limit2, const SkdCellSource& source) const;
  std::optional<SkdLineHit> Hit(std::uint32_t cell, const skd::SegmentView& view, double tolerance,
    const SkdCellSource& source) const;
  template <class Test>
  double NormalDeviationOf(
    const SkdCandidateRange& above, const skd::Box3& box, const Test& isMet) const;
  void AddTransitions(std::uint32_t cell, const skd::Segment<3>& segment, double maxDistance,
    const SkdCellSource& source, std::vector<double>& parameters) const;
  template <class Visit>
  void ForEachNear(const skd::Box3& box, const skd::RigidMotion& motion, Visit visit) const;
  template <class ToFirst, class IsPair>
  std::vector<std::vector<CellPair>> FindPairs(
    const SkdCellTree& other, const ToFirst& toFirst, const IsPair& isPair, double excess) const;
  template <class Take>
  void ForEachFacet(
    const skd::Segment<3>& segment, const SkdCellSource& source, const Take& take) const;
  /// Of quads, strips and triangles.
  template <class Visit>
  void ForEachTriangle(std::uint32_t cell, Visit visit) const;

  SkdCellStore Store;
  SkdPieceRuns Runs; // of Store
  bool Bare = false;
  double TheRounding = 0.0;
  double TheEpsilon = 0.0;
  skd::Tree<3> Eager;
  SkdLeafFilters LeafFilters;             // of Eager
  skd::CompactTree View;                  // of both
  skd::TrianglePackets Packets;           // of LeafFilters
  std::unique_ptr<skd::LazyTree<3>> Lazy; // instead of Eager
  std::unique_ptr<SkdEqualCells> Equal;   // with the next; nullptr where there are few
  std::unique_ptr<SkdCellTree> Distinct;  // of the first of each group of equal cells
};
}

#endif
