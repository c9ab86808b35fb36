// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdbench_Sphere_h
#define skdbench_Sphere_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace skdbench
{

/// Of radius 1, about as many triangles; those of two with different x cross.
inline vtkSmartPointer<vtkPolyData> MakeSphere(double triangles, double x)
{
  vtkNew<vtkSphereSource> source;
  const int resolution = std::max(4, static_cast<int>(std::sqrt(0.5 * triangles)) + 1);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetRadius(1.0);
  source->SetCenter(x, 0.31 * x, 0.17 * x);
  source->Update();
  return source->GetOutput();
}

}

#endif
