// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_Monitor_h
#define skd_Adaptation_Monitor_h

#include "PointGradients.h"

namespace skd
{

/// What the monitor is made of.
enum class MonitorKind
{
  ArcLength, ///< sqrt(1 + strength g^2)
  Gradient,  ///< 1 + strength g
  Value      ///< the field itself
};

struct MonitorRules
{
  MonitorKind Kind = MonitorKind::ArcLength;
  double Strength = 10.0;
  int Smoothings = 3;          ///< times that each cell takes half from its neighbours
  double LargestRatio = 100.0; ///< of the largest monitor to the smallest, which is raised
};

/// The monitor function of a field that cells have, g being the length of the field's gradient
/// relative to its mean over the mesh at the first evaluation of the monitor: so that strengths
/// mean the same in all units and on all scales.
class Monitor
{
public:
  explicit Monitor(const MonitorRules& rules)
    : Rules(rules)
  {
  }

  /// Cells whose field is NaN take the mean of neighbours that have one. False if none has.
  bool Make(const SurfaceMesh& mesh, const SurfaceShape& shape, std::vector<double> field,
    std::vector<double>& monitor);

  ///@{
  /// Of the last one: cells that had no field, and those whose monitor had to be raised because it
  /// was not greater than 0, and the first of these.
  std::size_t GetCellsWithoutField() const { return this->CellsWithoutField; }
  std::size_t GetCellsNotPositive() const { return this->CellsNotPositive; }
  std::uint32_t GetFirstNotPositive() const { return this->FirstNotPositive; }
  ///@}

private:
  static bool Fill(const SurfaceMesh& mesh, std::vector<double>& field);
  static void Smooth(const SurfaceMesh& mesh, std::vector<double>& values);
  void FromGradient(const SurfaceMesh& mesh, const SurfaceShape& shape,
    const std::vector<double>& field, std::vector<double>& monitor);
  bool Raise(std::vector<double>& monitor);

  MonitorRules Rules;
  double MeanGradient = -1.0;
  std::size_t CellsWithoutField = 0;
  std::size_t CellsNotPositive = 0;
  std::uint32_t FirstNotPositive = MeshEdge::None;
};

inline bool Monitor::Fill(const SurfaceMesh& mesh, std::vector<double>& field)
{
  std::vector<double> sums(field.size());
  std::vector<int> counts(field.size());
  for (bool isAny = true; isAny;)
  {
    isAny = false;
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0);
    for (const MeshEdge& edge : mesh.Edges)
    {
      for (int side = 0; side < 2 && edge.Cells[1] != MeshEdge::None; ++side)
      {
        const double value = field[edge.Cells[1 - side]];
        sums[edge.Cells[side]] += std::isfinite(value) ? value : 0.0;
        counts[edge.Cells[side]] += std::isfinite(value);
      }
    }
    for (std::size_t cell = 0; cell < field.size(); ++cell)
    {
      if (!std::isfinite(field[cell]) && counts[cell] > 0)
      {
        field[cell] = sums[cell] / counts[cell];
        isAny = isAny || std::isfinite(field[cell]); // sums of large numbers are not
      }
    }
  }
  const auto isKnown = [](double value) { return std::isfinite(value); };
  if (std::none_of(field.begin(), field.end(), isKnown))
  {
    return false;
  }
  double sum = 0.0; // parts of the mesh that have none at all get what the others have on average
  double known = 0.0;
  for (const double value : field)
  {
    sum += isKnown(value) ? value : 0.0;
    known += isKnown(value);
  }
  std::replace_if(
    field.begin(), field.end(), [&](double value) { return !isKnown(value); }, sum / known);
  return true;
}

inline void Monitor::Smooth(const SurfaceMesh& mesh, std::vector<double>& values)
{
  std::vector<double> sums(values.size(), 0.0);
  std::vector<int> counts(values.size(), 0);
  for (const MeshEdge& edge : mesh.Edges)
  {
    for (int side = 0; side < 2 && edge.Cells[1] != MeshEdge::None; ++side)
    {
      sums[edge.Cells[side]] += values[edge.Cells[1 - side]];
      ++counts[edge.Cells[side]];
    }
  }
  for (std::size_t cell = 0; cell < values.size(); ++cell)
  {
    values[cell] =
      counts[cell] > 0 ? 0.5 * (values[cell] + sums[cell] / counts[cell]) : values[cell];
  }
}

inline void Monitor::FromGradient(const SurfaceMesh& mesh, const SurfaceShape& shape,
  const std::vector<double>& field, std::vector<double>& monitor)
{
  PointGradients gradients;
  gradients.Build(mesh, shape);
  double sum = 0.0;
  double area = 0.0;
  for (std::uint32_t cell = 0; cell < field.size(); ++cell)
  {
    Vector3 mean{ { 0.0, 0.0, 0.0 } };
    for (const std::uint32_t corner : mesh.Cells[cell])
    {
      mean = mean + gradients.At(field, corner);
    }
    monitor[cell] = Norm(mean) / static_cast<double>(mesh.Cells[cell].size());
    const double size = CellArea(mesh, shape, cell);
    sum += size * monitor[cell];
    area += size;
  }
  if (this->MeanGradient < 0.0)
  {
    this->MeanGradient = sum / area;
  }
  for (double& value : monitor)
  {
    const double g = this->MeanGradient > 0.0 ? value / this->MeanGradient : 0.0;
    value = this->Rules.Kind == MonitorKind::Gradient
      ? 1.0 + this->Rules.Strength * g
      : std::sqrt(1.0 + this->Rules.Strength * g * g);
  }
}

inline bool Monitor::Raise(std::vector<double>& monitor)
{
  const double largest = *std::max_element(monitor.begin(), monitor.end());
  this->CellsNotPositive = 0;
  if (!(largest > 0.0))
  {
    return false;
  }
  for (std::size_t cell = 0; cell < monitor.size(); ++cell)
  {
    const bool isFirst = this->CellsNotPositive == 0 && !(monitor[cell] > 0.0);
    this->FirstNotPositive = isFirst ? static_cast<std::uint32_t>(cell) : this->FirstNotPositive;
    this->CellsNotPositive += !(monitor[cell] > 0.0);
    monitor[cell] = std::max(monitor[cell], largest / this->Rules.LargestRatio);
  }
  return true;
}

inline bool Monitor::Make(const SurfaceMesh& mesh, const SurfaceShape& shape,
  std::vector<double> field, std::vector<double>& monitor)
{
  this->CellsWithoutField = static_cast<std::size_t>(
    std::count_if(field.begin(), field.end(), [](double value) { return !std::isfinite(value); }));
  if (field.empty() || (this->CellsWithoutField > 0 && !Fill(mesh, field)))
  {
    return false;
  }
  monitor.resize(field.size());
  if (this->Rules.Kind == MonitorKind::Value)
  {
    monitor = field;
  }
  else
  {
    this->FromGradient(mesh, shape, field, monitor);
  }
  const bool isPositive = this->Raise(monitor);
  for (int i = 0; i < this->Rules.Smoothings; ++i)
  {
    Smooth(mesh, monitor);
  }
  return isPositive;
}

}

#endif
