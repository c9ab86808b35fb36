// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_ConjugatePotential_h
#define skd_Adaptation_ConjugatePotential_h

#include "PointGradients.h"

#include <algorithm>

namespace skd
{

/// What a potential has at the scale of single cells its gradients do not tell: half of each value
/// is made what they say, given the values of neighbours. Quadratic potentials stay as they are.
inline void SmoothPotential(const std::vector<MeshEdge>& edges, const std::vector<Vector3>& middles,
  const std::vector<Vector3>& gradients, int times, std::vector<double>& values)
{
  std::vector<double> sums, counts;
  for (; times > 0; --times)
  {
    sums.assign(values.size(), 0.0);
    counts.assign(values.size(), 0.0);
    for (const MeshEdge& edge : edges)
    {
      const std::uint32_t a = edge.Cells[0];
      const std::uint32_t b = edge.Cells[1];
      if (b != MeshEdge::None)
      {
        const double rise = 0.5 * Dot(gradients[a] + gradients[b], middles[b] - middles[a]);
        sums[a] += values[b] - rise - values[a];
        sums[b] += values[a] + rise - values[b];
        counts[a] += 1.0;
        counts[b] += 1.0;
      }
    }
    for (std::size_t cell = 0; cell < values.size(); ++cell)
    {
      values[cell] += counts[cell] > 0.0 ? 0.5 * sums[cell] / counts[cell] : 0.0;
    }
  }
}

/// The potential whose gradient takes points back. Where x goes to X = x + grad psi(x), the way
/// back is along the gradient at X of phi(X) = -psi(x) - |X - x|^2 / 2, the conjugate of Legendre;
/// on a sphere alike with great circles and their lengths (R. J. McCann, Geom. Funct. Anal. 11
/// (2001) 589-608). It is known where the middles of cells have gone. Elsewhere it is put together
/// from the cells around, exactly where it is quadratic, and smoothly.
class ConjugatePotential
{
public:
  /// A mesh whose points have moved, where the middles of its cells were before, and the potential
  /// there.
  ConjugatePotential(const SurfaceMesh& image, const SurfaceShape& shape,
    const std::vector<Vector3>& from, const std::vector<double>& potential);

  /// The potential of the inverse map at the positions `at`, one a cell; those of neighbours are
  /// near each other. O(N) where the mesh is not folded.
  std::vector<double> FindAll(const std::vector<Vector3>& at) const;

private:
  /// A cell near a position, in coordinates in which all of them are about as far in any direction.
  struct Near
  {
    std::uint32_t Cell;
    double X;
    double Y;
    double Weight;
  };

  std::uint32_t NextTowards(std::uint32_t cell, const Vector3& x) const;
  std::uint32_t Walk(std::uint32_t cell, const Vector3& x) const;
  void FindAround(std::uint32_t cell, const Vector3& x, std::vector<Near>& around) const;
  static void Weigh(std::vector<Near>& around);
  Vector3 GradientAt(const std::vector<Near>& around) const;
  double At(const Vector3& x, const std::vector<Near>& around) const;

  const SurfaceMesh& Image;
  const SurfaceShape& Shape;
  std::vector<const MeshEdge*> Inner; // those of two cells
  IndexRows InnerOfCell;
  std::vector<Vector3> Middles;
  std::vector<Vector3> Gradients; // there
  std::vector<double> Values;
};

inline ConjugatePotential::ConjugatePotential(const SurfaceMesh& image, const SurfaceShape& shape,
  const std::vector<Vector3>& from, const std::vector<double>& potential)
  : Image(image)
  , Shape(shape)
{
  IndexRows cells;
  for (const MeshEdge& edge : image.Edges)
  {
    if (edge.Cells[1] != MeshEdge::None)
    {
      this->Inner.push_back(&edge);
      cells.Add(edge.Cells.begin(), edge.Cells.end());
    }
  }
  this->InnerOfCell = cells.Inverse(image.Cells.size());
  for (std::uint32_t cell = 0; cell < image.Cells.size(); ++cell)
  {
    this->Middles.push_back(shape.Put(CornerMean(image, cell)));
    this->Gradients.push_back(shape.Along(this->Middles[cell], from[cell]));
    this->Values.push_back(-potential[cell] - 0.5 * Norm2(this->Gradients[cell]));
  }
  SmoothPotential(image.Edges, this->Middles, this->Gradients, 6, this->Values);
}

/// The neighbour across the edge that x is farthest beyond, or the cell itself.
inline std::uint32_t ConjugatePotential::NextTowards(std::uint32_t cell, const Vector3& x) const
{
  std::uint32_t best = cell;
  double most = 0.0;
  for (const std::uint32_t inner : this->InnerOfCell[cell])
  {
    const MeshEdge& edge = *this->Inner[inner];
    const Vector3& a = this->Image.Points[edge.Points[0]];
    const Vector3 across = Cross(this->Image.Points[edge.Points[1]] - a, this->Shape.NormalOf(a));
    const double within = Dot(across, this->Middles[cell] - a);
    const double beyond = (within < 0.0 ? 1.0 : -1.0) * Dot(across, x - a);
    if (beyond > most * Norm(across))
    {
      most = beyond / Norm(across);
      best = edge.Cells[edge.Cells[0] == cell ? 1 : 0];
    }
  }
  return best;
}

/// To the cell that has x; a mesh that is folded may have none, or turn walks in a circle.
inline std::uint32_t ConjugatePotential::Walk(std::uint32_t cell, const Vector3& x) const
{
  const auto most = static_cast<int>(10.0 * std::sqrt(double(this->Middles.size()))) + 10;
  for (int step = 0; step < most; ++step)
  {
    const std::uint32_t next = this->NextTowards(cell, x);
    if (next == cell)
    {
      break;
    }
    cell = next;
  }
  return cell;
}

inline void ConjugatePotential::FindAround(
  std::uint32_t cell, const Vector3& x, std::vector<Near>& around) const
{
  Vector3 u, v;
  detail::MakeTangents(this->Shape.NormalOf(x), u, v);
  around.clear();
  for (const std::uint32_t corner : this->Image.Cells[cell])
  {
    for (const std::uint32_t other : this->Image.CellsOfPoint[corner])
    {
      const Vector3 to = this->Middles[other] - x;
      around.push_back({ other, Dot(u, to), Dot(v, to), 1.0 });
    }
  }
  std::sort(
    around.begin(), around.end(), [](const Near& a, const Near& b) { return a.Cell < b.Cell; });
  const auto isSame = [](const Near& a, const Near& b) { return a.Cell == b.Cell; };
  around.erase(std::unique(around.begin(), around.end(), isSame), around.end());
}

/// Weights fall smoothly to almost 0 at the farthest.
inline void ConjugatePotential::Weigh(std::vector<Near>& around)
{
  constexpr double thin = 1e-12; // of the product of both spreads, relative to their sum's square
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Near& one : around)
  {
    xx += one.X * one.X;
    xy += one.X * one.Y;
    yy += one.Y * one.Y;
  }
  const double least = thin * (xx + yy);
  const double scale = xx + yy > 0.0 ? 1.0 / std::sqrt(xx + least) : 0.0;
  const double shear = xx + yy > 0.0 ? xy / (xx + least) : 0.0;
  const double rest = std::max(yy - shear * xy, 0.0) + least;
  double farthest = 0.0;
  for (Near& one : around)
  {
    one.Y = rest > 0.0 ? (one.Y - shear * one.X) / std::sqrt(rest) : 0.0;
    one.X *= scale;
    farthest = std::max(farthest, one.X * one.X + one.Y * one.Y);
  }
  for (Near& one : around)
  {
    const double away = farthest > 0.0 ? (one.X * one.X + one.Y * one.Y) / (1.1 * farthest) : 0.0;
    one.Weight = (1.0 - away) * (1.0 - away) * (1.0 - away);
  }
}

/// At the position that the others are around: of the linear function that fits theirs best.
inline Vector3 ConjugatePotential::GradientAt(const std::vector<Near>& around) const
{
  const Vector3 none{ { 0.0, 0.0, 0.0 } };
  double total = 0.0, x = 0.0, y = 0.0;
  Vector3 mean = none;
  for (const Near& one : around)
  {
    total += one.Weight;
    x += one.Weight * one.X;
    y += one.Weight * one.Y;
    mean = mean + one.Weight * this->Gradients[one.Cell];
  }
  x /= total;
  y /= total;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  Vector3 byX = none, byY = none;
  for (const Near& one : around)
  {
    xx += one.Weight * (one.X - x) * (one.X - x);
    xy += one.Weight * (one.X - x) * (one.Y - y);
    yy += one.Weight * (one.Y - y) * (one.Y - y);
    byX = byX + (one.Weight * (one.X - x)) * this->Gradients[one.Cell];
    byY = byY + (one.Weight * (one.Y - y)) * this->Gradients[one.Cell];
  }
  const double determinant = xx * yy - xy * xy;
  const bool isLine = !(determinant > 1e-3 * (xx + yy) * (xx + yy));
  const double factor = isLine ? 0.0 : 1.0 / determinant;
  const Vector3 alongX = factor * (yy * byX - xy * byY);
  const Vector3 alongY = factor * (xx * byY - xy * byX);
  return (1.0 / total) * mean - x * alongX - y * alongY;
}

inline double ConjugatePotential::At(const Vector3& x, const std::vector<Near>& around) const
{
  const Vector3 gradient = this->GradientAt(around);
  double sum = 0.0, total = 0.0;
  for (const Near& one : around)
  {
    const Vector3 mean = 0.5 * (this->Gradients[one.Cell] + gradient);
    sum += one.Weight * (this->Values[one.Cell] + Dot(mean, x - this->Middles[one.Cell]));
    total += one.Weight;
  }
  return sum / total;
}

// From each cell on to its neighbours, so that walks are short.
inline std::vector<double> ConjugatePotential::FindAll(const std::vector<Vector3>& at) const
{
  constexpr std::uint32_t none = MeshEdge::None;
  std::vector<double> values(at.size());
  std::vector<std::uint32_t> found(at.size(), none), order;
  std::vector<Near> around;
  for (std::uint32_t seed = 0; seed < at.size(); ++seed)
  {
    if (found[seed] != none)
    {
      continue;
    }
    found[seed] = this->Walk(seed, at[seed]);
    order.assign(1, seed);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const std::uint32_t cell = order[i];
      this->FindAround(found[cell], at[cell], around);
      Weigh(around);
      values[cell] = this->At(at[cell], around);
      for (const std::uint32_t inner : this->InnerOfCell[cell])
      {
        const std::array<std::uint32_t, 2>& both = this->Inner[inner]->Cells;
        const std::uint32_t next = both[both[0] == cell ? 1 : 0];
        if (found[next] == none)
        {
          found[next] = this->Walk(found[cell], at[next]);
          order.push_back(next);
        }
      }
    }
  }
  return values;
}

}

#endif
