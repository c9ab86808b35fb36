// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapSurface.h
 * @brief Where two meshes overlap: a line, a plane with its axes, a sphere with its radius, space,
 * or two surfaces in space that nearly coincide.
 */

#ifndef SkdOverlapSurface_h
#define SkdOverlapSurface_h

#include "Core/Geometry/Vector.h"
#include "Remap/SkdOverlapTypes.h"

#include <string>

class vtkDataSet;

namespace skdtree
{
/// Overlaps are found in coordinates of their own: (x, y, 0) in a plane, points of the unit sphere,
/// and else as they are.
class SkdOverlapSurface
{
public:
  /// What is wrong with the meshes, if anything, is in GetProblem().
  SkdOverlapSurface(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings);

  /// The mean distance of a donor's points from the origin, of the whole donor; 1 if it is nearly
  /// that.
  static double MeanRadiusOf(vtkDataSet* donor);

  SkdOverlapSpace GetSpace() const { return this->Space; }
  double GetRadius() const { return this->Radius; }
  const skd::Vector3& GetNormal() const { return this->Normal; }
  const SkdFacetRules& GetFacetRules() const { return this->Facets; }
  const std::string& GetProblem() const { return this->Problem; }

  /// NaN of a point that is on no sphere.
  skd::Vector3 Project(const skd::Vector3& x) const;

  ///@{
  /// Back: positions, measures, and integrals of differences of positions.
  skd::Vector3 Unproject(const skd::Vector3& projected) const;
  double Measure(double projected) const { return this->MeasureScale * projected; }
  skd::Vector3 Moment(const skd::Vector3& projected) const;
  ///@}

private:
  void FindPlane(vtkDataSet* donor, vtkDataSet* target);
  void SetAxes(const skd::Vector3& normal);

  SkdOverlapSpace Space;
  SkdFacetRules Facets;
  skd::Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  skd::Vector3 Axes[2];
  skd::Vector3 Normal{ { 0.0, 0.0, 0.0 } };
  double Radius = 1.0;
  double MeasureScale = 1.0;
  std::string Problem;
};
}

#endif
