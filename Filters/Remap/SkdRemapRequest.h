// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapRequest.h
 * @brief How fields are to be mapped, as a user asks for it.
 */

#ifndef SkdRemapRequest_h
#define SkdRemapRequest_h

#include "Remap/SkdRemapper.h"
#include "Remap/SkdWeightsFile.h"

#include <set>
#include <string>

namespace skdtree
{
enum class SkdRemapMethod
{
  Automatic, ///< cell data by FirstOrder, point data by Interpolation
  Contained,
  Interpolation,
  FirstOrder,
  SecondOrder,
  FromFile
};

enum class SkdRemapResults
{
  Automatic, ///< points by interpolation, cells otherwise
  Cells,
  Points
};

enum class SkdRemapGeometry
{
  Automatic, ///< by the meshes
  Line,
  Plane,
  Sphere,
  Volume,
  CurvedSurface
};

enum class SkdSampleWeighing
{
  Automatic, ///< by the cosine of the latitude if the donor is structured
  Equal,
  CosineOfLatitude
};

struct SkdRemapRequest
{
  SkdRemapMethod Method = SkdRemapMethod::Automatic;
  SkdRemapResults Results = SkdRemapResults::Automatic;
  SkdRemapGeometry Geometry = SkdRemapGeometry::Automatic;
  bool IsDonorInDegrees = false;  ///< points are longitude and latitude
  bool IsTargetInDegrees = false; ///< the same
  SkdSampleWeighing Weighing = SkdSampleWeighing::Automatic;
  SkdRemapSettings Settings;       ///< but what follows from the above and from the meshes
  std::set<std::string> Gradients; ///< arrays whose gradients interpolation adds
  SkdWeightsFileSettings Written;  ///< Name and Format: the file that gets the weights, if any
  std::string Applied;             ///< the file whose weights are applied

  bool IsConservative() const
  {
    return this->Method == SkdRemapMethod::FirstOrder ||
      this->Method == SkdRemapMethod::SecondOrder;
  }
};
}

#endif
