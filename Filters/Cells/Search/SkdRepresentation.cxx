// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdRepresentation.h"

#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Cells/LinearShapes.h"
#include "Core/Search/Tree/PaperTree.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Collects boxes as polydata.
class BoxPicture
{
public:
  explicit BoxPicture(const skd::RigidMotion* motion)
    : Motion(motion)
  {
    this->Points->SetDataTypeToDouble();
    this->Levels->SetName("Level");
    this->CellIds->SetName("CellId");
  }

  void Add(const skd::Box3& box, int level, vtkIdType cellId)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int corner = 0; corner < 8; ++corner)
    {
      skd::Vector3 point;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = (corner >> axis) & 1 ? box.Max[axis] : box.Min[axis];
      }
      this->Points->InsertNextPoint((this->Motion ? this->Motion->Forward(point) : point).X);
    }
    for (const auto& face : skd::Voxel::Faces)
    {
      const vtkIdType quad[4] = { first + face[0], first + face[1], first + face[2],
        first + face[3] };
      this->Quads->InsertNextCell(4, quad);
      this->Levels->InsertNextValue(level);
      this->CellIds->InsertNextValue(cellId);
    }
  }

  void Store(vtkPolyData* output)
  {
    output->Initialize();
    output->SetPoints(this->Points);
    output->SetPolys(this->Quads);
    output->GetCellData()->AddArray(this->Levels);
    output->GetCellData()->AddArray(this->CellIds);
  }

private:
  const skd::RigidMotion* Motion;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Quads;
  vtkNew<vtkIntArray> Levels;
  vtkNew<vtkIdTypeArray> CellIds;
};
}

//------------------------------------------------------------------------------
void SkdCopySafetyBoxes(const SkdCellTree& tree, vtkDoubleArray* S)
{
  const skd::PaperTree<3> paper = tree.MakePaperTree();
  S->SetNumberOfComponents(6);
  S->SetNumberOfTuples(static_cast<vtkIdType>(paper.S.size()));
  for (std::size_t node = 0; node < paper.S.size(); ++node)
  {
    const skd::Box3& box = paper.S[node];
    const double bounds[6] = { box.Min[0], box.Max[0], box.Min[1], box.Max[1], box.Min[2],
      box.Max[2] };
    S->SetTypedTuple(static_cast<vtkIdType>(node), bounds);
  }
}

//------------------------------------------------------------------------------
void SkdCopyLinks(const SkdCellTree& tree, vtkIdTypeArray* L)
{
  const skd::PaperTree<3> paper = tree.MakePaperTree();
  L->SetNumberOfComponents(1);
  L->SetNumberOfTuples(static_cast<vtkIdType>(paper.L.size()));
  for (std::size_t node = 0; node < paper.L.size(); ++node)
  {
    const vtkIdType link = paper.IsLeaf(node)
      ? -tree.Cells().IdOf(static_cast<std::uint32_t>(-paper.L[node]))
      : static_cast<vtkIdType>(paper.L[node]);
    L->SetValue(static_cast<vtkIdType>(node), link);
  }
}

//------------------------------------------------------------------------------
void SkdRepresent(
  const SkdCellTree& tree, int level, const skd::RigidMotion* motion, vtkPolyData* output)
{
  const skd::PaperTree<3> paper = tree.MakePaperTree();
  const auto deepest = std::max_element(paper.Level.begin(), paper.Level.end());
  const bool wantsLeaves = level < 0 || paper.Level.empty() || level > *deepest;
  BoxPicture picture(motion);
  for (std::size_t node = 0; node < paper.S.size(); ++node)
  {
    const bool isLeaf = paper.IsLeaf(node);
    if (wantsLeaves ? isLeaf : paper.Level[node] == level)
    {
      const vtkIdType cellId =
        isLeaf ? tree.Cells().IdOf(static_cast<std::uint32_t>(-paper.L[node])) : -1;
      picture.Add(paper.S[node], paper.Level[node], cellId);
    }
  }
  picture.Store(output);
}
}
