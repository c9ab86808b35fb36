// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdLineProbe.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Search/Probe/SkdCellLocations.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// Cuts one piece after the other. One object a thread.
class Cutter
{
public:
  Cutter(const SkdCellFinderSource& source, const SkdCellFinderRules& rules)
    : Source(source)
    , Rules(rules)
    , Finder(source, rules)
  {
  }

  std::vector<SkdLineInterval> Cut(const std::vector<SkdLinePiece>& pieces, std::size_t index)
  {
    const SkdLinePiece& piece = pieces[index];
    const double length = std::sqrt(skd::Distance2(piece.From, piece.To));
    std::vector<SkdLineInterval> intervals;
    this->FindBorders(piece, length);
    double last = 0.0;
    for (std::size_t i = 1; i < this->Borders.size(); ++i)
    {
      const double next = this->Borders[i];
      const skd::Vector3 middle = skd::Lerp(piece.From, piece.To, 0.5 * (last + next));
      if (this->FindHolder(middle))
      {
        const SkdCellLocation& location = this->Finder.GetLocation();
        const SkdLineInterval interval{ index, skd::Lerp(piece.From, piece.To, last),
          skd::Lerp(piece.From, piece.To, next), piece.Start + last * length,
          piece.Start + next * length, location.Block, location.CellId };
        Append(interval, intervals);
      }
      last = next;
    }
    return intervals;
  }

private:
  static void Append(const SkdLineInterval& next, std::vector<SkdLineInterval>& intervals)
  {
    const bool isMore = !intervals.empty() && intervals.back().Block == next.Block &&
      intervals.back().CellId == next.CellId && intervals.back().Exit == next.Entry;
    if (isMore)
    {
      intervals.back().To = next.To;
      intervals.back().Exit = next.Exit;
    }
    else
    {
      intervals.push_back(next);
    }
  }

  // Segments shorter than rounding error are ignored: the two cells of a face may disagree on its
  // position.
  void FindBorders(const SkdLinePiece& piece, double length)
  {
    std::vector<double> all{ 0.0, 1.0 };
    for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
    {
      const double tolerance =
        this->Source.GetLargestTolerance(this->Rules, static_cast<int>(block));
      this->Source.Trees.GetLocator(static_cast<int>(block))
        ->FindCellBorders(piece.From.X, piece.To.X, tolerance, this->Parameters);
      const double* first = this->Parameters->GetPointer(0);
      all.insert(all.end(), first, first + this->Parameters->GetNumberOfTuples());
    }
    std::sort(all.begin(), all.end());
    double magnitude = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      magnitude = std::max({ magnitude, std::abs(piece.From[axis]), std::abs(piece.To[axis]) });
    }
    const double rounding =
      32.0 * std::numeric_limits<double>::epsilon() * (1.0 + magnitude / length);
    this->Borders.assign(1, 0.0);
    for (double t : all)
    {
      if (t - this->Borders.back() > rounding)
      {
        this->Borders.push_back(t);
      }
    }
    this->Borders.back() = this->Borders.size() > 1 && this->Borders.back() >= 1.0 - rounding
      ? 1.0
      : this->Borders.back();
  }

  bool FindHolder(const skd::Vector3& x)
  {
    return this->Finder.Find(x.X) &&
      (this->Finder.GetLocation().Distance == 0.0 || !this->Finder.IsInVolume());
  }

  const SkdCellFinderSource& Source;
  SkdCellFinderRules Rules;
  SkdCellFinder Finder;
  vtkNew<vtkDoubleArray> Parameters;
  std::vector<double> Borders;
};

void AddPieces(
  int input, vtkDataSet* mesh, vtkIdType line, vtkIdList* ids, std::vector<SkdLinePiece>& pieces)
{
  double length = 0.0;
  for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    skd::Vector3 from, to;
    mesh->GetPoint(ids->GetId(i), from.X);
    mesh->GetPoint(ids->GetId(i + 1), to.X);
    const double more = std::sqrt(skd::Distance2(from, to));
    if (more > 0.0 && std::isfinite(more))
    {
      pieces.push_back({ input, line, from, to, length });
      length += more;
    }
  }
}

/// Calls visit(i, finder, pieces' interval) in parallel, with a finder of the thread.
template <class Visit>
void ForEachInterval(const SkdLineOutput& output, const Visit& visit)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(output.Intervals.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdCellFinder finder(output.Source, SkdCellFinderRules());
      for (vtkIdType i = begin; i < end; ++i)
      {
        visit(i, finder, output.Intervals[i]);
      }
    });
}

/// Interpolates at a point of the interval, as its cell does.
void InterpolateAt(SkdArrayGather& gather, vtkIdType to, SkdCellFinder& finder,
  const SkdLineInterval& interval, const skd::Vector3& x)
{
  if (finder.Evaluate(interval.Block, interval.CellId, x.X))
  {
    gather.Interpolate(to, interval.Block, finder.GetPointIds(), finder.GetWeights());
  }
}

void AddIds(const SkdLineOutput& output, vtkCellData* data)
{
  const auto n = static_cast<vtkIdType>(output.Intervals.size());
  auto cells = SkdMakeArray<vtkIdTypeArray>(SkdCellLocations::CellIdName, 1, n, -1);
  auto blockIndices = SkdMakeArray<vtkIntArray>(SkdCellLocations::BlockIndexName, 1, n, -1);
  auto lines = SkdMakeArray<vtkIdTypeArray>("SkdInputCellId", 1, n, -1);
  auto inputs = SkdMakeArray<vtkIntArray>("SkdInputBlockIndex", 1, n, -1);
  auto entries = SkdMakeArray<vtkDoubleArray>("SkdEntry", 1, n, 0.0);
  auto exits = SkdMakeArray<vtkDoubleArray>("SkdExit", 1, n, 0.0);
  auto lengths = SkdMakeArray<vtkDoubleArray>("SkdLength", 1, n, 0.0);
  std::vector<int> blocks;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdLineInterval& interval = output.Intervals[i];
    blocks.push_back(interval.Block);
    const SkdLinePiece& piece = output.Pieces[interval.Piece];
    cells->SetValue(i, interval.CellId);
    blockIndices->SetValue(i, output.Source.Blocks[interval.Block].BlockIndex);
    lines->SetValue(i, piece.Line);
    inputs->SetValue(i, output.Inputs[piece.Input].BlockIndex);
    entries->SetValue(i, interval.Entry);
    exits->SetValue(i, interval.Exit);
    lengths->SetValue(i, interval.Exit - interval.Entry);
  }
  SkdJoinIds(cells, blocks, output.Source.Blocks);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(cells.Get()),
         static_cast<vtkDataArray*>(lines.Get()), static_cast<vtkDataArray*>(entries.Get()),
         static_cast<vtkDataArray*>(exits.Get()), static_cast<vtkDataArray*>(lengths.Get()) })
  {
    data->AddArray(array);
  }
  data->AddArray(output.IsSourceComposite ? blockIndices.Get() : nullptr);
  data->AddArray(output.IsInputComposite ? inputs.Get() : nullptr);
}
}

std::vector<SkdLinePiece> SkdPiecesOf(const std::vector<SkdBlock>& inputs)
{
  std::vector<SkdLinePiece> pieces;
  vtkNew<vtkIdList> ids;
  for (std::size_t input = 0; input < inputs.size(); ++input)
  {
    vtkDataSet* mesh = inputs[input].Mesh;
    vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      const int type = mesh->GetCellType(cell);
      const bool isGhost = ghosts && ghosts->GetValue(cell) != 0;
      if (!isGhost && (type == VTK_LINE || type == VTK_POLY_LINE))
      {
        mesh->GetCellPoints(cell, ids);
        AddPieces(static_cast<int>(input), mesh, cell, ids, pieces);
      }
    }
  }
  return pieces;
}

std::vector<SkdLineInterval> SkdCutLines(const std::vector<SkdLinePiece>& pieces,
  const SkdCellFinderSource& source, const SkdCellFinderRules& rules, SkdLoop& loop)
{
  std::vector<std::vector<SkdLineInterval>> parts(pieces.size());
  loop.For(static_cast<vtkIdType>(pieces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Cutter cutter(source, rules);
      for (vtkIdType i = begin; i < end; ++i)
      {
        parts[i] = cutter.Cut(pieces, static_cast<std::size_t>(i));
      }
    });
  std::vector<SkdLineInterval> intervals;
  for (const std::vector<SkdLineInterval>& part : parts)
  {
    intervals.insert(intervals.end(), part.begin(), part.end());
  }
  return intervals;
}

void SkdFillIntervals(
  const SkdLineOutput& output, std::set<std::string>& refused, vtkPolyData* lines)
{
  const auto n = static_cast<vtkIdType>(output.Intervals.size());
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(2 * n);
  auto lengths = SkdMakeArray<vtkDoubleArray>("SkdArcLength", 1, 2 * n, 0.0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdLineInterval& interval = output.Intervals[i];
    points->SetPoint(2 * i, interval.From.X);
    points->SetPoint(2 * i + 1, interval.To.X);
    cells->InsertNextCell({ 2 * i, 2 * i + 1 });
    lengths->SetValue(2 * i, interval.Entry);
    lengths->SetValue(2 * i + 1, interval.Exit);
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetPointData()->AddArray(lengths);
  AddIds(output, lines->GetCellData());

  const std::vector<SkdBlock>& blocks = output.Source.Blocks;
  SkdArrayGather atEnds =
    SkdGatherInto(lines->GetPointData(), 2 * n, blocks, vtkDataObject::POINT, refused);
  SkdArrayGather ofCells =
    SkdGatherInto(lines->GetCellData(), n, blocks, vtkDataObject::CELL, refused);
  ForEachInterval(output,
    [&](vtkIdType i, SkdCellFinder& finder, const SkdLineInterval& interval)
    {
      InterpolateAt(atEnds, 2 * i, finder, interval, interval.From);
      InterpolateAt(atEnds, 2 * i + 1, finder, interval, interval.To);
      ofCells.Take(i, interval.Block, interval.CellId);
    });
}
}
