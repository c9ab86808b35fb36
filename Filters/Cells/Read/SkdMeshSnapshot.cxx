// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdMeshSnapshot.h"

#include "Cells/Read/SkdMeshChecksum.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArrayRange.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSkdTreeVersion.h"
#include "vtkStructuredGrid.h"
#include "vtkTimeStamp.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>

namespace skdtree
{
namespace
{
/// Also of arrays that compute their values, as of cells that are all of one type.
bool AreEqualOneByOne(vtkDataArray* a, vtkDataArray* b)
{
  const auto valuesA = vtk::DataArrayValueRange(a);
  const auto valuesB = vtk::DataArrayValueRange(b);
  return std::equal(valuesA.begin(), valuesA.end(), valuesB.begin(), valuesB.end());
}

struct EqualValues
{
  bool Equal = false;

  template <typename ArrayA, typename ArrayB>
  void operator()(ArrayA* a, ArrayB* b)
  {
    const auto valuesA = vtk::DataArrayValueRange(a);
    const auto valuesB = vtk::DataArrayValueRange(b);
    this->Equal = std::equal(valuesA.begin(), valuesA.end(), valuesB.begin(), valuesB.end());
  }
};

/// Compares the parts of two data sets; the first was kept at `Time`.
class Comparison
{
public:
  explicit Comparison(vtkMTimeType time)
    : Time(time)
  {
  }

  bool SameArrays(vtkDataArray* stored, vtkDataArray* now) const
  {
    if (!stored || !now)
    {
      return stored == now;
    }
    if (this->IsModified(stored))
    {
      return false;
    }
    if (stored == now)
    {
      return true;
    }
    if (stored->GetDataType() != now->GetDataType() ||
      stored->GetNumberOfComponents() != now->GetNumberOfComponents())
    {
      return false;
    }
    EqualValues equal;
    return vtkArrayDispatch::Dispatch2SameValueType::Execute(stored, now, equal)
      ? equal.Equal
      : AreEqualOneByOne(stored, now);
  }

  bool SamePoints(vtkPoints* stored, vtkPoints* now) const
  {
    if (!stored || !now)
    {
      return stored == now;
    }
    return !this->IsModified(stored) && this->SameArrays(stored->GetData(), now->GetData());
  }

  bool SameCells(vtkCellArray* stored, vtkCellArray* now) const
  {
    if (!stored || !now)
    {
      return stored == now;
    }
    if (stored->GetNumberOfCells() == 0 && now->GetNumberOfCells() == 0)
    {
      return true; // vtkPolyData has one empty array for all, of whatever time
    }
    return !this->IsModified(stored) &&
      this->SameArrays(stored->GetOffsetsArray(), now->GetOffsetsArray()) &&
      this->SameArrays(stored->GetConnectivityArray(), now->GetConnectivityArray());
  }

  bool SameShaping(vtkDataSetAttributes* stored, vtkDataSetAttributes* now) const
  {
    const char* ghosts = vtkDataSetAttributes::GhostArrayName();
    return this->SameArrays(stored->GetArray(ghosts), now->GetArray(ghosts)) &&
      this->SameArrays(stored->GetRationalWeights(), now->GetRationalWeights()) &&
      this->SameArrays(stored->GetHigherOrderDegrees(), now->GetHigherOrderDegrees());
  }

  bool SameStructure(vtkDataSet* stored, vtkDataSet* now) const;

private:
  /// Whoever shares what was kept has changed it in place.
  bool IsModified(vtkObject* stored) const { return stored->GetMTime() > this->Time; }
  bool SameGrid(vtkUnstructuredGrid* stored, vtkUnstructuredGrid* now) const;
  bool SameImage(vtkImageData* stored, vtkImageData* now) const;

  vtkMTimeType Time;
};

bool HasPolyhedra(vtkDataArray* types)
{
  const auto values = vtk::DataArrayValueRange<1>(types);
  return std::find(values.begin(), values.end(), VTK_POLYHEDRON) != values.end();
}

template <typename Grid>
bool SameExtent(Grid* stored, Grid* now)
{
  return std::equal(stored->GetExtent(), stored->GetExtent() + 6, now->GetExtent());
}

// The arrays of faces of polyhedra differ between versions of VTK. They are set together with the
// cells, so comparing the cells' own array is sufficient.
bool Comparison::SameGrid(vtkUnstructuredGrid* stored, vtkUnstructuredGrid* now) const
{
  vtkDataArray* types = now->VTK_SKD_GET_CELL_TYPES();
  if (!this->SamePoints(stored->GetPoints(), now->GetPoints()) ||
    !this->SameCells(stored->GetCells(), now->GetCells()) ||
    !this->SameArrays(stored->VTK_SKD_GET_CELL_TYPES(), types))
  {
    return false;
  }
  return stored->GetCells() == now->GetCells() || !types || !HasPolyhedra(types);
}

bool Comparison::SameImage(vtkImageData* stored, vtkImageData* now) const
{
  const double* direction = stored->GetDirectionMatrix()->GetData();
  return SameExtent(stored, now) &&
    std::equal(stored->GetOrigin(), stored->GetOrigin() + 3, now->GetOrigin()) &&
    std::equal(stored->GetSpacing(), stored->GetSpacing() + 3, now->GetSpacing()) &&
    std::equal(direction, direction + 9, now->GetDirectionMatrix()->GetData());
}

bool Comparison::SameStructure(vtkDataSet* stored, vtkDataSet* now) const
{
  if (auto mesh = vtkPolyData::SafeDownCast(now))
  {
    auto former = vtkPolyData::SafeDownCast(stored);
    return this->SamePoints(former->GetPoints(), mesh->GetPoints()) &&
      this->SameCells(former->GetVerts(), mesh->GetVerts()) &&
      this->SameCells(former->GetLines(), mesh->GetLines()) &&
      this->SameCells(former->GetPolys(), mesh->GetPolys()) &&
      this->SameCells(former->GetStrips(), mesh->GetStrips());
  }
  if (auto grid = vtkUnstructuredGrid::SafeDownCast(now))
  {
    return this->SameGrid(vtkUnstructuredGrid::SafeDownCast(stored), grid);
  }
  if (auto image = vtkImageData::SafeDownCast(now))
  {
    return this->SameImage(vtkImageData::SafeDownCast(stored), image);
  }
  if (auto grid = vtkRectilinearGrid::SafeDownCast(now))
  {
    auto former = vtkRectilinearGrid::SafeDownCast(stored);
    return SameExtent(former, grid) &&
      this->SameArrays(former->GetXCoordinates(), grid->GetXCoordinates()) &&
      this->SameArrays(former->GetYCoordinates(), grid->GetYCoordinates()) &&
      this->SameArrays(former->GetZCoordinates(), grid->GetZCoordinates());
  }
  if (auto grid = vtkStructuredGrid::SafeDownCast(now))
  {
    auto former = vtkStructuredGrid::SafeDownCast(stored);
    return SameExtent(former, grid) && this->SamePoints(former->GetPoints(), grid->GetPoints());
  }
  if (auto grid = vtkExplicitStructuredGrid::SafeDownCast(now))
  {
    auto former = vtkExplicitStructuredGrid::SafeDownCast(stored);
    return SameExtent(former, grid) && this->SamePoints(former->GetPoints(), grid->GetPoints()) &&
      this->SameCells(former->GetCells(), grid->GetCells());
  }
  return false;
}

// The few attributes that say which cells there are and what shape they have.
void CopyShaping(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  to->AddArray(from->GetArray(vtkDataSetAttributes::GhostArrayName()));
  to->SetRationalWeights(from->GetRationalWeights());
  to->SetHigherOrderDegrees(from->GetHigherOrderDegrees());
}
}

void SkdMeshSnapshot::Keep(vtkDataSet* mesh)
{
  this->KeepArrays(mesh);
  this->Checksum = SkdMeshChecksum(mesh);
}

void SkdMeshSnapshot::KeepArrays(vtkDataSet* mesh)
{
  this->Mesh.TakeReference(mesh->NewInstance());
  this->Mesh->CopyStructure(mesh);
  CopyShaping(mesh->GetCellData(), this->Mesh->GetCellData());
  CopyShaping(mesh->GetPointData(), this->Mesh->GetPointData());
  this->Checksum.reset();
  vtkTimeStamp now;
  now.Modified();
  this->Time = now.GetMTime();
}

bool SkdMeshSnapshot::IsSameAs(vtkDataSet* mesh) const
{
  const Comparison comparison(this->Time);
  const bool isSame = this->Mesh &&
    std::strcmp(this->Mesh->GetClassName(), mesh->GetClassName()) == 0 &&
    comparison.SameShaping(this->Mesh->GetCellData(), mesh->GetCellData()) &&
    comparison.SameShaping(this->Mesh->GetPointData(), mesh->GetPointData()) &&
    comparison.SameStructure(this->Mesh, mesh);
  const bool isWatched = this->Checksum && mesh->GetMTime() > this->Time;
  return isSame && (!isWatched || SkdMeshChecksum(mesh) == *this->Checksum);
}
}
