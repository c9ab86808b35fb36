// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_Equidistribution_h
#define skd_Adaptation_Equidistribution_h

#include "../../Geometry/DisjointSets.h"
#include "Aggregation.h"
#include "ConjugatePotential.h"
#include "ConjugateResiduals.h"
#include "FeatureCurves.h"
#include "NeighbourMeans.h"
#include "PotentialGradients.h"

#include <functional>
#include <numeric>

namespace skd
{

/// What cells of a mesh should have of the integral of a monitor, what they have, and where points
/// go for them to have it.
///
/// A cell should have its share: of the integral over the connected part that it is in, what the
/// cell has of that part's weight. Points go from where they were at first along the gradient of a
/// potential, as in the transport of mass at the least cost: in the plane to X + grad phi, on a
/// sphere along great circles (R. J. McCann, Geom. Funct. Anal. 11 (2001) 589-608), so that cells
/// are neither rotated nor sheared more than need be. Each step solves the equation of Monge and
/// Ampere as linearised about the mesh where it is: what goes through each edge is what is missing,
/// share - monitor x area of the cells themselves (compare H. Weller, P. Browne, C. Budd, M.
/// Cullen, J. Comput. Phys. 308 (2016) 102-123). Where it comes to rest shares are equal for the
/// cells as they are, not for a linear model of them. On other surfaces each step begins anew where
/// points are.
///
/// On irregular meshes a potential has an error that differs from cell to cell: of second order,
/// but its second derivatives, the strain of cells, are then wrong at any size of cells. So
/// gradients are exact for quadratic potentials, and what points of irregular meshes do is smoothed
/// in such a way that linear motion stays as it is: what is left of the error falls with the cells'
/// size.
class Equidistribution
{
public:
  /// The weights of cells are greater than 0: their areas at first, say.
  Equidistribution(const SurfaceMesh& mesh, const SurfaceShape& shape, const FeatureCurves& curves,
    std::vector<double> weights);

  /// Looks at the mesh where it is now, with a monitor greater than 0 in each cell.
  void Update(const SurfaceMesh& mesh, const std::vector<double>& monitor);

  /// How far the cells are from equal shares: the root mean square, by weight, of
  /// monitor x area / share - 1. It is the coefficient of variation of the monitor's integral per
  /// weight; 0 is perfect.
  double GetMeasure() const { return this->Measure; }

  /// The cell that adds most to it, and its monitor x area by its share.
  std::uint32_t GetWorstCell() const { return this->WorstCell; }
  double GetWorstRatio() const { return this->WorstRatio; }

  const std::vector<double>& GetAreas() const { return this->Areas; }

  /// Which part of a whole step was made, and for each point where to. At most `part`, and less
  /// where an edge would change by more than a third or so. Fixed points do not move; those on
  /// curves may be allowed to leave them. What the potential's change has at the scale of single
  /// cells can be smoothed some times first: single points, where panels of a cubed sphere meet or
  /// at poles, would make steps the shorter the finer the mesh is. O(N).
  double Step(const SurfaceMesh& mesh, const FeatureCurves& curves,
    const std::vector<double>& monitor, double part, std::vector<Vector3>& positions,
    int smoothings = 0);

  const std::vector<double>& GetWeights() const { return this->Weights; }
  void SetWeights(std::vector<double> weights);

  /// Has points begin anew where they were at first, with other weights.
  void Restart(std::vector<double> weights);

  /// Where points go that come from the mesh at first as those of `image`, which has been moved by
  /// steps, have come from it: the inverse map. From there the next step goes on.
  std::vector<Vector3> Invert(const SurfaceMesh& image);

  /// Where points go with a potential that is this part of what it is.
  std::vector<Vector3> Shorten(double part);

private:
  /// An edge between two cells, and what goes through it per length that its ends move.
  struct CrossedEdge
  {
    std::array<std::uint32_t, 2> Points;
    std::array<std::uint32_t, 2> Cells;
    Vector3 Across; // from the first to the second
  };

  void FindParts(const SurfaceMesh& mesh);
  void BeginAt(const SurfaceMesh& mesh, const FeatureCurves& curves);
  std::vector<double> FindShares(const std::vector<double>& monitor) const;
  void FindMissing(const std::vector<double>& monitor);
  void FindCrossedEdges(const SurfaceMesh& mesh);
  EdgeLaplacian MakeMatrix(const SurfaceMesh& mesh) const;
  Vector3 Move(const Vector3& from, const Vector3& along) const;
  Vector3 DerivativeOfMove(const Vector3& from, const Vector3& along, const Vector3& change) const;
  std::vector<Vector3> FindPositions();
  void Smooth(std::vector<double>& potential, int times) const;
  std::vector<Vector3> FindGradients(const std::vector<double>& potential) const;
  Vector3 Allowed(std::uint32_t point, const Vector3& gradient) const;
  std::vector<Vector3> FindMotion(const std::vector<double>& change) const;
  std::vector<double> FindGains(const std::vector<double>& change) const;
  std::vector<double> FindChange(const SurfaceMesh& mesh) const;
  double LimitOf(const SurfaceMesh& mesh, const std::vector<Vector3>& motion, double part) const;

  const SurfaceShape& Shape;
  std::vector<double> Weights;
  std::vector<std::uint32_t> PartOfCell;
  std::vector<double> PartWeights;
  SurfaceMesh First; // where the potential is laid out
  PotentialGradients Gradients;
  NeighbourMeans Means;
  std::vector<Vector3> Normals;  // where the potential is laid out
  std::vector<Vector3> Tangents; // of points that slide along curves; else 0
  std::vector<double> Potential;
  std::vector<Vector3> Displacements; // its gradient at points
  std::vector<CrossedEdge> CrossedEdges;
  std::vector<double> Areas;
  std::vector<double> Missing;   // share - monitor x area
  std::vector<double> Densities; // share / area
  double Measure = 0.0;
  std::uint32_t WorstCell = 0;
  double WorstRatio = 1.0;
};

inline Equidistribution::Equidistribution(const SurfaceMesh& mesh, const SurfaceShape& shape,
  const FeatureCurves& curves, std::vector<double> weights)
  : Shape(shape)
{
  this->FindParts(mesh);
  this->BeginAt(mesh, curves);
  this->Restart(std::move(weights));
}

inline void Equidistribution::BeginAt(const SurfaceMesh& mesh, const FeatureCurves& curves)
{
  const Vector3 none{ { 0.0, 0.0, 0.0 } };
  this->First = mesh;
  this->Gradients.Build(mesh, this->Shape);
  this->Means.Build(mesh, this->Shape);
  this->Normals.resize(mesh.Points.size());
  this->Potential.assign(mesh.Cells.size(), 0.0);
  this->Displacements.assign(mesh.Points.size(), none);
  this->Tangents.assign(mesh.Points.size(), none);
  for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
  {
    this->Normals[point] = NormalAt(mesh, this->Shape, point);
    if (mesh.Freedom[point] == PointFreedom::AlongCurve)
    {
      this->Tangents[point] = curves.TangentOf(point);
    }
  }
}

inline void Equidistribution::FindParts(const SurfaceMesh& mesh)
{
  DisjointSets<> parts(mesh.Cells.size());
  for (const MeshEdge& edge : mesh.Edges)
  {
    if (edge.Cells[1] != MeshEdge::None)
    {
      parts.Unite(edge.Cells[0], edge.Cells[1]);
    }
  }
  this->PartOfCell = parts.Representatives();
}

inline std::vector<double> Equidistribution::FindShares(const std::vector<double>& monitor) const
{
  std::vector<double> integrals(this->Areas.size(), 0.0);
  for (std::size_t cell = 0; cell < this->Areas.size(); ++cell)
  {
    integrals[this->PartOfCell[cell]] += monitor[cell] * this->Areas[cell];
  }
  std::vector<double> shares(this->Areas.size());
  for (std::size_t cell = 0; cell < shares.size(); ++cell)
  {
    const std::uint32_t part = this->PartOfCell[cell];
    shares[cell] = integrals[part] * this->Weights[cell] / this->PartWeights[part];
  }
  return shares;
}

inline void Equidistribution::Update(const SurfaceMesh& mesh, const std::vector<double>& monitor)
{
  this->Areas.resize(mesh.Cells.size());
  for (std::uint32_t cell = 0; cell < this->Areas.size(); ++cell)
  {
    this->Areas[cell] = CellArea(mesh, this->Shape, cell);
  }
  const std::vector<double> shares = this->FindShares(monitor);
  double sum = 0.0;
  double total = 0.0;
  double most = -1.0;
  for (std::uint32_t cell = 0; cell < shares.size(); ++cell)
  {
    const double has = monitor[cell] * this->Areas[cell];
    const double relative = shares[cell] > 0.0 ? has / shares[cell] - 1.0 : 0.0;
    const double part = this->Weights[cell] * relative * relative;
    if (part > most)
    {
      most = part;
      this->WorstCell = cell;
      this->WorstRatio = 1.0 + relative;
    }
    sum += part;
    total += this->Weights[cell];
  }
  this->Measure = total > 0.0 ? std::sqrt(sum / total) : 0.0;
}

inline void Equidistribution::FindMissing(const std::vector<double>& monitor)
{
  const std::vector<double> shares = this->FindShares(monitor);
  this->Densities = monitor;
  this->Missing.resize(shares.size());
  for (std::size_t cell = 0; cell < shares.size(); ++cell)
  {
    this->Missing[cell] = shares[cell] - monitor[cell] * this->Areas[cell];
  }
}

inline EdgeLaplacian Equidistribution::MakeMatrix(const SurfaceMesh& mesh) const
{
  EdgeLaplacian matrix;
  matrix.NumberOfCells = mesh.Cells.size();
  matrix.Flows.reserve(this->CrossedEdges.size());
  for (const CrossedEdge& gate : this->CrossedEdges)
  {
    const double apart =
      Norm(this->Gradients.GetMiddle(gate.Cells[1]) - this->Gradients.GetMiddle(gate.Cells[0]));
    const double width = Norm(gate.Across);
    if (width > 0.0 && apart > 0.0)
    {
      matrix.Flows.push_back({ { gate.Cells[0], gate.Cells[1] }, width / apart });
    }
  }
  return matrix;
}

inline void Equidistribution::FindCrossedEdges(const SurfaceMesh& mesh)
{
  this->CrossedEdges.clear();
  this->CrossedEdges.reserve(mesh.Edges.size());
  for (const MeshEdge& edge : mesh.Edges)
  {
    if (edge.Cells[1] != MeshEdge::None)
    {
      const Vector3& a = mesh.Points[edge.Points[0]];
      const Vector3 normal = NormalAt(mesh, this->Shape, edge.Points[0]);
      const Vector3 across = Cross(mesh.Points[edge.Points[1]] - a, normal);
      const Vector3 to = CornerMean(mesh, edge.Cells[1]) - CornerMean(mesh, edge.Cells[0]);
      const double density =
        0.5 * (this->Densities[edge.Cells[0]] + this->Densities[edge.Cells[1]]);
      this->CrossedEdges.push_back(
        { edge.Points, edge.Cells, (Dot(across, to) < 0.0 ? -density : density) * across });
    }
  }
}

/// Where a point goes that has a gradient, and where it moves if the gradient changes.
inline Vector3 Equidistribution::Move(const Vector3& from, const Vector3& along) const
{
  const double length = Norm(along);
  if (this->Shape.What != SurfaceShape::Kind::Sphere || !(length > 0.0))
  {
    return from + along;
  }
  const double angle = length / this->Shape.Radius;
  const Vector3 r = from - this->Shape.Centre;
  return this->Shape.Centre + std::cos(angle) * r +
    (this->Shape.Radius * std::sin(angle) / length) * along;
}

inline Vector3 Equidistribution::DerivativeOfMove(
  const Vector3& from, const Vector3& along, const Vector3& change) const
{
  const double length = Norm(along);
  if (this->Shape.What != SurfaceShape::Kind::Sphere || !(length > 0.0))
  {
    return change;
  }
  const double angle = length / this->Shape.Radius;
  const Vector3 ahead = (1.0 / length) * along;
  const double part = Dot(ahead, change);
  const Vector3 up = (1.0 / this->Shape.Radius) * (from - this->Shape.Centre);
  return part * (std::cos(angle) * ahead - std::sin(angle) * up) +
    (std::sin(angle) / angle) * (change - part * ahead);
}

/// What of a gradient a point may follow.
inline Vector3 Equidistribution::Allowed(std::uint32_t point, const Vector3& gradient) const
{
  if (this->First.Freedom[point] == PointFreedom::Fixed)
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  const Vector3& tangent = this->Tangents[point];
  const Vector3& normal = this->Normals[point];
  return Norm2(tangent) > 0.0 ? Dot(gradient, tangent) * tangent
                              : gradient - Dot(gradient, normal) * normal;
}

inline std::vector<Vector3> Equidistribution::FindGradients(
  const std::vector<double>& potential) const
{
  std::vector<Vector3> gradients(this->First.Points.size());
  for (std::uint32_t point = 0; point < gradients.size(); ++point)
  {
    gradients[point] = this->Allowed(point, this->Gradients.At(potential, point));
  }
  const auto allow = [this](std::uint32_t point, const Vector3& x)
  { return this->Allowed(point, x); };
  this->Means.Smooth(gradients, this->Means.GetTimes(), allow);
  return gradients;
}

inline std::vector<Vector3> Equidistribution::FindMotion(const std::vector<double>& change) const
{
  std::vector<Vector3> motion = this->FindGradients(change);
  for (std::uint32_t point = 0; point < motion.size(); ++point)
  {
    motion[point] =
      this->DerivativeOfMove(this->First.Points[point], this->Displacements[point], motion[point]);
  }
  return motion;
}

inline std::vector<double> Equidistribution::FindGains(const std::vector<double>& change) const
{
  const std::vector<Vector3> motion = this->FindMotion(change);
  std::vector<double> gains(change.size(), 0.0);
  for (const CrossedEdge& gate : this->CrossedEdges)
  {
    const double through = 0.5 * Dot(gate.Across, motion[gate.Points[0]] + motion[gate.Points[1]]);
    gains[gate.Cells[0]] += through;
    gains[gate.Cells[1]] -= through;
  }
  return gains;
}

// The flows between neighbours, as a preconditioner, take the potential to change along the line
// between the middles of cells only, which is not so where cells are skew. What is missing counts
// as in the measure: relative to the cell's share.
inline std::vector<double> Equidistribution::FindChange(const SurfaceMesh& mesh) const
{
  const EdgeLaplacian matrix = this->MakeMatrix(mesh);
  const Aggregation levels(matrix);
  std::vector<double> roots(this->Missing.size());
  std::vector<double> missing(this->Missing);
  for (std::size_t cell = 0; cell < roots.size(); ++cell)
  {
    roots[cell] = std::sqrt(std::max(this->Densities[cell] * this->Areas[cell], 1e-300));
    missing[cell] /= roots[cell];
  }
  const auto estimate = [&](std::vector<double> residual)
  {
    std::transform(
      residual.begin(), residual.end(), roots.begin(), residual.begin(), std::multiplies<>());
    std::vector<double> direction;
    SolveForGains(matrix, levels, residual, 0.3, 20, direction);
    return direction;
  };
  const auto apply = [&](const std::vector<double>& change)
  {
    std::vector<double> gains = this->FindGains(change);
    std::transform(gains.begin(), gains.end(), roots.begin(), gains.begin(), std::divides<>());
    return gains;
  };
  return SolveByResiduals(missing, apply, estimate, 0.02, 10);
}

// Neighbours that move alike may go far.
inline double Equidistribution::LimitOf(
  const SurfaceMesh& mesh, const std::vector<Vector3>& motion, double part) const
{
  std::vector<double> sizes(mesh.Cells.size(), 0.0);
  for (const MeshEdge& edge : mesh.Edges)
  {
    const double length = Norm(mesh.Points[edge.Points[1]] - mesh.Points[edge.Points[0]]);
    sizes[edge.Cells[0]] += 0.25 * length;
    if (edge.Cells[1] != MeshEdge::None)
    {
      sizes[edge.Cells[1]] += 0.25 * length;
    }
  }
  for (const MeshEdge& edge : mesh.Edges)
  {
    const std::uint32_t other = edge.Cells[edge.Cells[1] == MeshEdge::None ? 0 : 1];
    const double length = Norm(mesh.Points[edge.Points[1]] - mesh.Points[edge.Points[0]]);
    const double change = Norm(motion[edge.Points[1]] - motion[edge.Points[0]]);
    const double most = 0.35 * std::max(length, std::min(sizes[edge.Cells[0]], sizes[other]));
    part = part * change > most ? most / change : part;
  }
  return part;
}

inline double Equidistribution::Step(const SurfaceMesh& mesh, const FeatureCurves& curves,
  const std::vector<double>& monitor, double part, std::vector<Vector3>& positions, int smoothings)
{
  if (this->Shape.What == SurfaceShape::Kind::Other)
  {
    this->BeginAt(mesh, curves);
  }
  this->FindMissing(monitor);
  this->FindCrossedEdges(mesh);
  std::vector<double> change = this->FindChange(mesh);
  this->Smooth(change, smoothings);
  part = this->LimitOf(mesh, this->FindMotion(change), part);
  detail::AddTo(this->Potential, part, change);
  positions = this->FindPositions();
  return part;
}

/// Where the potential takes points.
inline std::vector<Vector3> Equidistribution::FindPositions()
{
  this->Displacements = this->FindGradients(this->Potential);
  std::vector<Vector3> positions(this->Displacements.size());
  for (std::uint32_t point = 0; point < positions.size(); ++point)
  {
    positions[point] = this->Move(this->First.Points[point], this->Displacements[point]);
  }
  return positions;
}

inline void Equidistribution::SetWeights(std::vector<double> weights)
{
  this->Weights = std::move(weights);
  this->PartWeights.assign(this->PartOfCell.size(), 0.0);
  for (std::size_t cell = 0; cell < this->PartOfCell.size(); ++cell)
  {
    this->PartWeights[this->PartOfCell[cell]] += this->Weights[cell];
  }
}

inline void Equidistribution::Restart(std::vector<double> weights)
{
  this->SetWeights(std::move(weights));
  std::fill(this->Potential.begin(), this->Potential.end(), 0.0);
  this->FindPositions();
}

inline std::vector<Vector3> Equidistribution::Shorten(double part)
{
  detail::Scale(this->Potential, part);
  return this->FindPositions();
}

/// Takes from a potential what it has at the scale of single cells.
inline void Equidistribution::Smooth(std::vector<double>& potential, int times) const
{
  std::vector<Vector3> gradients(this->First.Cells.size());
  for (; times > 0; --times)
  {
    const std::vector<Vector3> atPoints = this->FindGradients(potential);
    for (std::uint32_t cell = 0; cell < gradients.size(); ++cell)
    {
      const IndexRows::Row corners = this->First.Cells[cell];
      Vector3 sum{ { 0.0, 0.0, 0.0 } };
      for (const std::uint32_t corner : corners)
      {
        sum = sum + atPoints[corner];
      }
      gradients[cell] = (1.0 / static_cast<double>(corners.size())) * sum;
    }
    SmoothPotential(this->First.Edges, this->Gradients.GetMiddles(), gradients, 4, potential);
  }
}

inline std::vector<Vector3> Equidistribution::Invert(const SurfaceMesh& image)
{
  const std::vector<Vector3>& middles = this->Gradients.GetMiddles();
  const ConjugatePotential back(image, this->Shape, middles, this->Potential);
  this->Potential = back.FindAll(middles);
  this->Smooth(this->Potential, 3);
  return this->FindPositions();
}

}

#endif
