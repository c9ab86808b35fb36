// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_spatial_benchmark [cells]: the warped cells that meet, or are in, a box and a sphere
/// that hold much or little, by vtkSkdTreeSpatialQuery and by vtkExtractGeometry, which finds no
/// more than the cells themselves. Prints a table of processor seconds and of how many times
/// vtkExtractGeometry's time the skD-tree takes (medians of runs that take turns), and of the cells
/// found; fails if these differ where both filters mean the same.
#include "ProcessorTime.h"
#include "VolumeKinds.h"

#include "Support/SpatialQueryRun.h"

#include "vtkBox.h"
#include "vtkExtractGeometry.h"
#include "vtkSMPTools.h"
#include "vtkSphere.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

using namespace skdbench;
using namespace skdtest;

namespace
{
/// A box or a ball in the middle of a mesh that has about a share of its volume.
struct Requested
{
  bool IsBall;
  int Relation;
  double Share;
};

Bounds BoxOf(const Requested& requested, const Bounds& all)
{
  Bounds box = all;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap =
      0.5 * (1.0 - std::cbrt(requested.Share)) * (all[2 * axis + 1] - all[2 * axis]);
    box[2 * axis] += gap;
    box[2 * axis + 1] -= gap;
  }
  return box;
}

double RadiusOf(const Requested& requested, const Bounds& all)
{
  const double volume = (all[1] - all[0]) * (all[3] - all[2]) * (all[5] - all[4]);
  return std::cbrt(0.75 / std::acos(-1.0) * requested.Share * volume);
}

QueryPointer MakeRequested(const Requested& requested, vtkDataSet* mesh)
{
  Bounds all;
  mesh->GetBounds(all.data());
  QueryPointer query = MakeQuery(mesh, requested.Relation);
  if (requested.IsBall)
  {
    SetSphere(query, Center(all), RadiusOf(requested, all));
  }
  else
  {
    SetBox(query, BoxOf(requested, all));
  }
  return query;
}

vtkSmartPointer<vtkImplicitFunction> MakeFunction(const Requested& requested, vtkDataSet* mesh)
{
  Bounds all;
  mesh->GetBounds(all.data());
  if (requested.IsBall)
  {
    auto sphere = vtkSmartPointer<vtkSphere>::New();
    sphere->SetCenter(Center(all).data());
    sphere->SetRadius(RadiusOf(requested, all));
    return sphere;
  }
  auto box = vtkSmartPointer<vtkBox>::New();
  box->SetBounds(BoxOf(requested, all).data());
  return box;
}

/// How many cells a filter finds, having run.
using Finding = std::function<vtkIdType()>;

Finding RunVtk(const Requested& requested, vtkDataSet* mesh)
{
  return [=, filter = vtkSmartPointer<vtkExtractGeometry>()]() mutable
  {
    filter = vtkSmartPointer<vtkExtractGeometry>::New();
    filter->SetInputData(mesh);
    filter->SetImplicitFunction(MakeFunction(requested, mesh));
    filter->SetExtractBoundaryCells(requested.Relation == SpatialQuery::OVERLAP);
    filter->Update();
    return filter->GetOutput()->GetNumberOfCells();
  };
}

Finding RunSkdTree(const Requested& requested, vtkDataSet* mesh, bool keepsTree)
{
  return [=, query = QueryPointer()]() mutable
  {
    query = query && keepsTree ? query : MakeRequested(requested, mesh);
    query->Modified();
    query->Update();
    return vtkDataSet::SafeDownCast(query->GetOutputDataObject(0))->GetNumberOfCells();
  };
}

struct Contender
{
  const char* Name;
  Finding Run;
  std::vector<double> Seconds = {};
  vtkIdType Found = 0;

  void Time()
  {
    const double start = ProcessorSeconds();
    this->Found = this->Run();
    this->Seconds.push_back(ProcessorSeconds() - start);
  }
};

/// Whether the filters agree. They mean the same by cells that are in a shape; of those that meet
/// it vtkExtractGeometry finds the ones that have a point in it.
bool Measure(const Requested& requested, const char* kind, vtkDataSet* mesh)
{
  Contender contenders[] = { { "vtkExtractGeometry", RunVtk(requested, mesh) },
    { "skD-tree, asked once", RunSkdTree(requested, mesh, false) },
    { "skD-tree, asked again", RunSkdTree(requested, mesh, true) } };
  for (int repetition = 0; repetition < 8; ++repetition)
  {
    for (Contender& contender : contenders)
    {
      contender.Time();
    }
  }
  const double theirs = Median(contenders[0].Seconds);
  bool areAgreed = true;
  for (const Contender& contender : contenders)
  {
    const double seconds = Median(contender.Seconds);
    std::printf("| %s %s %s | %s | %.3g | %.2f | %lld |\n", kind,
      requested.Relation == SpatialQuery::OVERLAP ? "that meet" : "in",
      requested.IsBall ? "a ball" : "a box", contender.Name, seconds, seconds / theirs,
      static_cast<long long>(contender.Found));
    areAgreed = areAgreed &&
      (requested.Relation == SpatialQuery::CONTAINMENT ? contender.Found == contenders[0].Found
                                                       : contender.Found >= contenders[0].Found);
  }
  std::fflush(stdout);
  return areAgreed;
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  const int cells = argc > 1 ? std::atoi(argv[1]) : 330000;
  std::printf("| %d cells | filter | seconds | x | found |\n", cells);
  std::printf("| --- | --- | ---: | ---: | ---: |\n");
  bool areAgreed = true;
  for (const Kind& kind : { Kinds[0], Kinds[1] })
  {
    const int n = std::max(2, static_cast<int>(std::cbrt(double(cells) / kind.CellsACube)));
    const auto mesh = WithData(MakeGrid(kind.Make(n).Map(Bent)));
    for (const double share : { 0.4, 0.001 })
    {
      for (const bool isBall : { false, true })
      {
        for (const int relation : { SpatialQuery::OVERLAP, SpatialQuery::CONTAINMENT })
        {
          areAgreed &= Measure({ isBall, relation, share }, kind.Name, mesh);
        }
      }
    }
  }
  return areAgreed ? 0 : 1;
}
