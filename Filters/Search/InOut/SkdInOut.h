// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdInOut_h
#define SkdInOut_h

#include "Search/InOut/SkdPartList.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

class vtkDataSetAttributes;

namespace skdtree
{
/// The result of all parts for a point.
struct SkdInOut
{
  bool IsInside = false;
  int PartId = -1;
  int Depth = 0;
  double Confidence = 0.0;
  bool IsOnBoundary = false;
  double WindingNumber = 0.0;
  double WindingBound = 0.0; // what the number is off by at most
};

/// Arrays with one tuple for each point or cell, initially "none".
class SkdInOuts
{
public:
  static constexpr const char* InsideName = "SkdInside";

  SkdInOuts(vtkIdType n, bool hasWinding);

  /// Sets a tuple. Thread-safe for distinct tuples.
  void Set(vtkIdType i, const SkdInOut& answer);

  vtkIdType GetNumber() const { return this->Inside->GetNumberOfTuples(); }
  bool IsInside(vtkIdType i) const { return this->Inside->GetValue(i) != 0; }

  /// Adds the arrays, and makes the first the active scalars.
  void AddTo(vtkDataSetAttributes* data) const;

private:
  vtkSmartPointer<vtkUnsignedCharArray> Inside;
  vtkSmartPointer<vtkIntArray> PartIds;
  vtkSmartPointer<vtkIntArray> Depths;
  vtkSmartPointer<vtkFloatArray> Confidences;
  vtkSmartPointer<vtkUnsignedCharArray> OnBoundary;
  vtkSmartPointer<vtkDoubleArray> Windings;      // or nullptr
  vtkSmartPointer<vtkDoubleArray> WindingBounds; // as Windings
};
}

#endif
