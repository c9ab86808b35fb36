// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Works.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace skdbench
{
namespace
{

using namespace skdtest;

/// A random place in a random cell, and the size of that cell.
struct Site
{
  Point Where;
  double CellSize;
};

class QueryMaker
{
public:
  QueryMaker(vtkDataSet* data, int count)
    : Data(data)
    , Count(count)
  {
    data->GetBounds(this->Box.data());
    this->Size = Diagonal(this->Box);
  }

  /// Within a thousandth of the diagonal of a cell.
  Query NearSurface()
  {
    Query query{ this->RandomSite().Where };
    query.From = query.From + this->Random.Between(0, 1e-3) * this->Size * this->Random.Direction();
    return query;
  }

  /// Two to five diagonals away.
  Query Far()
  {
    const double distance = this->Random.Between(2, 5) * this->Size;
    return { Center(this->Box) + distance * this->Random.Direction() };
  }

  Query InGrownBox()
  {
    const Point middle = Center(this->Box);
    return { middle + 1.5 * (this->Random.InBox(this->Box) - middle) };
  }

  /// Radius of a hundredth of the diagonal, about points of which about half have a cell within it.
  Query WithRadius()
  {
    Query query{ this->RandomSite().Where };
    query.From = query.From + this->Random.Between(0, 0.02) * this->Size * this->Random.Direction();
    query.Radius = 0.01 * this->Size;
    return query;
  }

  /// From outside to outside, through a random point of the box.
  Query AcrossBox()
  {
    const Point middle = this->Random.InBox(this->Box);
    const Point maxDistance = this->Size * this->Random.Direction();
    return { middle - maxDistance, middle + maxDistance };
  }

  /// Two hundredths of the diagonal long, centred near a cell.
  Query ShortSegment()
  {
    const Point middle = this->NearSurface().From;
    const Point maxDistance = 0.01 * this->Size * this->Random.Direction();
    return { middle - maxDistance, middle + maxDistance };
  }

  Query InBox() { return { this->Random.InBox(this->Box) }; }

  Query InCell() { return { this->RandomSite().Where }; }

  /// Walks straight on, a quarter of the first cell's size a step, 64 steps a walk.
  Query Coherent()
  {
    if (this->StepsLeft == 0)
    {
      const Site site = this->RandomSite();
      this->At = site.Where;
      this->Step = 0.25 * site.CellSize * this->Random.Direction();
      this->StepsLeft = 64;
    }
    --this->StepsLeft;
    this->At = this->At + this->Step;
    return { this->At };
  }

  /// Twice as long as a cell that it is about.
  Query SmallBox()
  {
    const Site site = this->RandomSite();
    const Point& c = site.Where;
    return BoxQuery(Grown({ c[0], c[0], c[1], c[1], c[2], c[2] }, site.CellSize));
  }

  /// A twentieth of each side of the data set's box, about a place in a cell.
  Query TwentiethBox()
  {
    const Point c = this->RandomSite().Where;
    Bounds box;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double half = 0.025 * (this->Box[2 * axis + 1] - this->Box[2 * axis]);
      box[2 * axis] = c[axis] - half;
      box[2 * axis + 1] = c[axis] + half;
    }
    return BoxQuery(box);
  }

  Work Make(const std::string& name, QueryKind requested, Query (QueryMaker::*one)())
  {
    Work work{ name, requested, {} };
    for (int i = 0; i < this->Count; ++i)
    {
      work.Queries.push_back((this->*one)());
    }
    return work;
  }

private:
  static Query BoxQuery(const Bounds& box)
  {
    Query query{};
    query.Box = box;
    return query;
  }

  Site RandomSite()
  {
    const vtkIdType id = this->Random.Index(static_cast<int>(this->Data->GetNumberOfCells()));
    this->Data->GetCell(id, this->Cell);
    Point where{};
    double sum = 0.0;
    for (vtkIdType i = 0; i < this->Cell->GetNumberOfPoints(); ++i)
    {
      Point corner;
      this->Cell->GetPoints()->GetPoint(i, corner.data());
      const double weight = this->Random.Between(0.05, 1.0);
      where = where + weight * corner;
      sum += weight;
    }
    return { (1.0 / sum) * where, std::sqrt(this->Cell->GetLength2()) };
  }

  vtkDataSet* Data;
  int Count;
  Bounds Box;
  double Size;
  skdtest::Random Random{ 42 };
  vtkNew<vtkGenericCell> Cell;
  Point At{};
  Point Step{};
  int StepsLeft = 0;
};

/// Whether most cells are volumes, seen from a sample.
bool IsVolume(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfCells();
  vtkNew<vtkGenericCell> cell;
  int volumes = 0;
  int sampled = 0;
  for (vtkIdType id = 0; id < count; id += 1 + count / 100)
  {
    data->GetCell(id, cell);
    volumes += cell->GetCellDimension() == 3;
    ++sampled;
  }
  return 2 * volumes > sampled;
}

}

std::vector<Work> MakeWorks(vtkDataSet* data, int count)
{
  using Q = QueryKind;
  using M = QueryMaker;
  M maker(data, count);
  std::vector<Work> works = {
    maker.Make("closest point, near", Q::ClosestPoint, &M::NearSurface),
    maker.Make("closest point, random in 1.5 x the box", Q::ClosestPoint, &M::InGrownBox),
    maker.Make("closest point, far", Q::ClosestPoint, &M::Far),
    maker.Make("closest point within a radius", Q::ClosestPointWithinRadius, &M::WithRadius),
    maker.Make("first hit, across the box", Q::FirstHit, &M::AcrossBox),
    maker.Make("first hit, short segments", Q::FirstHit, &M::ShortSegment),
    maker.Make("all hits, across the box", Q::AllHits, &M::AcrossBox),
    maker.Make("cells in a small box", Q::CellsInBox, &M::SmallBox),
    maker.Make("cells in a 5% box", Q::CellsInBox, &M::TwentiethBox),
  };
  if (IsVolume(data))
  {
    works.push_back(maker.Make("find cell, random in the box", Q::FindCell, &M::InBox));
    works.push_back(maker.Make("find cell, random in cells", Q::FindCell, &M::InCell));
    works.push_back(maker.Make("find cell, coherent", Q::FindCell, &M::Coherent));
    works.push_back({ "find cell, coherent, hinted", Q::FindCellWithHint, works.back().Queries });
  }
  return works;
}

}
