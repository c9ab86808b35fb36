// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structure.h"

#include "vtkDataSet.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace skdbench
{
namespace
{

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using CornerBox = bg::model::box<Corner>;
using Entry = std::pair<CornerBox, vtkIdType>;

CornerBox BoxOf(const Bounds& b)
{
  return { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
}

/// Cells' bounds in a packed R-tree of 8 entries a node.
class BoostStructure : public Structure
{
public:
  bool Build(vtkDataSet* data) override
  {
    std::vector<Entry> entries;
    entries.reserve(data->GetNumberOfCells());
    for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
    {
      Bounds bounds;
      data->GetCellBounds(id, bounds.data());
      entries.emplace_back(BoxOf(bounds), id);
    }
    this->Tree = RTree(entries); // the constructor that packs
    return true;
  }

  bool Ask(QueryKind queryKind, const Query& query, Answer& answer) override
  {
    if (queryKind != QueryKind::CellsInBox)
    {
      return false;
    }
    this->Ids.clear();
    this->Tree.query(bgi::intersects(BoxOf(query.Box)),
      boost::make_function_output_iterator(
        [this](const Entry& entry) { this->Ids.push_back(entry.second); }));
    answer.Cells = this->Ids.data();
    answer.NumberOfCells = static_cast<vtkIdType>(this->Ids.size());
    return true;
  }

private:
  using RTree = bgi::rtree<Entry, bgi::linear<8>>;

  RTree Tree;
  std::vector<vtkIdType> Ids;
};

}

std::vector<Kind> BoostKinds()
{
  return { { "Boost R-tree", Family::Peer, [] { return std::make_unique<BoostStructure>(); } } };
}

}
