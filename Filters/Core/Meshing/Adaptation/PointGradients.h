// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_PointGradients_h
#define skd_Adaptation_PointGradients_h

#include "SurfaceShape.h"

namespace skd
{

namespace detail
{

/// Two directions of length 1 across a normal and each other.
inline void MakeTangents(const Vector3& normal, Vector3& u, Vector3& v)
{
  int least = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    least = std::abs(normal[axis]) < std::abs(normal[least]) ? axis : least;
  }
  Vector3 axis{ { 0.0, 0.0, 0.0 } };
  axis[least] = 1.0;
  u = Cross(axis, normal);
  u = (1.0 / Norm(u)) * u;
  v = Cross(normal, u);
}

/// Points in a plane, and the least-squares slope of values there as a sum of weights times values;
/// of all slopes that fit equally the least.
class SlopeFit
{
public:
  void Add(double x, double y)
  {
    const double distance = std::max(std::hypot(x, y), Nearest);
    this->Neighbours.push_back({ x, y, 1.0 / (distance * distance * distance) });
  }

  /// What each point's value adds to the slopes.
  std::vector<std::array<double, 2>> FindWeights() const;

private:
  static constexpr double Nearest = 1e-4; // whose weight is not larger than at this distance

  struct Neighbour
  {
    double X;
    double Y;
    double Weight;
  };
  std::vector<Neighbour> Neighbours;
};

// The slopes g that minimise the sum of w (g.d - change)^2 over the neighbours, d from their mean,
// solve M g = sum of w d change with M = sum of w d d^T. The eigenvalues of M are middle + spread,
// along `angle`, and middle - spread, across it; its pseudo-inverse leaves out what is 0 of them.

inline std::vector<std::array<double, 2>> SlopeFit::FindWeights() const
{
  double total = 0.0, meanX = 0.0, meanY = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Neighbour& neighbour : this->Neighbours)
  {
    total += neighbour.Weight;
    meanX += neighbour.Weight * neighbour.X;
    meanY += neighbour.Weight * neighbour.Y;
  }
  meanX /= total;
  meanY /= total;
  for (const Neighbour& neighbour : this->Neighbours)
  {
    xx += neighbour.Weight * (neighbour.X - meanX) * (neighbour.X - meanX);
    xy += neighbour.Weight * (neighbour.X - meanX) * (neighbour.Y - meanY);
    yy += neighbour.Weight * (neighbour.Y - meanY) * (neighbour.Y - meanY);
  }
  const double middle = 0.5 * (xx + yy);
  const double spread = std::hypot(0.5 * (xx - yy), xy);
  const double angle = 0.5 * std::atan2(xy, 0.5 * (xx - yy));
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  constexpr double noExtent = 1e-12; // of the mean square of distances, in the mesh's own scale
  constexpr double noWidth = 1e-3;   // of the smaller eigenvalue, relative to the larger
  const bool isPoint = !(middle + spread > noExtent * total);
  const bool isLine = !(middle - spread > noWidth * (middle + spread));
  const double long2 = isPoint ? 0.0 : 1.0 / (middle + spread);
  const double short2 = isPoint || isLine ? 0.0 : 1.0 / (middle - spread);
  std::vector<std::array<double, 2>> weights;
  for (const Neighbour& neighbour : this->Neighbours)
  {
    const double x = neighbour.X - meanX;
    const double y = neighbour.Y - meanY;
    const double along = neighbour.Weight * (cosine * x + sine * y) * long2;
    const double across = neighbour.Weight * (cosine * y - sine * x) * short2;
    weights.push_back({ along * cosine - across * sine, along * sine + across * cosine });
  }
  return weights;
}

}

/// Gradients at points, along the surface, of what cells have at their middles: for each point a
/// sum of values of cells times weights, which a class derived from this one finds.
class GradientWeights
{
public:
  Vector3 At(const std::vector<double>& values, std::uint32_t point) const
  {
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (const Share& share : this->Shares[point])
    {
      sum = sum + values[share.Cell] * share.Weight;
    }
    return sum;
  }

  const Vector3& GetMiddle(std::uint32_t cell) const { return this->Middles[cell]; }
  const std::vector<Vector3>& GetMiddles() const { return this->Middles; }

protected:
  using Ids = std::vector<std::uint32_t>;

  struct Share
  {
    std::uint32_t Cell;
    Vector3 Weight;
  };

  /// The tangent plane of a point, in which distances are relative to the farthest cell's.
  struct Plane
  {
    Vector3 U;
    Vector3 V;
    double Scale = 0.0;
  };

  void FindMiddles(const SurfaceMesh& mesh, const SurfaceShape& shape)
  {
    this->Middles.resize(mesh.Cells.size());
    for (std::uint32_t cell = 0; cell < this->Middles.size(); ++cell)
    {
      this->Middles[cell] = shape.Put(CornerMean(mesh, cell));
    }
  }

  /// findShares(point) returns those of each point.
  template <class Function>
  void FindShares(const SurfaceMesh& mesh, const Function& findShares)
  {
    this->Shares = Rows<Share>();
    for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
    {
      const std::vector<Share> shares = findShares(point);
      this->Shares.Add(shares.begin(), shares.end());
    }
  }

  /// False: the cells near a point do not define a gradient.
  bool FindPlane(const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point,
    const Ids& cells, Plane& plane) const
  {
    const Vector3 normal = NormalAt(mesh, shape, point);
    for (const std::uint32_t cell : cells)
    {
      plane.Scale = std::max(plane.Scale, Norm(this->Middles[cell] - mesh.Points[point]));
    }
    if (cells.size() < 2 || !(Norm2(normal) > 0.0) || !(plane.Scale > 0.0))
    {
      return false;
    }
    detail::MakeTangents(normal, plane.U, plane.V);
    return true;
  }

  /// What a fit in the plane gives each of the cells that it has, as vectors in space.
  template <class Fit>
  static std::vector<Share> SharesOf(const Ids& cells, const Fit& fit, const Plane& plane)
  {
    const std::vector<std::array<double, 2>> weights = fit.FindWeights();
    std::vector<Share> shares;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      shares.push_back({ cells[i],
        (weights[i][0] / plane.Scale) * plane.U + (weights[i][1] / plane.Scale) * plane.V });
    }
    return shares;
  }

  std::vector<Vector3> Middles;

private:
  Rows<Share> Shares; // of each point
};

/// The gradients at points, along the surface, of what cells have at their middles: by least
/// squares over the cells around each point, exact for linear values in a plane, and for quadratic
/// ones where the mesh is regular. For that weights fall with the third power of the distance, and
/// a point of only three cells (hexagons, say) takes those of its neighbours, too: a triangle and
/// the one rotated about that is twice as large. Where all these say nothing of a direction (at a
/// corner, say) the gradient has no part in it.
class PointGradients : public GradientWeights
{
public:
  /// For a mesh as it is now. O(N).
  void Build(const SurfaceMesh& mesh, const SurfaceShape& shape);

private:
  static Ids CellsNear(const SurfaceMesh& mesh, std::uint32_t point);
  std::vector<Share> SharesAt(
    const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point) const;
};

inline void PointGradients::Build(const SurfaceMesh& mesh, const SurfaceShape& shape)
{
  this->FindMiddles(mesh, shape);
  this->FindShares(mesh, [&](std::uint32_t point) { return this->SharesAt(mesh, shape, point); });
}

inline PointGradients::Ids PointGradients::CellsNear(const SurfaceMesh& mesh, std::uint32_t point)
{
  const IndexRows::Row around = mesh.CellsOfPoint[point];
  const bool isFree = mesh.Freedom[point] == PointFreedom::Free;
  const bool takesMore = around.size() == 1 || (around.size() == 3 && isFree);
  Ids cells(around.begin(), around.end());
  for (std::size_t k = 0; k < around.size() && takesMore; ++k)
  {
    const IndexRows::Row corners = mesh.Cells[around[k]];
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const bool isNext = corners[(i + 1) % corners.size()] == point;
      if (isNext || corners[(i + corners.size() - 1) % corners.size()] == point)
      {
        const IndexRows::Row more = mesh.CellsOfPoint[corners[i]];
        cells.insert(cells.end(), more.begin(), more.end());
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

inline std::vector<PointGradients::Share> PointGradients::SharesAt(
  const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point) const
{
  const Ids cells = CellsNear(mesh, point);
  Plane plane;
  if (!this->FindPlane(mesh, shape, point, cells, plane))
  {
    return {};
  }
  detail::SlopeFit fit;
  for (const std::uint32_t cell : cells)
  {
    const Vector3 to = (1.0 / plane.Scale) * (this->Middles[cell] - mesh.Points[point]);
    fit.Add(Dot(plane.U, to), Dot(plane.V, to));
  }
  return SharesOf(cells, fit, plane);
}

}

#endif
