// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdSurfaceSides.h"

#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Polygons/PolygonPlane.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
constexpr vtkIdType MostCells = 4096;

/// The first triangle of a cell: its corner that is first, its middle and its normal, as long as
/// twice the area. Strips and curved cells begin with three corners, too.
struct FirstTriangle
{
  skd::Vector3 Middle{ { 0.0, 0.0, 0.0 } };
  skd::Vector3 Normal{ { 0.0, 0.0, 0.0 } };

  FirstTriangle(vtkDataSet* mesh, vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    if (ids->GetNumberOfIds() >= 3)
    {
      skd::Vector3 x[3];
      for (int i = 0; i < 3; ++i)
      {
        mesh->GetPoint(ids->GetId(i), x[i].X);
      }
      this->Middle = (1.0 / 3.0) * (x[0] + (x[1] + x[2]));
      this->Normal = Cross(x[1] - x[0], x[2] - x[0]);
    }
  }
};
}

//------------------------------------------------------------------------------
int SkdSideVotes::GetSide() const
{
  const double most = (1.0 - remap_tolerances::OtherSide) * (this->Alike + this->Opposite);
  return !(most > 0.0) ? 0 : this->Alike >= most ? 1 : this->Opposite >= most ? -1 : 0;
}

//------------------------------------------------------------------------------
SkdSideVotes SkdCountSides(vtkDataSet* donor, vtkDataSet* target)
{
  SkdSideVotes votes;
  const SkdCellTree tree(donor, SkdTreeSettings());
  vtkNew<vtkGenericCell> scratch;
  const vtkIdType cells = target->GetNumberOfCells();
  const vtkIdType step = 1 + cells / MostCells;
  const std::vector<unsigned char> own = SkdOwnCellsOf(target);
  for (vtkIdType cell = 0; cell < cells; cell += step)
  {
    const FirstTriangle here(target, cell);
    const bool counts = own.empty() || own[static_cast<std::size_t>(cell)];
    const double area = counts ? 0.5 * Norm(here.Normal) : 0.0;
    if (!(area > 0.0))
    {
      continue;
    }
    const SkdFoundCell nearest =
      tree.FindNearest(here.Middle, std::numeric_limits<double>::infinity(), { donor, scratch });
    if (nearest.Id >= 0)
    {
      const double alike = Dot(here.Normal, FirstTriangle(donor, nearest.Id).Normal);
      votes.Alike += alike > 0.0 ? area : 0.0;
      votes.Opposite += alike < 0.0 ? area : 0.0;
    }
  }
  return votes;
}
}
