// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_Aggregation_h
#define skd_Adaptation_Aggregation_h

#include "../../Geometry/Rows.h"
#include "EdgeLaplacian.h"

#include <algorithm>
#include <array>

namespace skd
{

/// About the inverse of an EdgeLaplacian at a cost that is proportional to the number of cells:
/// algebraic multigrid. Cells are aggregated with the neighbours that they are strongly connected
/// to, aggregates likewise, until few are left. Each level smooths by Gauss and Seidel's method,
/// there and back, and asks the next for its two best corrections (the K-cycle of Y. Notay,
/// P. S. Vassilevski, Numer. Linear Algebra Appl. 15 (2008) 473-487): with one, the number of
/// steps would grow with that of levels.
class Aggregation
{
public:
  explicit Aggregation(const EdgeLaplacian& matrix);

  /// What is about the y whose losses (EdgeLaplacian::Apply) are given.
  void Estimate(const std::vector<double>& losses, std::vector<double>& y) const
  {
    this->Cycle(0, losses, y);
  }

  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  struct Neighbour
  {
    std::uint32_t Cell;
    double Weight;
  };

  struct Level
  {
    Rows<Neighbour> Neighbours; // of each cell
    std::vector<double> Diagonal;
    std::vector<std::uint32_t> AggregateOf; // in the next level; none of the last

    std::size_t size() const { return this->Diagonal.size(); }
    void Relax(std::size_t i, const std::vector<double>& losses, std::vector<double>& y) const;
    void Apply(const std::vector<double>& y, std::vector<double>& losses) const;
  };

  static Level MakeLevel(const EdgeLaplacian& matrix);
  static std::size_t Aggregate(Level& level);
  static EdgeLaplacian Coarsen(const EdgeLaplacian& matrix, const Level& level, std::size_t n);
  void Cycle(std::size_t at, const std::vector<double>& losses, std::vector<double>& y) const;
  void Correct(std::size_t at, std::vector<double> losses, std::vector<double>& y) const;

  std::vector<Level> Levels;
};

inline Aggregation::Level Aggregation::MakeLevel(const EdgeLaplacian& matrix)
{
  Level level;
  level.Diagonal.assign(matrix.NumberOfCells, 0.0);
  for (const EdgeLaplacian::Flow& flow : matrix.Flows)
  {
    level.Diagonal[flow.Cells[0]] += flow.Weight;
    level.Diagonal[flow.Cells[1]] += flow.Weight;
  }
  level.Neighbours = Rows<Neighbour>(matrix.NumberOfCells,
    [&](const auto& add)
    {
      for (const EdgeLaplacian::Flow& flow : matrix.Flows)
      {
        add(flow.Cells[0], Neighbour{ flow.Cells[1], flow.Weight });
        add(flow.Cells[1], Neighbour{ flow.Cells[0], flow.Weight });
      }
    });
  return level;
}

// First cells with all neighbours that they are strongly connected to, where none of these is in
// an aggregate; then those left over go where they are connected most.
inline std::size_t Aggregation::Aggregate(Level& level)
{
  constexpr double strong = 0.25; // of a cell's largest weight
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t>& of = level.AggregateOf;
  of.assign(level.size(), none);
  std::uint32_t count = 0;
  for (const bool isFirst : { true, false })
  {
    const std::vector<std::uint32_t> before = of;
    for (std::uint32_t cell = 0; cell < level.size(); ++cell)
    {
      const Rows<Neighbour>::Row neighbours = level.Neighbours[cell];
      if (of[cell] != none)
      {
        continue;
      }
      double largest = 0.0;
      std::uint32_t best = none;
      for (const Neighbour& neighbour : neighbours)
      {
        largest = std::max(largest, neighbour.Weight);
      }
      bool isAlone = true;
      double most = 0.0;
      for (const Neighbour& neighbour : neighbours)
      {
        const std::uint32_t its = (isFirst ? of : before)[neighbour.Cell];
        isAlone = isAlone && (its == none || neighbour.Weight < strong * largest);
        best = its != none && neighbour.Weight > most ? its : best;
        most = its != none ? std::max(most, neighbour.Weight) : most;
      }
      if (isFirst && isAlone)
      {
        of[cell] = count;
        for (const Neighbour& neighbour : neighbours)
        {
          std::uint32_t& its = of[neighbour.Cell];
          its = its != none || neighbour.Weight < strong * largest ? its : count;
        }
        ++count;
      }
      else if (!isFirst)
      {
        of[cell] = best != none ? best : count++;
      }
    }
  }
  return count;
}

inline EdgeLaplacian Aggregation::Coarsen(
  const EdgeLaplacian& matrix, const Level& level, std::size_t n)
{
  EdgeLaplacian coarse;
  coarse.NumberOfCells = n;
  for (const EdgeLaplacian::Flow& flow : matrix.Flows)
  {
    const std::uint32_t a = level.AggregateOf[flow.Cells[0]];
    const std::uint32_t b = level.AggregateOf[flow.Cells[1]];
    if (a != b)
    {
      coarse.Flows.push_back({ { std::min(a, b), std::max(a, b) }, flow.Weight });
    }
  }
  const auto isBefore = [](const EdgeLaplacian::Flow& a, const EdgeLaplacian::Flow& b)
  { return a.Cells[0] != b.Cells[0] ? a.Cells[0] < b.Cells[0] : a.Cells[1] < b.Cells[1]; };
  std::stable_sort(coarse.Flows.begin(), coarse.Flows.end(), isBefore);
  std::size_t made = 0;
  for (const EdgeLaplacian::Flow& flow : coarse.Flows)
  {
    if (made > 0 && !isBefore(coarse.Flows[made - 1], flow))
    {
      coarse.Flows[made - 1].Weight += flow.Weight;
      continue;
    }
    coarse.Flows[made++] = flow;
  }
  coarse.Flows.resize(made);
  return coarse;
}

inline Aggregation::Aggregation(const EdgeLaplacian& matrix)
{
  constexpr std::size_t few = 40; // cells, which relaxing alone solves for
  EdgeLaplacian now = matrix;
  this->Levels.push_back(MakeLevel(now));
  while (this->Levels.back().size() > few)
  {
    Level& level = this->Levels.back();
    const std::size_t count = Aggregate(level);
    if (10 * count > 9 * level.size()) // hardly smaller: further levels would not pay
    {
      break;
    }
    now = Coarsen(now, level, count);
    this->Levels.push_back(MakeLevel(now));
  }
}

inline void Aggregation::Level::Relax(
  std::size_t i, const std::vector<double>& losses, std::vector<double>& y) const
{
  double sum = losses[i];
  for (const Neighbour& neighbour : this->Neighbours[i])
  {
    sum += neighbour.Weight * y[neighbour.Cell];
  }
  y[i] = this->Diagonal[i] > 0.0 ? sum / this->Diagonal[i] : 0.0;
}

inline void Aggregation::Level::Apply(
  const std::vector<double>& y, std::vector<double>& losses) const
{
  losses.resize(this->size());
  for (std::size_t i = 0; i < losses.size(); ++i)
  {
    double sum = this->Diagonal[i] * y[i];
    for (const Neighbour& neighbour : this->Neighbours[i])
    {
      sum -= neighbour.Weight * y[neighbour.Cell];
    }
    losses[i] = sum;
  }
}

inline void Aggregation::Cycle(
  std::size_t at, const std::vector<double>& losses, std::vector<double>& y) const
{
  const Level& level = this->Levels[at];
  const bool isLast = at + 1 == this->Levels.size();
  const int sweeps = isLast ? 30 : 1; // of few cells: to convergence, or nearly so
  y.assign(level.size(), 0.0);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      level.Relax(i, losses, y);
    }
    if (!isLast)
    {
      std::vector<double> image;
      level.Apply(y, image);
      std::vector<double> left(this->Levels[at + 1].size(), 0.0), correction;
      for (std::size_t i = 0; i < level.size(); ++i)
      {
        left[level.AggregateOf[i]] += losses[i] - image[i];
      }
      this->Correct(at + 1, std::move(left), correction);
      for (std::size_t i = 0; i < level.size(); ++i)
      {
        y[i] += correction[level.AggregateOf[i]];
      }
    }
    for (std::size_t i = level.size(); i-- > 0;)
    {
      level.Relax(i, losses, y);
    }
  }
}

// Two steps of flexible conjugate gradients, the second only where the first did little.
inline void Aggregation::Correct(
  std::size_t at, std::vector<double> losses, std::vector<double>& y) const
{
  std::vector<double> directions[2], images[2];
  constexpr double little = 0.25; // of the norm that is left of the residual: Notay's threshold t
  const double enough = little * little * detail::DotOf(losses, losses);
  y.assign(losses.size(), 0.0);
  for (int step = 0; step < 2 && detail::DotOf(losses, losses) > enough; ++step)
  {
    this->Cycle(at, losses, directions[step]);
    this->Levels[at].Apply(directions[step], images[step]);
    if (step > 0)
    {
      const double part =
        detail::DotOf(directions[1], images[0]) / detail::DotOf(directions[0], images[0]);
      detail::AddTo(directions[1], -part, directions[0]);
      detail::AddTo(images[1], -part, images[0]);
    }
    const double curvature = detail::DotOf(directions[step], images[step]);
    if (!(curvature > 0.0))
    {
      break;
    }
    const double length = detail::DotOf(directions[step], losses) / curvature;
    detail::AddTo(y, length, directions[step]);
    detail::AddTo(losses, -length, images[step]);
  }
}

/// The y of which each cell gains `gains`, by flexible conjugate gradients with an Aggregation as
/// preconditioner. In each connected part the gains must sum to 0; y, which begins with 0, is known
/// but for a constant there. Ends when the residual is `tolerance` of the gains, or after `most`
/// steps, and returns how many steps were made. O(N) a step; does not depend on threads.
inline int SolveForGains(const EdgeLaplacian& matrix, const Aggregation& levels,
  const std::vector<double>& gains, double tolerance, int most, std::vector<double>& y)
{
  std::vector<double> residual(gains), scaled, direction, image, before;
  detail::Scale(residual, -1.0);
  y.assign(gains.size(), 0.0);
  const double enough = tolerance * tolerance * detail::DotOf(gains, gains);
  double last = 0.0;
  int step = 0;
  for (; step < most && detail::DotOf(residual, residual) > enough; ++step)
  {
    levels.Estimate(residual, scaled);
    const double now = detail::DotOf(residual, scaled);
    const double part = step > 0 ? (now - detail::DotOf(before, scaled)) / last : 0.0;
    direction.resize(scaled.size(), 0.0);
    detail::Scale(direction, part);
    detail::AddTo(direction, 1.0, scaled);
    matrix.Apply(direction, image);
    const double curvature = detail::DotOf(direction, image);
    if (!(curvature > 0.0))
    {
      break;
    }
    before = residual;
    detail::AddTo(y, now / curvature, direction);
    detail::AddTo(residual, -now / curvature, image);
    last = now;
  }
  return step;
}

}

#endif
