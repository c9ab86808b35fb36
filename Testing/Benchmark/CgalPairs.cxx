// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs.h"
#include "Triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

namespace skdbench
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A box that knows its cell.
class CellBox
  : public CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>
{
public:
  CellBox(vtkIdType cell, const CGAL::Bbox_3& box)
    : Box_d(box)
    , Cell(cell)
  {
  }

  vtkIdType Cell;
};

std::vector<CellBox> BoxesOf(vtkDataSet* data)
{
  std::vector<CellBox> boxes;
  boxes.reserve(static_cast<std::size_t>(data->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    double b[6];
    data->GetCellBounds(cell, b);
    boxes.emplace_back(cell, CGAL::Bbox_3(b[0], b[2], b[4], b[1], b[3], b[5]));
  }
  return boxes;
}

std::vector<Kernel::Triangle_3> CgalTrianglesOf(vtkDataSet* data)
{
  const auto point = [](const skdtest::Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  std::vector<Kernel::Triangle_3> triangles;
  for (const Corners& corners : TrianglesOf(data).value_or(std::vector<Corners>()))
  {
    triangles.emplace_back(point(corners.A), point(corners.B), point(corners.C));
  }
  return triangles;
}

/// Sorts and sweeps without a tree: Build only reads the boxes.
class CgalPairs : public PairFinder
{
public:
  bool Build(vtkDataSet* first, vtkDataSet* second) override
  {
    this->First = BoxesOf(first);
    this->Second = BoxesOf(second);
    return true;
  }

  bool FindBoxes() override
  {
    this->Boxes.clear();
    Run(this->First, this->Second,
      [&](const CellBox& a, const CellBox& b) { this->Boxes.emplace_back(a.Cell, b.Cell); });
    return true;
  }

  PairList BoxPairs() const override { return this->Boxes; }

  bool FindTriangles(vtkDataSet* first, vtkDataSet* second) override
  {
    const std::vector<Kernel::Triangle_3> here = CgalTrianglesOf(first);
    const std::vector<Kernel::Triangle_3> there = CgalTrianglesOf(second);
    std::vector<CellBox> boxesHere = BoxesOf(first);
    std::vector<CellBox> boxesThere = BoxesOf(second);
    this->Contacts.clear();
    Run(boxesHere, boxesThere,
      [&](const CellBox& a, const CellBox& b)
      {
        if (CGAL::do_intersect(here[a.Cell], there[b.Cell]))
        {
          this->Contacts.emplace_back(a.Cell, b.Cell);
        }
      });
    return true;
  }

  PairList TrianglePairs() const override { return this->Contacts; }

private:
  template <class Take>
  static void Run(std::vector<CellBox>& first, std::vector<CellBox>& second, const Take& take)
  {
    CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(), take);
  }

  std::vector<CellBox> First;
  std::vector<CellBox> Second;
  PairList Boxes;
  PairList Contacts;
};

}

PairKind CgalPairKind()
{
  return { "CGAL box_intersection_d", Family::Peer,
    []() -> std::unique_ptr<PairFinder> { return std::make_unique<CgalPairs>(); } };
}

}
