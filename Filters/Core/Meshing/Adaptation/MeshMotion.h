// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_MeshMotion_h
#define skd_Adaptation_MeshMotion_h

#include "CellValidity.h"
#include "FeatureCurves.h"

#include <limits>
#include <numeric>

namespace skd
{

namespace detail
{

/// The entries of some rows, ascending and each once.
inline std::vector<std::uint32_t> UnionOf(
  const IndexRows& rows, const std::vector<std::uint32_t>& which)
{
  std::vector<std::uint32_t> entries;
  for (const std::uint32_t row : which)
  {
    entries.insert(entries.end(), rows[row].begin(), rows[row].end());
  }
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  return entries;
}

}

/// Moves points as far as no cell is spoilt.
class MeshMotion
{
public:
  struct Outcome
  {
    double Step = 0.0; ///< which part of a whole step was meant, see Equidistribution::Step
    double LargestDisplacement = 0.0;
    std::size_t PointsCutBack = 0;             ///< those that went elsewhere, for the sake of cells
    std::uint32_t SpoiltCell = MeshEdge::None; ///< the first of these cells
  };

  /// A cell may not get worse than this quality (CellValidity), or than it is if it is worse; of
  /// cells that are thin at first (at poles, say), than as small a part of what they are.
  /// Points of cells that are not valid at first become fixed; they are counted.
  MeshMotion(
    SurfaceMesh& mesh, const SurfaceShape& shape, FeatureCurves& curves, double leastQuality);

  std::size_t GetNumberOfInvalidCells() const { return this->InvalidCells; }
  std::uint32_t GetFirstInvalidCell() const { return this->FirstInvalid; }
  double FindSmallestQuality(const SurfaceMesh& mesh) const;

  /// Moves points to positions. Where a few cells would be spoilt the points around go amid their
  /// neighbours instead. False, and nothing has moved, if this does not help.
  bool MoveWhole(SurfaceMesh& mesh, const std::vector<Vector3>& positions, Outcome& outcome);

  /// Moves points towards positions. Where cells would be spoilt their points go along with their
  /// neighbours instead; where this does not help half as far, then not at all. If that would hold
  /// back many, MoveWhole is tried first.
  Outcome Move(SurfaceMesh& mesh, const std::vector<Vector3>& positions);

private:
  static constexpr Vector3 None{ { 0.0, 0.0, 0.0 } };

  /// Of cells that are half as good as a regular one at first or worse the same part.
  double LeastOf(std::uint32_t cell) const
  {
    return this->LeastQuality * std::min(1.0, 2.0 * std::max(this->First[cell], 0.0));
  }
  void MovePoint(SurfaceMesh& mesh, std::uint32_t point);
  Vector3 DisplacementOfNeighbours(const SurfaceMesh& mesh, std::uint32_t point) const;
  std::vector<std::uint32_t> FindSpoilt(
    const SurfaceMesh& mesh, const std::vector<std::uint32_t>& cells) const;
  static std::vector<std::uint32_t> CornersOf(
    const SurfaceMesh& mesh, const std::vector<std::uint32_t>& cells);
  static Vector3 AmidNeighbours(const SurfaceMesh& mesh, std::uint32_t point);
  void Begin(const SurfaceMesh& mesh);
  bool Go(SurfaceMesh& mesh, const std::vector<Vector3>& positions, double part);
  void Displace(SurfaceMesh& mesh, const std::vector<std::uint32_t>& points,
    const std::vector<Vector3>& displacements);
  bool RoundOff(SurfaceMesh& mesh);
  bool Repair(SurfaceMesh& mesh, std::size_t work);
  bool MoveInParts(SurfaceMesh& mesh, const std::vector<Vector3>& positions, std::size_t work);
  void Count(const SurfaceMesh& mesh, const std::vector<Vector3>& first, Outcome& outcome) const;
  std::vector<std::uint32_t> CellsAround(
    const SurfaceMesh& mesh, const std::vector<std::uint32_t>& points) const;

  const SurfaceShape& Shape;
  FeatureCurves& Curves;
  double LeastQuality;
  std::vector<CellValidity> Cells;
  std::vector<double> First;     // qualities, as the mesh was given
  std::vector<double> Qualities; // before the step
  std::vector<Vector3> Before;
  std::vector<bool> Repaired;
  std::vector<Vector3> Displacements; // how each point moves
  std::size_t InvalidCells = 0;
  std::uint32_t FirstInvalid = MeshEdge::None;
  std::vector<std::uint32_t> Spoilt; // cells, as they are now
};

inline MeshMotion::MeshMotion(
  SurfaceMesh& mesh, const SurfaceShape& shape, FeatureCurves& curves, double leastQuality)
  : Shape(shape)
  , Curves(curves)
  , LeastQuality(leastQuality)
{
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    this->Cells.emplace_back(mesh, shape, cell);
    this->First.push_back(this->Cells.back().QualityOf(mesh, cell));
    if (!this->Cells.back().IsValid(mesh, cell))
    {
      this->FirstInvalid = this->InvalidCells == 0 ? cell : this->FirstInvalid;
      ++this->InvalidCells;
      for (const std::uint32_t corner : mesh.Cells[cell])
      {
        mesh.Freedom[corner] = PointFreedom::Fixed;
      }
    }
  }
}

inline double MeshMotion::FindSmallestQuality(const SurfaceMesh& mesh) const
{
  double least = 1.0;
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    least = std::min(least, this->Cells[cell].QualityOf(mesh, cell));
  }
  return least;
}

inline void MeshMotion::MovePoint(SurfaceMesh& mesh, std::uint32_t point)
{
  if (this->Displacements[point] == None)
  {
    mesh.Points[point] = this->Before[point];
    return;
  }
  Vector3 x = this->Before[point] + this->Displacements[point];
  if (mesh.Freedom[point] == PointFreedom::AlongCurve)
  {
    x = this->Curves.Slide(point, x);
  }
  mesh.Points[point] = this->Shape.Put(x);
}

inline Vector3 MeshMotion::DisplacementOfNeighbours(
  const SurfaceMesh& mesh, std::uint32_t point) const
{
  Vector3 sum = None;
  double count = 0.0;
  for (const std::uint32_t cell : mesh.CellsOfPoint[point])
  {
    for (const std::uint32_t corner : mesh.Cells[cell])
    {
      sum = corner == point ? sum : sum + this->Displacements[corner];
      count += corner != point;
    }
  }
  return (1.0 / count) * sum;
}

inline std::vector<std::uint32_t> MeshMotion::FindSpoilt(
  const SurfaceMesh& mesh, const std::vector<std::uint32_t>& cells) const
{
  std::vector<std::uint32_t> spoilt;
  for (const std::uint32_t cell : cells)
  {
    const IndexRows::Row corners = mesh.Cells[cell];
    const bool isMoved = std::any_of(corners.begin(), corners.end(),
      [this](std::uint32_t corner) { return !(this->Displacements[corner] == None); });
    const double least = std::min(this->LeastOf(cell), this->Qualities[cell]);
    if (isMoved &&
      !(this->Cells[cell].IsValid(mesh, cell) && this->Cells[cell].QualityOf(mesh, cell) >= least))
    {
      spoilt.push_back(cell);
    }
  }
  return spoilt;
}

inline std::vector<std::uint32_t> MeshMotion::CellsAround(
  const SurfaceMesh& mesh, const std::vector<std::uint32_t>& points) const
{
  return detail::UnionOf(mesh.CellsOfPoint, points);
}

inline std::vector<std::uint32_t> MeshMotion::CornersOf(
  const SurfaceMesh& mesh, const std::vector<std::uint32_t>& cells)
{
  return detail::UnionOf(mesh.Cells, cells);
}

/// Half of the way to the mean of the other ends of its edges.
inline Vector3 MeshMotion::AmidNeighbours(const SurfaceMesh& mesh, std::uint32_t point)
{
  Vector3 sum = None;
  for (const std::uint32_t cell : mesh.CellsOfPoint[point])
  {
    const IndexRows::Row corners = mesh.Cells[cell];
    const std::size_t n = corners.size();
    const auto at =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    sum = sum + mesh.Points[corners[(at + 1) % n]] + mesh.Points[corners[(at + n - 1) % n]];
  }
  const auto count = 2.0 * static_cast<double>(mesh.CellsOfPoint[point].size());
  return 0.5 * (mesh.Points[point] + (1.0 / count) * sum);
}

inline void MeshMotion::Displace(SurfaceMesh& mesh, const std::vector<std::uint32_t>& points,
  const std::vector<Vector3>& displacements)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->Displacements[points[i]] = displacements[i];
    this->Repaired[points[i]] = true;
    this->MovePoint(mesh, points[i]);
  }
  this->Spoilt = this->FindSpoilt(mesh, this->CellsAround(mesh, points));
}

// Cells that are stretched evenly stay as they are, and those among them that are worse become like
// them. Points farther and farther around give way.
inline bool MeshMotion::RoundOff(SurfaceMesh& mesh)
{
  constexpr std::size_t few = 10; // a part of the cells
  constexpr int rounds = 200;
  constexpr int roundsOfRing = 20;
  std::size_t work = 4 * mesh.Points.size(); // points that may move, all rounds together
  for (int round = 0; round < rounds && !this->Spoilt.empty(); ++round)
  {
    std::vector<std::uint32_t> points = CornersOf(mesh, this->Spoilt);
    for (int ring = 0; ring < round / roundsOfRing; ++ring)
    {
      points = CornersOf(mesh, this->CellsAround(mesh, points));
    }
    if (few * this->Spoilt.size() > mesh.Cells.size() || points.size() > work)
    {
      return false;
    }
    work -= points.size();
    std::vector<Vector3> displacements;
    for (const std::uint32_t point : points)
    {
      const bool isFixed = mesh.Freedom[point] == PointFreedom::Fixed;
      displacements.push_back(isFixed ? None : AmidNeighbours(mesh, point) - this->Before[point]);
    }
    this->Displace(mesh, points, displacements);
  }
  return this->Spoilt.empty();
}

// Points that do not move at all stay so, and where nothing has moved cells are as they were: this
// comes to an end.
inline bool MeshMotion::Repair(SurfaceMesh& mesh, std::size_t work)
{
  constexpr int smoothings = 20;
  constexpr int halvings = 6;
  for (int round = 0; !this->Spoilt.empty(); ++round)
  {
    const std::vector<std::uint32_t> points = CornersOf(mesh, this->Spoilt);
    if (points.size() > work)
    {
      return false;
    }
    work -= points.size();
    std::vector<Vector3> displacements;
    for (const std::uint32_t point : points)
    {
      const double part = round < smoothings + halvings ? 0.5 : 0.0;
      const bool isFixed = mesh.Freedom[point] == PointFreedom::Fixed;
      displacements.push_back(isFixed ? None
          : round < smoothings        ? this->DisplacementOfNeighbours(mesh, point)
                                      : part * this->Displacements[point]);
    }
    this->Displace(mesh, points, displacements);
  }
  return true;
}

/// Goes a part of the way that is left; false if cells are spoilt then.
inline bool MeshMotion::Go(SurfaceMesh& mesh, const std::vector<Vector3>& positions, double part)
{
  this->Before = mesh.Points;
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (this->Shape.What == SurfaceShape::Kind::Other)
    {
      this->Cells[cell] = CellValidity(mesh, this->Shape, cell);
    }
    this->Qualities[cell] = this->Cells[cell].QualityOf(mesh, cell);
  }
  for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
  {
    const bool isFixed = mesh.Freedom[point] == PointFreedom::Fixed;
    this->Displacements[point] = isFixed ? None : part * (positions[point] - mesh.Points[point]);
    this->MovePoint(mesh, point);
  }
  this->Spoilt.resize(mesh.Cells.size());
  std::iota(this->Spoilt.begin(), this->Spoilt.end(), 0u);
  this->Spoilt = this->FindSpoilt(mesh, this->Spoilt);
  return this->Spoilt.empty();
}

inline void MeshMotion::Count(
  const SurfaceMesh& mesh, const std::vector<Vector3>& first, Outcome& outcome) const
{
  outcome.PointsCutBack = 0;
  for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
  {
    outcome.PointsCutBack += this->Repaired[point];
    outcome.LargestDisplacement =
      std::max(outcome.LargestDisplacement, Norm(mesh.Points[point] - first[point]));
  }
}

inline void MeshMotion::Begin(const SurfaceMesh& mesh)
{
  this->Displacements.resize(mesh.Points.size());
  this->Repaired.assign(mesh.Points.size(), false);
  this->Qualities.resize(mesh.Cells.size());
}

inline bool MeshMotion::MoveWhole(
  SurfaceMesh& mesh, const std::vector<Vector3>& positions, Outcome& outcome)
{
  const std::vector<Vector3> first = mesh.Points;
  this->Begin(mesh);
  if (!this->Go(mesh, positions, 1.0))
  {
    outcome.SpoiltCell = this->Spoilt.front();
    if (!this->RoundOff(mesh))
    {
      mesh.Points = first;
      return false;
    }
  }
  this->Count(mesh, first, outcome);
  return true;
}

// Points that go a small part of their way are soon repaired, and hold few others back. False, and
// nothing has moved, if more points than `work` would have to be repaired for a part.
inline bool MeshMotion::MoveInParts(
  SurfaceMesh& mesh, const std::vector<Vector3>& positions, std::size_t work)
{
  constexpr int parts = 8;
  const std::vector<Vector3> first = mesh.Points;
  for (int left = parts; left > 0; --left)
  {
    this->Go(mesh, positions, 1.0 / left);
    this->Repaired.assign(mesh.Points.size(), false); // by the last is what counts
    if (!this->Repair(mesh, work))
    {
      mesh.Points = first;
      return false;
    }
  }
  return true;
}

inline MeshMotion::Outcome MeshMotion::Move(
  SurfaceMesh& mesh, const std::vector<Vector3>& positions)
{
  const std::vector<Vector3> first = mesh.Points;
  Outcome outcome;
  this->Begin(mesh);
  if (!this->Go(mesh, positions, 1.0))
  {
    outcome.SpoiltCell = this->Spoilt.front();
    mesh.Points = first;
    if (!this->MoveInParts(mesh, positions, mesh.Points.size()) &&
      !this->MoveWhole(mesh, positions, outcome))
    {
      this->MoveInParts(mesh, positions, std::numeric_limits<std::size_t>::max());
    }
  }
  this->Count(mesh, first, outcome);
  return outcome;
}

}

#endif
