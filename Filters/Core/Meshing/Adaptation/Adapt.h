// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_Adapt_h
#define skd_Adaptation_Adapt_h

#include "Equidistribution.h"
#include "MeshMotion.h"
#include "Monitor.h"

namespace skd
{

struct AdaptRules
{
  MonitorRules Monitor;
  FreedomRules Freedom;
  int Iterations = 30;         ///< at most
  double Tolerance = 0.01;     ///< of the measure of equidistribution
  double Relaxation = 1.0;     ///< which part of Newton's step is made
  double LeastQuality = 0.02;  ///< that a cell may come to, see MeshMotion
  bool AreSharesEqual = false; ///< of all cells, not by their areas at first
};

/// Where an iteration begins: its mesh has been looked at, and not yet moved.
struct AdaptRow
{
  double Measure = 0.0; ///< see Equidistribution
  double SmallestQuality = 0.0;
  MeshMotion::Outcome Motion; ///< that led here; of the first row nothing
};

/// What an observer gets after each iteration.
struct AdaptState
{
  int Iteration;
  const AdaptRow& Row;
  bool IsBest;                        ///< of all so far
  const std::vector<double>& Monitor; ///< of the cells
  const std::vector<double>& Areas;
};

enum class AdaptEnd
{
  Reached,    ///< the measure is within the tolerance
  Stalled,    ///< it does not fall any more
  Iterations, ///< as many as were allowed
  Stopped,    ///< by whoever looked on
  NoMonitor   ///< no cell has a field, or none is greater than 0
};

struct AdaptOutcome
{
  AdaptEnd End = AdaptEnd::Iterations;
  std::vector<AdaptRow> Rows;
  std::size_t Best = 0; ///< the row with the smallest measure: the mesh is left as it was there
  std::uint32_t WorstCell = 0;  ///< of the best row: the cell that adds most to the measure
  double WorstRatio = 1.0;      ///< its monitor x area by its share
  std::size_t InvalidCells = 0; ///< at first; they do not move
  std::uint32_t FirstInvalid = MeshEdge::None;
  std::size_t CellsWithoutField = 0;
  std::size_t CellsNotPositive = 0; ///< whose monitor had to be raised
  std::uint32_t FirstNotPositive = MeshEdge::None;
};

/// Moves the points of a mesh so that its cells follow a monitor: steps 2 to 5 of the algorithm of
/// section 6.6. find(mesh, field) computes the field's mean in each cell, where the mesh is now, or
/// false to stop; look(state) is called in each iteration, and stops it all by returning false. The
/// mesh has its edges, and is on the shape. Each iteration takes O(N) beside what find does.
class Adaptation
{
public:
  Adaptation(SurfaceMesh& mesh, const SurfaceShape& shape, const AdaptRules& rules)
    : Mesh(mesh)
    , Shape(shape)
    , Rules(rules)
    , Curves(mesh, shape, rules.Freedom)
    , Motion(mesh, shape, this->Curves, rules.LeastQuality)
    , Function(rules.Monitor)
    , Shares(mesh, shape, this->Curves, MakeWeights(mesh, shape, rules.AreSharesEqual))
    , Relaxation(rules.Relaxation)
  {
    this->Outcome.InvalidCells = this->Motion.GetNumberOfInvalidCells();
    this->Outcome.FirstInvalid = this->Motion.GetFirstInvalidCell();
  }

  template <class Find, class Look>
  AdaptOutcome Run(const Find& find, const Look& look)
  {
    MeshMotion::Outcome step;
    for (int iteration = 0;; ++iteration)
    {
      if (!this->Measure(find, step))
      {
        break;
      }
      const bool isBest = this->Outcome.Best + 1 == this->Outcome.Rows.size();
      const AdaptState state{ iteration, this->Outcome.Rows.back(), isBest, this->Values,
        this->Shares.GetAreas() };
      if (!look(state))
      {
        this->Outcome.End = AdaptEnd::Stopped;
        break;
      }
      if (this->IsAtEnd(iteration))
      {
        break;
      }
      const bool canStart = this->Shape.What != SurfaceShape::Kind::Other;
      if (canStart && iteration == 1 && this->Outcome.Best == 0)
      {
        this->UndoStart();
      }
      step = canStart && iteration == 0 ? this->BeginByTransport() : this->Step();
    }
    if (!this->Best.empty())
    {
      this->Mesh.Points = this->Best;
    }
    return this->Outcome;
  }

  /// After Run(): the measure of the mesh as it is for a monitor that has these means in the cells,
  /// raised where it is too small, but not smoothed. Negative if none is greater than 0.
  double MeasureOf(std::vector<double> means)
  {
    MonitorRules rules = this->Rules.Monitor;
    rules.Kind = MonitorKind::Value;
    rules.Smoothings = 0;
    if (!Monitor(rules).Make(this->Mesh, this->Shape, std::move(means), this->Values))
    {
      return -1.0;
    }
    this->Shares.Update(this->Mesh, this->Values);
    return this->Shares.GetMeasure();
  }

private:
  /// Cells without area have hardly any weight, but some.
  static std::vector<double> MakeWeights(
    const SurfaceMesh& mesh, const SurfaceShape& shape, bool areEqual)
  {
    std::vector<double> weights(mesh.Cells.size(), 1.0);
    double largest = 0.0;
    for (std::uint32_t cell = 0; cell < weights.size() && !areEqual; ++cell)
    {
      weights[cell] = CellArea(mesh, shape, cell);
      largest = std::max(largest, weights[cell]);
    }
    for (double& weight : weights)
    {
      weight = std::max(weight, largest > 0.0 ? 1e-12 * largest : 1.0);
    }
    return weights;
  }

  MeshMotion::Outcome Step()
  {
    std::vector<Vector3> positions;
    const double part =
      this->Shares.Step(this->Mesh, this->Curves, this->Values, this->Relaxation, positions);
    MeshMotion::Outcome step = this->Motion.Move(this->Mesh, positions);
    step.Step = part;
    return step;
  }

  /// Where the transport of the monitor that the mesh has now to equal shares takes points that go
  /// the other way. It is as good as cells resolve the monitor where they are now. Where cells
  /// would be spoilt a part of the way is a beginning, too.
  MeshMotion::Outcome BeginByTransport()
  {
    constexpr double least = 0.2; // of the way
    constexpr double shorter = 0.75;
    this->FirstValues = this->Values;
    const std::vector<double> weights = this->Shares.GetWeights();
    std::vector<double> integrals(this->Shares.GetAreas());
    std::transform(integrals.begin(), integrals.end(), this->Values.begin(), integrals.begin(),
      std::multiplies<>());
    this->Shares.Restart(integrals);
    std::vector<Vector3> positions = this->Shares.Invert(this->FindImage());
    this->Shares.SetWeights(weights);
    MeshMotion::Outcome step;
    step.Step = 1.0;
    while (!this->Motion.MoveWhole(this->Mesh, positions, step))
    {
      step.Step *= shorter;
      if (!(step.Step > least))
      {
        this->Shares.Restart(std::vector<double>(weights));
        return this->Step();
      }
      positions = this->Shares.Shorten(shorter);
    }
    return step;
  }

  /// The mesh in which the area of each cell is its weight. The monitor is 1 here, wherever cells
  /// go, so that Newton's method converges in few steps.
  SurfaceMesh FindImage()
  {
    constexpr int most = 20;
    constexpr int smoothings = 2; // a start need not be right for single cells
    const double enough = std::max(0.5 * this->Rules.Tolerance, 1e-3);
    SurfaceMesh image = this->Mesh;
    FeatureCurves curves = this->Curves;
    MeshMotion motion(image, this->Shape, curves, 0.0);
    const std::vector<double> ones(this->Values.size(), 1.0);
    double before = HUGE_VAL;
    this->Shares.Update(image, ones);
    for (int step = 0;
         step<most&& this->Shares.GetMeasure()> enough && this->Shares.GetMeasure() < 0.95 * before;
         ++step)
    {
      before = this->Shares.GetMeasure();
      std::vector<Vector3> positions;
      this->Shares.Step(image, curves, ones, 1.0, positions, smoothings);
      motion.Move(image, positions);
      this->Shares.Update(image, ones);
    }
    return image;
  }

  /// To the mesh as it was given, where the start was none: a monitor that differs from cell to
  /// cell cannot be told where cells will be.
  void UndoStart()
  {
    this->Mesh.Points = this->Best;
    this->Values = this->FirstValues;
    this->Shares.Restart(std::vector<double>(this->Shares.GetWeights()));
    this->Shares.Update(this->Mesh, this->Values);
  }

  template <class Find>
  bool Measure(const Find& find, const MeshMotion::Outcome& step)
  {
    std::vector<double> field(this->Mesh.Cells.size());
    if (!find(this->Mesh, field))
    {
      this->Outcome.End = AdaptEnd::Stopped;
      return false;
    }
    if (!this->Function.Make(this->Mesh, this->Shape, std::move(field), this->Values))
    {
      this->Outcome.End = AdaptEnd::NoMonitor;
      return false;
    }
    this->Shares.Update(this->Mesh, this->Values);
    std::vector<AdaptRow>& rows = this->Outcome.Rows;
    rows.push_back(
      { this->Shares.GetMeasure(), this->Motion.FindSmallestQuality(this->Mesh), step });
    if (rows.size() == 1 || rows.back().Measure < rows[this->Outcome.Best].Measure)
    {
      this->Outcome.Best = rows.size() - 1;
      this->Outcome.CellsWithoutField = this->Function.GetCellsWithoutField();
      this->Outcome.CellsNotPositive = this->Function.GetCellsNotPositive();
      this->Outcome.FirstNotPositive = this->Function.GetFirstNotPositive();
      this->Outcome.WorstCell = this->Shares.GetWorstCell();
      this->Outcome.WorstRatio = this->Shares.GetWorstRatio();
      this->Best = this->Mesh.Points;
    }
    return true;
  }

  /// A measure that rises calls for smaller steps: the field of cells that move changes in jumps.
  bool IsAtEnd(int iteration)
  {
    constexpr std::size_t patience = 8;
    constexpr double progress = 0.99;
    const std::vector<AdaptRow>& rows = this->Outcome.Rows;
    if (rows.back().Measure <= this->Rules.Tolerance)
    {
      this->Outcome.End = AdaptEnd::Reached;
      return true;
    }
    if (rows.back().Measure < progress * rows[this->LastProgress].Measure)
    {
      this->LastProgress = rows.size() - 1;
    }
    if (rows.size() > this->LastProgress + patience)
    {
      this->Outcome.End = AdaptEnd::Stalled;
      return true;
    }
    if (rows.size() > 2 && rows.back().Measure > rows[rows.size() - 2].Measure)
    {
      this->Relaxation = std::max(0.7 * this->Relaxation, 0.1 * this->Rules.Relaxation);
    }
    return iteration >= this->Rules.Iterations;
  }

  SurfaceMesh& Mesh;
  const SurfaceShape& Shape;
  AdaptRules Rules;
  FeatureCurves Curves;
  MeshMotion Motion;
  Monitor Function;
  Equidistribution Shares;
  AdaptOutcome Outcome;
  std::vector<double> Values;
  std::vector<double> FirstValues;
  std::vector<Vector3> Best;
  double Relaxation;
  std::size_t LastProgress = 0; // the row
};

}

#endif
