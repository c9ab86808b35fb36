// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a program that found the package SkdTree does with it.

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSkdTreeCellLocator.h>
#include <vtkSkdTreeClosestPoint.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(11, 11, 11);
  vtkNew<vtkSkdTreeCellLocator> locator;
  locator->SetDataSet(grid);
  locator->BuildLocator();

  double inside[3] = { 3.5, 4.5, 5.5 };
  const vtkIdType expected = 3 + 10 * (4 + 10 * 5);
  const vtkIdType cell = locator->FindCell(inside);

  const double outside[3] = { 5.0, 5.0, 13.0 };
  double closest[3];
  vtkIdType cellId;
  int subId;
  double dist2;
  locator->FindClosestPoint(outside, closest, cellId, subId, dist2);

  vtkNew<vtkSkdTreeClosestPoint> filter;
  filter->SetInputData(grid);
  filter->SetSourceData(grid);
  filter->Update();
  vtkDataSet* result = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));

  const bool good = cell == expected && std::abs(dist2 - 9.0) < 1e-12 && result != nullptr &&
    result->GetNumberOfPoints() == grid->GetNumberOfPoints();
  std::cout << "cell " << cell << ", squared distance " << dist2 << (good ? "\n" : ": wrong\n");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
