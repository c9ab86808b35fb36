// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBernsteinMap_h
#define SkdBernsteinMap_h

#include "Cells/Kernels/SkdPatch.h"
#include "Core/Geometry/Cells/DistanceForm.h"

#include <vector>

class vtkCell;

namespace skdtree
{
/// From the points of a type of curved cells to the Bernstein form of their map, or of its
/// restriction to one of their patches: control points are sums of points. Made of the type's
/// interpolation functions, whatever they are, as long as they are polynomials, or those of
/// rational Bezier cells. Constant; one for all cells of a type, of a number of points and of an
/// order.
class SkdBernsteinMap
{
public:
  static constexpr int NoPatch = -1;

  /// That of a cell or of one of the patches of its domain (SkdPatches); nullptr if it has none: of
  /// whole volume cells of more than MostPoints points it would cost too much. Thread-safe; locks
  /// only when the type changes.
  static const SkdBernsteinMap* Of(
    vtkCell* cell, const skd::ParameterDomain& domain, int patch = NoPatch);

  /// How many times the rounding of points, at most, control points have.
  double Amplification() const { return this->TheAmplification; }

  const skd::BernsteinLayout& GetLayout() const { return this->Form.GetLayout(); }
  const skd::DistanceForm& GetDistanceForm() const { return this->Form; }

  /// Sets the control points, three arrays of the layout's size, of points seen from an origin.
  /// With weights (unless nullptr) of the points both are multiplied by them; those of the control
  /// points are set, too.
  void Convert(const skd::Vector3* points, const skd::Vector3& origin, const double* weights,
    double* const (&controls)[3], double* controlWeights) const;

private:
  static constexpr int MostPoints = 512;

  struct Key
  {
    int Type = -1;
    int Size = 0;
    int Order[3] = { 0, 0, 0 };
    int Patch = NoPatch;
    bool operator==(const Key& other) const;
  };

  static Key KeyOf(vtkCell* cell);
  static const SkdBernsteinMap& Make(
    vtkCell* cell, const skd::ParameterDomain& domain, const Key& key);

  void FitAny(vtkCell* cell, const skd::ParameterDomain& domain);
  void FindDegrees(const skd::ParameterDomain& domain, int (&degree)[3]) const;
  bool Fit(vtkCell* cell, const SkdPatch* patch, const skd::BernsteinLayout& layout);
  void Compress(const std::vector<double>& matrix);

  Key TheKey;
  bool IsUsable = false;
  skd::DistanceForm Form;
  double TheAmplification = 1.0;
  struct Term
  {
    int Point;
    double Factor;
  };
  std::vector<int> Begins; ///< of the terms of each control point, and their end
  std::vector<Term> Terms;
};
}

#endif
