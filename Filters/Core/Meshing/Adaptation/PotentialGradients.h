// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_PotentialGradients_h
#define skd_Adaptation_PotentialGradients_h

#include "PointGradients.h"
#include "QuadraticFit.h"

namespace skd
{

/// The gradients at points, along the surface, of a potential that cells have at their middles and
/// whose gradient has no part across the border. Where points go depends on them, and how cells
/// are strained on how they differ from point to point, that is, on second derivatives: so they
/// are exact for quadratic potentials on any mesh in a plane. Taken from the cells around a point
/// and the next ones across edges, which are mirror images across the border; where these
/// cells are thin (at the poles of a grid of longitudes and latitudes, say) from more of them, so
/// that they extend about as far in all directions.
class PotentialGradients : public GradientWeights
{
public:
  /// For a mesh as it is now. O(N).
  void Build(const SurfaceMesh& mesh, const SurfaceShape& shape);

private:
  void FindNeighbours(const SurfaceMesh& mesh);
  void FindImages(const SurfaceMesh& mesh);
  Ids CellsNear(const SurfaceMesh& mesh, std::uint32_t point) const;
  bool IsThin(const Ids& cells, const Vector3& x, double& radius) const;
  void Widen(Ids& cells, const Vector3& x, double radius) const;
  std::vector<std::pair<std::uint32_t, Vector3>>::const_iterator ImagesOf(std::uint32_t cell) const;
  Vector3 FindMirror(const IndexRows::Row& ring, const Vector3& x) const;
  std::vector<Share> SharesAt(
    const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point) const;

  IndexRows EdgesOfCell;
  std::vector<std::array<std::uint32_t, 2>> CellsOfEdge;
  std::vector<std::pair<std::uint32_t, Vector3>> Images; // ascending, of cells at the border
};

inline void PotentialGradients::FindNeighbours(const SurfaceMesh& mesh)
{
  IndexRows cells;
  this->CellsOfEdge.clear();
  for (const MeshEdge& edge : mesh.Edges)
  {
    if (edge.Cells[1] != MeshEdge::None)
    {
      cells.Add(edge.Cells.begin(), edge.Cells.end());
      this->CellsOfEdge.push_back(edge.Cells);
    }
  }
  this->EdgesOfCell = cells.Inverse(mesh.Cells.size());
}

inline void PotentialGradients::FindImages(const SurfaceMesh& mesh)
{
  this->Images.clear();
  for (const MeshEdge& edge : mesh.Edges)
  {
    const Vector3& a = mesh.Points[edge.Points[0]];
    const Vector3 along = mesh.Points[edge.Points[1]] - a;
    if (edge.Cells[1] == MeshEdge::None && Norm2(along) > 0.0)
    {
      const Vector3 to = this->Middles[edge.Cells[0]] - a;
      this->Images.emplace_back(
        edge.Cells[0], a + (2.0 * Dot(to, along) / Norm2(along)) * along - to);
    }
  }
  const auto isBefore = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(this->Images.begin(), this->Images.end(), isBefore);
}

inline void PotentialGradients::Build(const SurfaceMesh& mesh, const SurfaceShape& shape)
{
  this->FindMiddles(mesh, shape);
  this->FindNeighbours(mesh);
  this->FindImages(mesh);
  this->FindShares(mesh, [&](std::uint32_t point) { return this->SharesAt(mesh, shape, point); });
}

/// Whether cells spread much less in one direction than in the other; and the farthest's distance.
inline bool PotentialGradients::IsThin(const Ids& cells, const Vector3& x, double& radius) const
{
  constexpr double thin = 0.1; // of the product of both spreads, relative to their mean's square
  double spread[3][3] = {};
  radius = 0.0;
  for (const std::uint32_t cell : cells)
  {
    const Vector3 to = this->Middles[cell] - x;
    radius = std::max(radius, Norm(to));
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        spread[i][k] += to[i] * to[k];
      }
    }
  }
  const double sum = spread[0][0] + spread[1][1] + spread[2][2];
  double minors = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int k = (i + 1) % 3;
    minors += spread[i][i] * spread[k][k] - spread[i][k] * spread[i][k];
  }
  return minors < thin * sum * sum;
}

inline void PotentialGradients::Widen(Ids& cells, const Vector3& x, double radius) const
{
  constexpr std::size_t most = 1024; // with few, slopes would jump from point to point
  Ids sorted(cells);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (const std::uint32_t edge : this->EdgesOfCell[cells[i]])
    {
      const std::array<std::uint32_t, 2>& both = this->CellsOfEdge[edge];
      const std::uint32_t next = both[both[0] == cells[i] ? 1 : 0];
      const auto at = std::lower_bound(sorted.begin(), sorted.end(), next);
      const bool isIn = at != sorted.end() && *at == next;
      if (!isIn && Norm(this->Middles[next] - x) < 0.8 * radius)
      {
        sorted.insert(at, next);
        cells.push_back(next);
      }
    }
  }
  const Ids all = cells;
  cells.resize(std::min(all.size(), most)); // in the order of steps from the point, evenly
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    cells[k] = all[k * all.size() / cells.size()];
  }
}

inline PotentialGradients::Ids PotentialGradients::CellsNear(
  const SurfaceMesh& mesh, std::uint32_t point) const
{
  const IndexRows::Row around = mesh.CellsOfPoint[point];
  Ids cells(around.begin(), around.end());
  for (const std::uint32_t cell : around)
  {
    for (const std::uint32_t edge : this->EdgesOfCell[cell])
    {
      cells.insert(cells.end(), this->CellsOfEdge[edge].begin(), this->CellsOfEdge[edge].end());
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  double radius = 0.0;
  if (this->IsThin(cells, mesh.Points[point], radius))
  {
    this->Widen(cells, mesh.Points[point], radius);
    std::sort(cells.begin(), cells.end());
  }
  return cells;
}

inline std::vector<std::pair<std::uint32_t, Vector3>>::const_iterator PotentialGradients::ImagesOf(
  std::uint32_t cell) const
{
  const auto isBefore = [](const auto& image, std::uint32_t of) { return image.first < of; };
  return std::lower_bound(this->Images.begin(), this->Images.end(), cell, isBefore);
}

/// The direction, of length 1, across the border that a point is on; 0 inside. Its cells have
/// images on whose mirror the point is.
inline Vector3 PotentialGradients::FindMirror(const IndexRows::Row& ring, const Vector3& x) const
{
  constexpr double on = 1e-6; // of the distance of a cell and its image
  for (const std::uint32_t cell : ring)
  {
    for (auto image = this->ImagesOf(cell); image != this->Images.end() && image->first == cell;
         ++image)
    {
      const Vector3 to = image->second - this->Middles[cell];
      const Vector3 middle = 0.5 * (image->second + this->Middles[cell]);
      if (std::abs(Dot(to, x - middle)) < on * Norm2(to))
      {
        return (1.0 / Norm(to)) * to;
      }
    }
  }
  return { { 0.0, 0.0, 0.0 } };
}

inline std::vector<PotentialGradients::Share> PotentialGradients::SharesAt(
  const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point) const
{
  const Ids cells = this->CellsNear(mesh, point);
  Plane plane;
  if (!this->FindPlane(mesh, shape, point, cells, plane))
  {
    return {};
  }
  QuadraticFit fit;
  Ids used; // cells and their images, as they are in the fit
  const auto add = [&](std::uint32_t cell, const Vector3& middle)
  {
    const Vector3 to = (1.0 / plane.Scale) * (middle - mesh.Points[point]);
    fit.Add(Dot(plane.U, to), Dot(plane.V, to));
    used.push_back(cell);
  };
  const Vector3& x = mesh.Points[point];
  const IndexRows::Row ring = mesh.CellsOfPoint[point];
  const Vector3 across = this->FindMirror(ring, x);
  for (const std::uint32_t cell : cells)
  {
    add(cell, this->Middles[cell]);
    if (Norm2(across) > 0.0)
    {
      add(cell, this->Middles[cell] - (2.0 * Dot(across, this->Middles[cell] - x)) * across);
    }
    const bool isNext = std::find(ring.begin(), ring.end(), cell) == ring.end();
    for (auto image = this->ImagesOf(cell);
         !isNext && image != this->Images.end() && image->first == cell && !(Norm2(across) > 0.0);
         ++image)
    {
      add(cell, image->second);
    }
  }
  return SharesOf(used, fit, plane);
}

}

#endif
