// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_grid_benchmark surface [level ...]: vtkSkdTreeAMR around a surface, tree and output and
/// all, beside recursion from the same base cells by vtkStaticCellLocator's
/// FindCellsWithinBounds for each box: boxes that cells' bounds meet are divided by eight. (It
/// tests nothing exactly, and makes no output.) Prints a table of processor seconds of one thread;
/// ours are medians of three, the other's are of one run.
#include "ProcessorTime.h"

#include "Support/AMRRun.h"
#include "Support/RealMeshes.h"

#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace skdbench;
using namespace skdtest;

namespace
{
template <class Body>
double Timed(const Body& body)
{
  const double start = ProcessorSeconds();
  body();
  return ProcessorSeconds() - start;
}

double Refine(vtkDataSet* surface, int level, double& cells)
{
  AMRPointer filter = MakeAMR(surface, level);
  filter->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
  const double seconds = Timed([&] { filter->Update(); });
  cells = Reported(filter, "AllCells");
  return seconds;
}

std::vector<Bounds> BaseCells(vtkDataSet* surface)
{
  std::vector<Bounds> boxes;
  for (const Leaf& leaf : RunLeaves(MakeAMR(surface, 0)))
  {
    boxes.push_back(leaf.Box);
  }
  return boxes;
}

/// How many boxes there are, of all levels.
double Recur(vtkStaticCellLocator* locator, Bounds box, int levels, vtkIdList* ids)
{
  double boxes = 1.0;
  locator->FindCellsWithinBounds(box.data(), ids);
  if (ids->GetNumberOfIds() == 0 || levels == 0)
  {
    return boxes;
  }
  const Point middle = Center(box);
  for (int child = 0; child < 8; ++child)
  {
    Bounds part = box;
    for (int axis = 0; axis < 3; ++axis)
    {
      part[2 * axis + (child >> axis & 1 ? 0 : 1)] = middle[axis];
    }
    boxes += Recur(locator, part, levels - 1, ids);
  }
  return boxes;
}

double AskLocator(vtkDataSet* surface, int level, double& boxes)
{
  vtkNew<vtkIdList> ids;
  const std::vector<Bounds> base = BaseCells(surface);
  return Timed(
    [&]
    {
      vtkNew<vtkStaticCellLocator> locator;
      locator->SetDataSet(surface);
      locator->BuildLocator();
      for (const Bounds& box : base)
      {
        boxes += Recur(locator, box, level, ids);
      }
    });
}

void Compare(vtkDataSet* surface, int level)
{
  double cells = 0.0;
  double boxes = 0.0;
  std::vector<double> ours;
  for (int run = 0; run < 3; ++run)
  {
    ours.push_back(Refine(surface, level, cells));
  }
  const double theirs = AskLocator(surface, level, boxes);
  std::printf("| %d | %.0f | %.3g | %.0f | %.3g | %.3g |\n", level, cells, Median(ours), boxes,
    theirs, theirs / Median(ours));
  std::fflush(stdout);
}
}

int main(int argc, char** argv)
{
  DataSetPointer surface = argc > 1 ? ReadMesh(argv[1]) : nullptr;
  if (!surface)
  {
    std::fprintf(stderr, "usage: skdtree_grid_benchmark surface [level ...]\n");
    return EXIT_FAILURE;
  }
  vtkSMPTools::Initialize(1);
  std::printf("| level | cells | skD-tree, s | boxes | vtkStaticCellLocator, s | ratio |\n"
              "| ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (int i = 2; i < argc; ++i)
  {
    Compare(surface, std::atoi(argv[i]));
  }
  return EXIT_SUCCESS;
}
