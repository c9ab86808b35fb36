// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanOutputs.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace skdtree
{
namespace
{
/// Surfaces that become one data set, no point of which is in two of them.
class Surfaces
{
public:
  /// The array of part ids is added if `part` is not negative.
  void Add(vtkPolyData* surface, int part)
  {
    const vtkIdType n = surface->GetNumberOfCells();
    if (n == 0)
    {
      return;
    }
    if (part >= 0)
    {
      auto parts = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Part, 1, n);
      parts->FillValue(part);
      surface->GetCellData()->AddArray(parts);
    }
    this->NumberFacesApart(surface);
    this->Append->AddInputData(surface);
    this->Last = surface;
    ++this->Count;
  }

  void MoveTo(vtkPolyData* output)
  {
    if (this->Count > 1)
    {
      this->Append->Update();
      this->Last = this->Append->GetOutput();
    }
    if (this->Count > 0)
    {
      output->ShallowCopy(this->Last);
    }
  }

private:
  /// Faces of two surfaces have no number in common.
  void NumberFacesApart(vtkPolyData* surface)
  {
    auto* faces =
      vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetAbstractArray(SkdBooleanNames::Face));
    const vtkIdType before = this->Faces;
    for (vtkIdType i = 0; faces && i < faces->GetNumberOfTuples(); ++i)
    {
      faces->SetValue(i, faces->GetValue(i) + before);
      this->Faces = std::max(this->Faces, faces->GetValue(i) + 1);
    }
  }

  vtkNew<vtkAppendPolyData> Append;
  vtkSmartPointer<vtkPolyData> Last;
  int Count = 0;
  vtkIdType Faces = 0;
};

class Outputs
{
public:
  Outputs(SkdSolidArrangement& solids, const SkdBooleanBlocks& blocks, const SkdBooleanRule& rule,
    const SkdBooleanOptions& options, std::set<std::string>& refused)
    : Solids(solids)
    , Blocks(blocks)
    , Rule(rule)
    , Options(options)
    , Refused(refused)
    , HasSection(rule.Operation == SkdBooleanOperation::Split ? solids.AreSolidsInputs()
                                                              : this->IsCutByASheet())
  {
  }

  SkdBooleanTotals Fill(vtkPolyData* surface, vtkPolyData* section)
  {
    if (this->Rule.Operation == SkdBooleanOperation::Split)
    {
      this->FillParts(surface);
    }
    else
    {
      this->FillOne(surface);
    }
    this->Sections.MoveTo(section);
    return std::move(this->Totals);
  }

private:
  bool IsCutByASheet() const
  {
    return (this->Rule.HasSheet || this->Options.IsCutByPlane) &&
      (this->Rule.Operation == SkdBooleanOperation::Difference ||
        this->Rule.Operation == SkdBooleanOperation::Intersection);
  }

  void FillParts(vtkPolyData* surface)
  {
    Surfaces parts;
    const int count = this->Solids.CountParts(this->Rule);
    for (this->Rule.Part = 0; this->Rule.Part < count; ++this->Rule.Part)
    {
      vtkNew<vtkPolyData> part;
      this->FillOne(part);
      parts.Add(part, this->Rule.Part);
    }
    parts.MoveTo(surface);
  }

  /// Fills a surface and adds its part of the section, which has the same points.
  void FillOne(vtkPolyData* surface)
  {
    const SkdBooleanBoundary boundary =
      this->Solids.Select(this->Rule, this->Options.ClosesCut, this->Options.JoinsPieces);
    this->FillFrom(boundary, false, surface);
    this->Totals.Add(this->Solids, this->Rule, boundary);
    if (!this->HasSection ||
      (this->Rule.Operation == SkdBooleanOperation::Split && this->Rule.Part == 0))
    {
      return;
    }
    SkdBooleanBoundary section = this->Options.ClosesCut
      ? boundary
      : this->Solids.Select(this->Rule, true, this->Options.JoinsPieces);
    section.GetSigns() = this->Solids.FindSection(section, this->Rule);
    vtkNew<vtkPolyData> found;
    this->FillFrom(section, true, found);
    this->Sections.Add(found, -1);
  }

  void FillFrom(const SkdBooleanBoundary& boundary, bool isSection, vtkPolyData* to)
  {
    const SkdBooleanOptions& options = this->Options;
    SkdFillBooleanSurface({ this->Solids, this->Blocks, this->Rule, boundary, options.KeepsPolygons,
                            options.JoinsPieces, options.MergesPieces, isSection },
      to, this->Refused);
  }

  SkdSolidArrangement& Solids;
  const SkdBooleanBlocks& Blocks;
  SkdBooleanRule Rule;
  const SkdBooleanOptions& Options;
  std::set<std::string>& Refused;
  const bool HasSection;
  Surfaces Sections;
  SkdBooleanTotals Totals;
};
}

SkdBooleanTotals SkdFillBooleanOutputs(SkdSolidArrangement& solids, const SkdBooleanBlocks& blocks,
  const SkdBooleanRule& rule, const SkdBooleanOptions& options, vtkPolyData* surface,
  vtkPolyData* section, std::set<std::string>& refused)
{
  return Outputs(solids, blocks, rule, options, refused).Fill(surface, section);
}
}
