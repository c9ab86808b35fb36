// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProbeRun.h
 * @brief runs of vtkSkdTreeProbe on points or lines and a source
 */
#ifndef skdtest_ProbeRun_h
#define skdtest_ProbeRun_h

#include "Support/FetchCell.h"
#include "Support/FilterRun.h"
#include "Support/MakeOf.h"

#include "vtkGenericCell.h"
#include "vtkSkdTreeProbe.h"
#include "vtkTable.h"

namespace skdtest
{

using ProbePointer = vtkSmartPointer<vtkSkdTreeProbe>;

inline ProbePointer MakeProbe(vtkDataObject* input, vtkDataObject* source)
{
  return MakeOf<vtkSkdTreeProbe>(input, source);
}

inline std::vector<double> ProbeArray(vtkSkdTreeProbe* probe, const char* name)
{
  probe->Update();
  return PointArray(probe->GetOutputDataObject(0), name);
}

/// Points in random cells of a mesh, `where` being where in the cell; the cell of each.
struct PointsInCells
{
  std::vector<Point> Points;
  Ids Cells;
};

inline PointsInCells MakePointsInCells(vtkDataSet* mesh, int count, int seed = 9)
{
  Random random(seed);
  PointsInCells made;
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(mesh->GetMaxCellSize() + 1);
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType id = random.Index(static_cast<int>(mesh->GetNumberOfCells()));
    FetchCell(mesh, id, cell);
    // A mean of the points with random shares of at least a hundredth: within every convex cell.
    Point x = { 0, 0, 0 };
    double sum = 0.0;
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      Point p;
      cell->GetPoints()->GetPoint(k, p.data());
      const double share = 0.01 + random.InBox({ 0, 1, 0, 1, 0, 1 })[0];
      x = x + share * p;
      sum += share;
    }
    made.Points.push_back((1.0 / sum) * x);
    made.Cells.push_back(id);
  }
  return made;
}

/// One polyline.
inline PolyDataPointer MakeLine(const std::vector<Point>& points)
{
  Mesh mesh;
  Ids ids;
  for (const Point& p : points)
  {
    ids.push_back(mesh.Add(p));
  }
  mesh.Add(VTK_POLY_LINE, ids);
  return MakePolyData(mesh);
}

/// The segments of lines in the second output, after an update.
struct Intervals
{
  std::vector<double> Cells, Lines, Entries, Exits, Lengths;
  std::vector<Point> From, To;

  explicit Intervals(vtkSkdTreeProbe* probe)
  {
    probe->ProbeLinesOn();
    probe->Update();
    auto* output = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(1));
    vtkCellData* data = output->GetCellData();
    this->Cells = ValuesOf(data->GetArray("SkdSourceCellId"));
    this->Lines = ValuesOf(data->GetArray("SkdInputCellId"));
    this->Entries = ValuesOf(data->GetArray("SkdEntry"));
    this->Exits = ValuesOf(data->GetArray("SkdExit"));
    this->Lengths = ValuesOf(data->GetArray("SkdLength"));
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      output->GetPoint(2 * i, this->From.emplace_back().data());
      output->GetPoint(2 * i + 1, this->To.emplace_back().data());
    }
  }
};

/// A column of the third output, after an update.
inline std::vector<double> IntegralsOf(vtkSkdTreeProbe* probe, const char* name)
{
  auto* table = vtkTable::SafeDownCast(probe->GetOutputDataObject(2));
  return ValuesOf(vtkDataArray::SafeDownCast(table->GetColumnByName(name)));
}

}

#endif
