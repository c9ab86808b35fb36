// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeSurfaceIntersection.h"

#include "Bodies/SkdOuterSurface.h"
#include "Exchange/SkdFilterInputs.h"
#include "Exchange/SkdTransport.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMotion.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Pipeline/SkdVolumeCells.h"
#include "Solids/Surfaces/SkdContacts.h"
#include "Solids/Surfaces/SkdSplitSurface.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeSurfaceIntersection);

class vtkSkdTreeSurfaceIntersection::Internals
{
public:
  SkdTriangleSet First;
  SkdTriangleSet Second;
  vtkSmartPointer<vtkMatrix4x4> Matrix; // nullptr: none
  bool HasVolumePieces = false;         // the Input lies in pieces, some with volume cells
};

namespace
{
/// An input of the filter: its blocks, and its triangles with their tree.
struct Surface
{
  std::vector<SkdBlock> Blocks;
  bool IsComposite;
  SkdTriangleSet& Set;
  bool IsNew;

  /// With processes, each has a piece of it.
  Surface(vtkDataObject* data, SkdTriangleSet& set, double chordalDeviation,
    const skd::Processes* processes = nullptr)
    : Blocks(SkdBlocksOf(data))
    , IsComposite(SkdIsComposite(data))
    , Set(set)
    , IsNew(set.Update(this->Blocks, chordalDeviation, processes))
  {
  }
};

/// Whether both surfaces get whole trees: those that are searched again do. For others only
/// triangles near each other are used, unless most belong to surfaces with a tree.
bool DoTreesPay(const Surface& first, const Surface& second)
{
  std::size_t all = 0;
  std::size_t unsorted = 0;
  for (const Surface* surface : { &first, &second })
  {
    const std::size_t triangles = surface->Set.GetTriangles().size();
    all += triangles;
    unsorted += surface->IsNew && !surface->Set.IsComplete() ? triangles : 0;
  }
  constexpr std::size_t gain = 16; // to look at a triangle, compared with sorting it into a tree
  return all >= gain * unsorted;
}

SkdPlacement Complete(
  const Surface& first, const Surface* second, const std::optional<skd::RigidMotion>& motion)
{
  first.Set.Complete();
  if (second)
  {
    second->Set.Complete();
  }
  return SkdMakePlacement(first.Set, second ? &second->Set : nullptr, motion);
}

/// Ports 0 to 5, where every process has found all.
void KeepShare(const SkdShare& share, vtkInformationVector* outputs)
{
  share.Keep(vtkTable::GetData(outputs, 2));
  for (const int port : { 0, 1, 3, 4, 5 })
  {
    share.Keep(vtkPolyData::GetData(outputs, port));
  }
}

/// `second` is nullptr when there is but one.
void WarnOfFaces(vtkSkdTreeSurfaceIntersection* self, const Surface& first, const Surface* second)
{
  const auto warn = [self](const Surface& surface, const char* name)
  {
    if (surface.Set.GetTriangles().empty())
    {
      vtkWarningWithObjectMacro(self, << name << " has no faces; there are no intersections.");
    }
  };
  warn(first, "Input");
  if (second)
  {
    warn(*second, "Source");
  }
  SkdWarnAboutCoarseFaces(self,
    first.Set.GetNumberOfCoarseFaces() + (second ? second->Set.GetNumberOfCoarseFaces() : 0),
    self->GetChordalDeviation());
}

/// What meets, and where the surfaces are.
struct Contacts
{
  SkdPlacement Placement;
  std::vector<SkdTrianglePair> Pairs;
  bool AreCopiesLeftOut = false;
};

/// `second` is nullptr when there is but one.
Contacts FindPairs(vtkSkdTreeSurfaceIntersection* self, const Surface& first, const Surface* second,
  const std::optional<skd::RigidMotion>& motion)
{
  SkdLoop loop(self, 0, 0.4, 0.8, 8);
  const double clearance = self->GetClearance();
  const SkdPairSearch search{ static_cast<SkdPairSearch::Extent>(self->GetPairs()), clearance };
  if (second && !self->GetSplitSurfaces() && !DoTreesPay(first, *second))
  {
    for (const Surface* surface : { &first, second })
    {
      if (!surface->IsNew)
      {
        surface->Set.Complete();
      }
    }
    Contacts contacts{ SkdMakePlacement(first.Set, &second->Set, motion), {} };
    const auto near = SkdFindNear(contacts.Placement, clearance * contacts.Placement.Scale);
    auto pairs = near ? SkdTrianglePairs(contacts.Placement).FindByPackedRTree(*near, search, loop)
                      : std::nullopt;
    if (pairs)
    {
      contacts.Pairs = *std::move(pairs);
      contacts.AreCopiesLeftOut = near->HasCopies;
      first.Set.MakeCornersOne(SkdTrianglesInPairs(contacts.Pairs, &SkdTrianglePair::First));
      second->Set.MakeCornersOne(SkdTrianglesInPairs(contacts.Pairs, &SkdTrianglePair::Second));
      return contacts;
    }
  }
  if (!second && clearance == 0.0 && !first.Set.IsComplete())
  {
    const bool hasCopies = !first.Set.LeaveOutCopies(SkdManyCopies).empty();
    Contacts contacts{ SkdMakePlacement(first.Set, nullptr, motion), {}, hasCopies };
    if (auto pairs = SkdTrianglePairs(contacts.Placement).FindSelfIntersections(search, loop))
    {
      contacts.Pairs = *std::move(pairs);
      return contacts;
    }
  }
  Contacts contacts{ Complete(first, second, motion), {} };
  contacts.Pairs = SkdTrianglePairs(contacts.Placement).FindByTrees(search, loop);
  contacts.AreCopiesLeftOut =
    !first.Set.GetCopiesLeftOut().empty() || (second && !second->Set.GetCopiesLeftOut().empty());
  return contacts;
}

void WarnOfCopies(vtkSkdTreeSurfaceIntersection* self, bool areLeftOut)
{
  if (areLeftOut)
  {
    vtkWarningWithObjectMacro(self,
      "Some triangles are there more than "
        << SkdManyCopies << " times. Of each the first " << SkdManyCopies
        << " are used, the others are left out. Remove cells that are there several times.");
  }
}

/// Ports 0 to 3.
void FillContacts(const SkdContacts& contacts, bool areCurvesJoined, SkdTransport* transport,
  vtkInformationVector* outputs, SkdReport& report)
{
  vtkTable* table = vtkTable::GetData(outputs, 2);
  report.AddCount(
    "Curves", contacts.FillCurves(vtkPolyData::GetData(outputs, 0), areCurvesJoined, transport));
  report.AddCount("Overlaps", contacts.FillOverlaps(vtkPolyData::GetData(outputs, 1)));
  contacts.FillPairs(table, vtkPolyData::GetData(outputs, 3));
  report.AddCount("Pairs", table->GetNumberOfRows());
}

/// Ports 4 and 5.
struct SplitOutput
{
  vtkSkdTreeSurfaceIntersection* Self;
  const SkdSplitSegments& Segments;
  double Scale;
  SkdReport& Report;

  /// `surface` is nullptr of a Source that is not there.
  void Fill(int side, const Surface* surface, vtkPolyData* output) const
  {
    if (!surface)
    {
      return;
    }
    std::set<std::string> refused;
    SkdLoop loop(this->Self, 0, 0.8 + 0.1 * side, 0.9 + 0.1 * side, 64);
    const vtkIdType count = SkdFillSplitSurface(this->Segments, side, surface->Blocks,
      surface->IsComposite, this->Scale, output, refused, loop);
    this->Report.AddCount(side == 0 ? "InputTrianglesSplit" : "SourceTrianglesSplit", count);
    SkdWarnAboutRefused(this->Self, refused);
  }

  void FillBoth(const Surface& first, const Surface* second, vtkInformationVector* outputs) const
  {
    this->Fill(0, &first, vtkPolyData::GetData(outputs, 4));
    this->Fill(1, second, vtkPolyData::GetData(outputs, 5));
  }
};

/// `second` is nullptr when there is but one.
void ReportSurfaces(
  SkdReport& report, const Surface& first, const Surface* second, const SkdPlacement& placement)
{
  const auto sum = [&](const auto& count)
  { return static_cast<vtkIdType>(count(first) + (second ? count(*second) : 0)); };
  report.AddCount("Triangles", sum([](const Surface& s) { return s.Set.GetTriangles().size(); }));
  report.AddCount(
    "FacesLeftOut", sum([](const Surface& s) { return s.Set.GetNumberOfFacesLeftOut(); }));
  report.AddCount("TrianglesWithoutArea", placement.CountWithoutArea());
  report.AddCount("TreesBuilt", sum([](const Surface& s) { return s.IsNew; }));
  const double length = first.Set.GetChordalLength();
  report.AddMeasureOf(
    "ChordalLength", second ? std::max(length, second->Set.GetChordalLength()) : length);
}
}

vtkSkdTreeSurfaceIntersection::vtkSkdTreeSurfaceIntersection()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Optional,
      { VTK_POLY_DATA, VTK_POLY_DATA, VTK_TABLE, VTK_POLY_DATA, VTK_POLY_DATA, VTK_POLY_DATA })
  , Impl(new Internals)
{
  this->AnyMagnitude = true;
}

vtkSkdTreeSurfaceIntersection::~vtkSkdTreeSurfaceIntersection() = default;

void vtkSkdTreeSurfaceIntersection::SetTransform(vtkMatrix4x4* motion)
{
  SkdSetTransform(this, motion, this->Impl->Matrix);
}

vtkMatrix4x4* vtkSkdTreeSurfaceIntersection::GetTransform()
{
  return this->Impl->Matrix;
}

bool vtkSkdTreeSurfaceIntersection::IsSplitting() const
{
  return this->SplitSurfaces && this->Pairs == ALL_PAIRS;
}

vtkTypeBool vtkSkdTreeSurfaceIntersection::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    const auto processes = SkdProcessesOf(outputVector->GetInformationObject(0));
    this->Impl->HasVolumePieces = processes &&
      processes->IsAny(SkdHasVolumeCells(SkdBlocksOf(vtkDataObject::GetData(inputVector[0]))));
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

// What the Source is cut along is where it meets all of the Input, and which faces of volume cells
// are outer ones depends on the cells of other pieces.
bool vtkSkdTreeSurfaceIntersection::NeedsWhole(int port)
{
  // One pair of all processes is wanted, not one of each.
  return this->Pairs != ALL_PAIRS || this->IsSplitting() || this->Impl->HasVolumePieces ||
    this->Superclass::NeedsWhole(port);
}

// Which of several pairs is found may depend on others, and a Source that moves is elsewhere.
bool vtkSkdTreeSurfaceIntersection::NeedsNearbySource(SkdSearchRange& range)
{
  range.Distance = this->Clearance;
  range.OfDiagonal = 1e-3; // more than any rounding
  range.IsOfOuterFaces = true;
  return this->Pairs == ALL_PAIRS && SkdMotionOf(this)->IsIdentity();
}

int vtkSkdTreeSurfaceIntersection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkInformation* output = outputVector->GetInformationObject(0);
  if (!source && SkdIsLaterPiece(output))
  {
    return 1; // the first piece has all
  }
  const vtkSmartPointer<vtkMatrix4x4> matrix = SkdMotionOf(this);
  const auto motion = skd::RigidMotion::FromMatrix(&matrix->Element[0][0]);
  if (source && !motion)
  {
    vtkErrorMacro("Translation, Rotation and RotationCenter must be finite; there is no output.");
    return 1;
  }

  SkdStopwatch watch;
  const auto processes = source ? SkdProcessesOf(output) : nullptr;
  const Surface first(vtkDataObject::GetData(inputVector[0]), this->Impl->First,
    this->ChordalDeviation, processes.get());
  this->UpdateProgress(0.2);
  const Surface other(source, this->Impl->Second, this->ChordalDeviation);
  const Surface& second = source ? other : first;
  this->UpdateProgress(0.4);
  WarnOfFaces(this, first, source ? &other : nullptr);
  SkdReport report(vtkPolyData::GetData(outputVector, 0));
  report.AddMeasure("BuildSeconds", watch.Lap());

  const auto [placement, pairs, areCopiesLeftOut] = FindPairs(this, first,
    source ? &other : nullptr, source && !matrix->IsIdentity() ? motion : std::nullopt);
  SkdWarnAboutTinyPoints(this, placement);
  WarnOfCopies(this, areCopiesLeftOut);
  const std::unique_ptr<SkdTransport> transport = // between pieces of the Input
    source && !this->NeedsWhole(0) ? SkdMakeTransport(SkdControllerOf(output)) : nullptr;
  const SkdContacts contacts(
    { first.Blocks, first.IsComposite, this->Inputs->FindIds(output, transport.get()) },
    { second.Blocks, second.IsComposite, {} }, placement, pairs);
  FillContacts(contacts, this->JoinCurves, transport.get(), outputVector, report);
  if (transport)
  {
    this->Inputs->AddTraffic(transport->GetTraffic());
  }
  if (this->IsSplitting())
  {
    const SkdSplitSegments segments(placement, pairs, contacts.GetPoints());
    SplitOutput{ this, segments, placement.Scale, report }.FillBoth(
      first, source ? &other : nullptr, outputVector);
  }
  if (source && this->NeedsWhole(0))
  {
    KeepShare(SkdShare::Of(outputVector), outputVector);
  }
  report.AddMeasure("QuerySeconds", watch.Lap());
  ReportSurfaces(report, first, source ? &other : nullptr, placement);
  return 1;
}

void vtkSkdTreeSurfaceIntersection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Pairs", this->Pairs, "JoinCurves", this->JoinCurves, "SplitSurfaces",
    this->SplitSurfaces, "Clearance", this->Clearance, "ChordalDeviation", this->ChordalDeviation,
    "Translation", this->Translation, "Rotation", this->Rotation, "RotationCenter",
    this->RotationCenter, "Transform", this->Impl->Matrix ? "set" : "none");
}
VTK_ABI_NAMESPACE_END
