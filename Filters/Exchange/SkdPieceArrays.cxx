// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceArrays.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdStoredValues.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace skdtree
{
namespace
{
void CopyActiveAttributes(vtkDataSetAttributes* from, vtkDataSetAttributes* into)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int attribute = from->IsArrayAnAttribute(i);
    const char* name = from->GetAbstractArray(i)->GetName();
    if (attribute >= 0 && name && into->HasArray(name))
    {
      into->SetActiveAttribute(name, attribute);
    }
  }
}

/// The bits of duplicates of points and of cells are the same.
void RemoveMarksOfDuplicates(vtkDataSetAttributes* data)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts)
  {
    unsigned char* const marks = ghosts->GetPointer(0);
    std::transform(marks, marks + ghosts->GetNumberOfValues(), marks,
      [](unsigned char mark)
      { return static_cast<unsigned char>(mark & ~vtkDataSetAttributes::DUPLICATECELL); });
  }
}

void AddHidden(vtkDataSet* piece, std::vector<unsigned char>& marked)
{
  const SkdShown shown(piece, vtkDataObject::POINT);
  for (vtkIdType point = 0; shown.MayHide() && point < piece->GetNumberOfPoints(); ++point)
  {
    if (!shown.Has(point))
    {
      marked.resize(static_cast<std::size_t>(piece->GetNumberOfPoints()), 0);
      marked[static_cast<std::size_t>(point)] = 1;
    }
  }
}

/// Marks the points that are only in marked cells.
void AddPointsOfDuplicates(
  vtkDataSet* piece, const std::vector<unsigned char>& cells, std::vector<unsigned char>& points)
{
  if (cells.empty())
  {
    return;
  }
  std::vector<unsigned char> isOnlyIn(static_cast<std::size_t>(piece->GetNumberOfPoints()), 0);
  const SkdCellReader reader(piece);
  vtkNew<vtkIdList> list;
  for (const bool areMarked : { true, false })
  {
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      if ((cells[cell] != 0) == areMarked)
      {
        reader.VisitPoints(static_cast<vtkIdType>(cell), list,
          [&](const auto* ids, std::size_t size)
          {
            std::for_each(ids, ids + size,
              [&](auto id) { isOnlyIn[static_cast<std::size_t>(id)] = areMarked ? 1 : 0; });
          });
      }
    }
  }
  points.resize(isOnlyIn.size(), 0);
  std::transform(points.begin(), points.end(), isOnlyIn.begin(), points.begin(),
    [](unsigned char a, unsigned char b) { return static_cast<unsigned char>(a | b); });
}

void CopyAnyPoints(vtkDataSet* piece, const SkdPieceTuples& tuples, vtkPoints* into)
{
  for (std::size_t i = 0; i < tuples.From.size(); ++i)
  {
    double x[3];
    piece->GetPoint(tuples.From[i], x);
    into->SetPoint(tuples.To[i], x);
  }
}

/// The same without calls for each point, if both are stored in this type; false if they are not.
template <class Real>
bool CopyStoredPoints(vtkDataSet* piece, const SkdPieceTuples& tuples, vtkPoints* into)
{
  auto* set = vtkPointSet::SafeDownCast(piece);
  vtkPoints* points = set ? set->GetPoints() : nullptr;
  const Real* const from = points ? SkdStoredValues<Real>(points->GetData()) : nullptr;
  Real* const to = SkdStoredValues<Real>(into->GetData());
  if (!from || !to)
  {
    return false;
  }
  for (std::size_t i = 0; i < tuples.From.size(); ++i)
  {
    std::copy_n(from + 3 * tuples.From[i], 3, to + 3 * tuples.To[i]);
  }
  return true;
}

int PrecisionOf(const SkdPieces& pieces)
{
  for (vtkDataSet* piece : pieces)
  {
    auto* set = vtkPointSet::SafeDownCast(piece);
    const bool isSingle =
      set && (!set->GetPoints() || set->GetPoints()->GetDataType() == VTK_FLOAT);
    if (!isSingle)
    {
      return VTK_DOUBLE;
    }
  }
  return VTK_FLOAT;
}
}

void SkdJoinArrays(const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, int type,
  vtkIdType number, vtkDataSetAttributes* into)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (vtkDataSet* piece : pieces)
  {
    sets.push_back(piece->GetAttributes(type));
  }
  SkdArrayGather gather(sets, [](vtkAbstractArray*) { return true; });
  gather.Allocate(number);
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    const SkdPieceTuples& own = tuples[set];
    for (std::size_t i = 0; i < own.From.size(); ++i)
    {
      gather.Take(own.To[i], static_cast<int>(set), own.From[i]);
    }
  }
  gather.AddTo(into);
  CopyActiveAttributes(sets.front(), into);
  RemoveMarksOfDuplicates(into);
}

vtkSmartPointer<vtkPoints> SkdJoinPoints(
  const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, vtkIdType number)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(PrecisionOf(pieces));
  points->SetNumberOfPoints(number);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    if (!CopyStoredPoints<double>(pieces[piece], tuples[piece], points) &&
      !CopyStoredPoints<float>(pieces[piece], tuples[piece], points))
    {
      CopyAnyPoints(pieces[piece], tuples[piece], points);
    }
  }
  return points;
}

std::vector<unsigned char> SkdDuplicatesOf(vtkDataSet* piece, int type)
{
  std::vector<unsigned char> marked;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    piece->GetAttributes(type)->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType number =
    ghosts ? std::min(ghosts->GetNumberOfValues(), piece->GetNumberOfElements(type)) : 0;
  for (vtkIdType i = 0; i < number; ++i)
  {
    if (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL)
    {
      marked.resize(static_cast<std::size_t>(piece->GetNumberOfElements(type)), 0);
      marked[static_cast<std::size_t>(i)] = 1;
    }
  }
  return marked;
}

std::vector<unsigned char> SkdIncompleteOf(vtkDataSet* piece, int type)
{
  std::vector<unsigned char> incomplete = SkdDuplicatesOf(piece, type);
  if (type == vtkDataObject::POINT)
  {
    AddPointsOfDuplicates(piece, SkdDuplicatesOf(piece, vtkDataObject::CELL), incomplete);
    AddHidden(piece, incomplete);
  }
  return incomplete;
}

bool SkdHasDuplicates(vtkDataSet* piece)
{
  return !SkdDuplicatesOf(piece, vtkDataObject::POINT).empty() ||
    !SkdDuplicatesOf(piece, vtkDataObject::CELL).empty();
}

bool SkdHasFreePoints(vtkDataSet* mesh)
{
  const SkdCellReader reader(mesh);
  std::vector<unsigned char> isUsed(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> list;
  reader.VisitCells(0, mesh->GetNumberOfCells(), list,
    [&](vtkIdType, const auto* ids, std::size_t size)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        isUsed[static_cast<std::size_t>(ids[i])] = 1;
      }
    });
  return std::find(isUsed.begin(), isUsed.end(), 0) != isUsed.end();
}
}
