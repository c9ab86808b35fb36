// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_probe_benchmark [cells [points [kind ...]]]: a linear field of warped cells at random
/// points, beside VTK's filters. Prints a table of processor seconds, of how many times the
/// skD-tree's time the others take (medians of runs that take turns, searching structures and all),
/// of the points that were found, and of the largest error at those that are in a cell.
#include "ProcessorTime.h"
#include "VolumeKinds.h"

#include "Support/ProbeRun.h"

#include "vtkProbeFilter.h"
#include "vtkResampleWithDataSet.h"
#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace skdbench;
using namespace skdtest;

namespace
{
/// The data set that has the results.
using ProbeAnswer = std::function<vtkDataSet*(vtkDataSet* points, vtkDataSet* source)>;

struct Contender
{
  const char* Name;
  const char* Mask;
  ProbeAnswer Run;
  std::vector<double> Seconds = {};
  double Found = 0;
  double Error = 0;

  void Time(vtkDataSet* points, vtkDataSet* source)
  {
    const double start = ProcessorSeconds();
    vtkDataSet* output = this->Run(points, source);
    this->Seconds.push_back(ProcessorSeconds() - start);
    this->Judge(output);
  }

  void Judge(vtkDataSet* output)
  {
    const std::vector<double> isValid = PointArray(output, this->Mask);
    const std::vector<double> field = PointArray(output, "Linear");
    this->Found = 0;
    for (std::size_t i = 0; i < field.size(); ++i)
    {
      Point x;
      output->GetPoint(static_cast<vtkIdType>(i), x.data());
      this->Found += isValid[i];
      this->Error = std::max(this->Error, isValid[i] == 1 ? std::abs(field[i] - Linear(x)) : 0.0);
    }
  }
};

template <class Filter>
ProbeAnswer RunVtk(bool usesStaticLocator)
{
  return [filter = vtkSmartPointer<Filter>(), usesStaticLocator](
           vtkDataSet* points, vtkDataSet* source) mutable
  {
    // Another grid of the same arrays: what VTK keeps in a data set is not there yet.
    vtkSmartPointer<vtkDataSet> fresh = vtk::TakeSmartPointer(source->NewInstance());
    fresh->ShallowCopy(source);
    filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(points);
    filter->SetSourceData(fresh);
    if (usesStaticLocator)
    {
      filter->SetCellLocatorPrototype(vtkNew<vtkStaticCellLocator>());
    }
    filter->Update();
    return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  };
}

ProbeAnswer RunSkdTree(bool keepsTree)
{
  return [probe = ProbePointer(), keepsTree](vtkDataSet* points, vtkDataSet* source) mutable
  {
    probe = probe && keepsTree ? probe : MakeProbe(points, source);
    probe->Modified();
    probe->Update();
    return vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  };
}

void Measure(const Kind& kind, int cells, int points)
{
  const int n = std::max(2, static_cast<int>(std::cbrt(double(cells) / kind.CellsACube)));
  const auto source = WithData(MakeGrid(kind.Make(n).Map(Bent)));
  Mesh queries;
  queries.Points = MakePointsInCells(source, points).Points;
  const auto requested = MakeGrid(queries); // vtkResampleWithDataSet fails on polydata
  std::vector<Contender> contenders = { { "skD-tree", "SkdValid", RunSkdTree(false) },
    { "skD-tree, kept", "SkdValid", RunSkdTree(true) },
    { "vtkProbeFilter", "vtkValidPointMask", RunVtk<vtkProbeFilter>(false) },
    { "vtkProbeFilter, vtkStaticCellLocator", "vtkValidPointMask", RunVtk<vtkProbeFilter>(true) },
    { "vtkResampleWithDataSet", "vtkValidPointMask", RunVtk<vtkResampleWithDataSet>(false) } };
  for (int repetition = 0; repetition < 5; ++repetition)
  {
    for (Contender& contender : contenders)
    {
      if (repetition < 2 || contender.Seconds.front() < 10.0)
      {
        contender.Time(requested, source);
      }
    }
  }
  const double ours = Median(contenders.front().Seconds);
  for (Contender& contender : contenders)
  {
    std::printf("| %lld %s | %s | %.3g | %.2f | %.0f | %.1e |\n",
      static_cast<long long>(source->GetNumberOfCells()), kind.Name, contender.Name,
      Median(contender.Seconds), Median(contender.Seconds) / ours, contender.Found,
      contender.Error);
    std::fflush(stdout);
  }
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  const int cells = argc > 1 ? std::atoi(argv[1]) : 1000000;
  const int points = argc > 2 ? std::atoi(argv[2]) : 1000000;
  std::printf("| source | filter | seconds | x | found of %d | largest error |\n", points);
  std::printf("| --- | --- | ---: | ---: | ---: | ---: |\n");
  for (const Kind& kind : Kinds)
  {
    if (IsWanted(kind, argc, argv))
    {
      Measure(kind, cells, points);
    }
  }
  return 0;
}
