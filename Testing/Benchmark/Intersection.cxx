// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_intersection_benchmark [--csv file] [triangles ...]: two spheres that meet in a circle,
/// all pairs and the curve, beside VTK's two filters and, where it is found, CGAL. Prints a table
/// of processor seconds and of how many times the skD-tree's time the others take: medians of three
/// runs, or 15 short ones, that take turns, trees and all. Who takes more than 20 seconds is not
/// asked for more triangles.
#include "Intersection.h"
#include "ProcessorTime.h"
#include "Sphere.h"

#include "vtkCollisionDetectionFilter.h"
#include "vtkFieldData.h"
#include "vtkIntersectionPolyDataFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

using namespace skdbench;

namespace
{
vtkIdType RunSkdTree(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkSkdTreeSurfaceIntersection> filter;
  filter->SetInputData(first);
  filter->SetSourceData(second);
  filter->Update();
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfRows();
}

/// Moved from the place where it was last: trees are kept.
IntersectionRun MakeMovedSkdTree()
{
  return [filter = vtkSmartPointer<vtkSkdTreeSurfaceIntersection>::New()](
           vtkPolyData* first, vtkPolyData* second)
  {
    filter->SetInputData(first);
    filter->SetSourceData(second);
    filter->SetTranslation(filter->GetTranslation()[0] > 0.0 ? 0.0 : 1e-3, 0.0, 0.0);
    filter->Update();
    return vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfRows();
  };
}

IntersectionRun MakeMovedCollision()
{
  return [filter = vtkSmartPointer<vtkCollisionDetectionFilter>::New(), x = 0.0](
           vtkPolyData* first, vtkPolyData* second) mutable
  {
    vtkNew<vtkMatrix4x4> still;
    vtkNew<vtkMatrix4x4> moved;
    x = x > 0.0 ? 0.0 : 1e-3;
    moved->SetElement(0, 3, x);
    filter->SetInputData(0, first);
    filter->SetInputData(1, second);
    filter->SetMatrix(0, still);
    filter->SetMatrix(1, moved);
    filter->SetBoxTolerance(0.0);
    filter->SetCellTolerance(0.0);
    filter->SetCollisionModeToAllContacts();
    filter->Update();
    return static_cast<vtkIdType>(filter->GetNumberOfContacts());
  };
}

vtkIdType RunIntersection(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkIntersectionPolyDataFilter> filter;
  filter->SetInputData(0, first);
  filter->SetInputData(1, second);
  filter->SplitFirstOutputOff();
  filter->SplitSecondOutputOff();
  filter->Update();
  return filter->GetOutput()->GetNumberOfLines();
}

vtkIdType RunCollision(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkMatrix4x4> still;
  vtkNew<vtkCollisionDetectionFilter> filter;
  filter->SetInputData(0, first);
  filter->SetInputData(1, second);
  filter->SetMatrix(0, still);
  filter->SetMatrix(1, still);
  filter->SetBoxTolerance(0.0);
  filter->SetCellTolerance(0.0);
  filter->SetCollisionModeToAllContacts();
  filter->Update();
  return filter->GetNumberOfContacts();
}

constexpr double TooLong = 20.0; // seconds
constexpr double Short = 0.1;

struct Contender
{
  const char* Name;
  IntersectionRun Run;
  bool IsKept = false; ///< what it builds was built before
  bool IsIn = true;
  vtkIdType Found = 0;
  std::vector<double> Seconds = {};

  void Time(vtkPolyData* first, vtkPolyData* second)
  {
    const double start = ProcessorSeconds();
    this->Found = this->Run(first, second);
    this->Seconds.push_back(ProcessorSeconds() - start);
  }
};

void TakeTurns(std::vector<Contender>& contenders, vtkPolyData* first, vtkPolyData* second)
{
  for (Contender& contender : contenders)
  {
    for (int run = 0; run < 2 && contender.IsKept && contender.IsIn; ++run)
    {
      contender.Run(first, second);
    }
  }
  const auto takeATurn = [&](double longest)
  {
    for (Contender& contender : contenders)
    {
      if (contender.IsIn && (contender.Seconds.empty() || contender.Seconds.front() < longest))
      {
        contender.Time(first, second);
      }
    }
  };
  const auto isShort = [](const Contender& contender)
  { return !contender.IsIn || contender.Seconds.front() < Short; };
  takeATurn(TooLong);
  const bool areShort = std::all_of(contenders.begin(), contenders.end(), isShort);
  for (int turn = 1; turn < (areShort ? 15 : 3); ++turn)
  {
    takeATurn(0.5 * TooLong);
  }
}

/// As skdtree_benchmark --csv has it: nanoseconds a triangle of one surface.
void WriteRow(std::ostream& csv, vtkIdType triangles, const Contender& contender, double seconds)
{
  csv << "\"two spheres\"," << triangles << ",\"surfaces that meet\",\"ns a triangle\",\""
      << contender.Name << "\"," << 1e9 * seconds / static_cast<double>(triangles) << "\n";
}

void Measure(std::vector<Contender>& contenders, double triangles, std::ostream& csv)
{
  const auto first = MakeSphere(triangles, 0.0);
  TakeTurns(contenders, first, MakeSphere(triangles, 0.9));
  const double ours = Median(contenders.front().Seconds);
  std::printf("| %lld |", static_cast<long long>(first->GetNumberOfCells()));
  for (Contender& contender : contenders)
  {
    if (!contender.IsIn)
    {
      std::printf(" - |");
      continue;
    }
    const double seconds = Median(contender.Seconds);
    std::printf(" %.3g s, %.3g x, finds %lld |", seconds, seconds / ours,
      static_cast<long long>(contender.Found));
    WriteRow(csv, first->GetNumberOfCells(), contender, seconds);
    contender.IsIn = seconds < TooLong;
    contender.Seconds.clear();
  }
  std::printf("\n");
  std::fflush(stdout);
  csv.flush();
}

void PrintHeader(const std::vector<Contender>& contenders)
{
  std::printf("| triangles each |");
  for (const Contender& contender : contenders)
  {
    std::printf(" %s |", contender.Name);
  }
  std::printf("\n|");
  for (std::size_t i = 0; i <= contenders.size(); ++i)
  {
    std::printf(" ---: |");
  }
  std::printf("\n");
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  std::vector<Contender> contenders = { { "skD-tree", RunSkdTree },
    { "vtkIntersectionPolyDataFilter", RunIntersection },
    { "vtkCollisionDetectionFilter", RunCollision },
    { "skD-tree, moved", MakeMovedSkdTree(), true },
    { "vtkCollisionDetectionFilter, moved", MakeMovedCollision() } };
#ifdef SKDBENCH_HAS_CGAL
  contenders.push_back({ "CGAL, surface_intersection", RunCgalCurves });
#endif
  std::ofstream csv;
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i)
  {
    if (std::string(argv[i]) == "--csv" && i + 1 < argc)
    {
      csv.open(argv[++i]);
      csv << "scene,cells,work,unit,structure,value\n";
      continue;
    }
    sizes.push_back(std::atof(argv[i]));
  }
  PrintHeader(contenders);
  for (const double triangles : sizes.empty() ? std::vector<double>{ 1e3, 1e4, 1e5 } : sizes)
  {
    Measure(contenders, triangles, csv);
  }
  return 0;
}
