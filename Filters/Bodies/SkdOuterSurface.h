// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOuterSurface.h
 * @brief The surface cells of a data set and the outer faces of its volume cells, as polygons.
 *
 * Linear cells give the polygons that they have. Curved ones (quadratic, Lagrange, Bezier) give
 * flat facets no farther from the face than a chordal deviation (Core/Curves/PatchFacets.h): one
 * polygon where the face is straight within it. Facets of neighbours fit together, be these of
 * different data sets, and faces that two data sets share are cut the same.
 */

#ifndef SkdOuterSurface_h
#define SkdOuterSurface_h

#include "Cells/Read/SkdStoredCells.h"
#include "Core/Geometry/Vector.h"
#include "Core/Parallel/Processes.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

class vtkAlgorithm;

namespace skdtree
{
/// The default chordal deviation, relative to the diagonal of the bounds.
constexpr double SkdDefaultChordalDeviation = 1e-4;

/// A chordal deviation as a length, for the diagonal of all blocks; 0 if none has curved cells.
/// With several processes it uses the blocks of all and is the same on each.
double SkdChordalLength(
  const std::vector<SkdBlock>& blocks, double share, const skd::Processes* processes = nullptr);

/// Warns, if there are any, of curved faces whose facets are farther from them than the deviation.
void SkdWarnAboutCoarseFaces(vtkAlgorithm* self, vtkIdType coarseFaces, double chordalDeviation);

/// A triangle of a strip, oriented as the first: every second one is stored the other way round.
template <class Id>
std::array<Id, 3> SkdStripTriangle(const Id* corners, std::ptrdiff_t k)
{
  const std::ptrdiff_t swap = k % 2;
  return { corners[k + swap], corners[k + 1 - swap], corners[k + 2] };
}

/// The outer faces of one data set, including its surface cells, with the origin of their cells and
/// points. The surface of a vtkPolyData is itself. All readers of flat faces use this class.
class SkdBlockSurface
{
public:
  /// Curved faces become flat facets, none farther from its face than a chordal length.
  SkdBlockSurface(vtkDataSet* mesh, double chordalLength);

  vtkPolyData* Get() const { return this->Surface; }

  /// The curved faces of which the chordal deviation would need more facets than allowed.
  vtkIdType GetNumberOfCoarseFaces() const { return this->CoarseFaces; }

  /// The data set's cell that a cell of the surface comes from, and whether it has a volume.
  vtkIdType GetCellId(vtkIdType cell) const
  {
    return this->CellIds ? this->CellIds->GetValue(cell) : cell;
  }
  bool IsOfVolume(vtkIdType cell) const;

  /// The data set's point that a point of the surface is; -1 of one that it does not have.
  vtkIdType GetPointId(vtkIdType point) const
  {
    return this->PointIds ? this->PointIds->GetValue(point)
                          : (this->Mesh == this->Surface.Get() ? point : -1);
  }

  /// A point of the surface, with the coordinates of the data set.
  void GetPoint(vtkIdType point, double x[3]) const
  {
    if (this->Doubles)
    {
      std::copy_n(this->Doubles + 3 * point, 3, x);
    }
    else if (this->Floats)
    {
      std::copy_n(this->Floats + 3 * point, 3, x);
    }
    else
    {
      this->FindPoint(point, x);
    }
  }

  /// Has other faces instead, each given by the cell of the surface that it is of, on other points:
  /// those of the surface, maybe moved by rounding, and after them some that the data set does not
  /// have. Vertices and lines stay.
  void SetFaces(const std::vector<vtkIdType>& cells, vtkCellArray* polygons,
    const std::vector<skd::Vector3>& points);

  /// Calls visit(cell of the surface, size, corners) for each polygon and each triangle of a strip,
  /// ghosts left out. Corners are points of the surface, in whatever type they are stored.
  template <class Visit>
  void ForEachFace(const Visit& visit) const
  {
    vtkUnsignedCharArray* ghosts = this->Surface->GetCellGhostArray();
    vtkIdType first = this->Surface->GetNumberOfVerts() + this->Surface->GetNumberOfLines();
    for (vtkCellArray* cells : { this->Surface->GetPolys(), this->Surface->GetStrips() })
    {
      const bool isStrip = cells == this->Surface->GetStrips();
      SkdForEachCell(cells,
        [&](vtkIdType i, const auto* corners, std::size_t number)
        {
          const vtkIdType cell = first + i;
          const auto size = static_cast<vtkIdType>(number);
          if (!ghosts || ghosts->GetValue(cell) == 0)
          {
            if (!isStrip)
            {
              visit(cell, size, corners);
            }
            for (vtkIdType k = 0; isStrip && k + 2 < size; ++k)
            {
              visit(cell, 3, SkdStripTriangle(corners, k).data());
            }
          }
        });
      first += cells->GetNumberOfCells();
    }
  }

private:
  void FindPoint(vtkIdType point, double x[3]) const;
  void FindIds();

  vtkDataSet* Mesh;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkIdType CoarseFaces = 0;
  const double* Doubles = nullptr; // the points, where they lie in a row
  const float* Floats = nullptr;
  vtkIdTypeArray* CellIds = nullptr;
  vtkIdTypeArray* PointIds = nullptr;
};

/// Appends the corners of a face to `to`, each as idOf(corner), which is -1 of one that is not
/// finite. Repeated adjacent corners are removed; degenerate faces are ignored. Returns the number
/// appended, 0 if there is no face.
template <class Corner, class IdOf, class AreSame = std::equal_to<vtkIdType>>
int SkdAppendCorners(vtkIdType size, const Corner* corners, IdOf idOf, std::vector<vtkIdType>& to,
  AreSame areSame = {})
{
  const std::size_t first = to.size();
  bool isFinite = true;
  for (vtkIdType i = 0; i < size && isFinite; ++i)
  {
    const vtkIdType id = idOf(static_cast<vtkIdType>(corners[i]));
    isFinite = id >= 0;
    if (to.size() == first || !isFinite || !areSame(to.back(), id))
    {
      to.push_back(id);
    }
  }
  if (isFinite && to.size() > first + 1 && areSame(to.back(), to[first]))
  {
    to.pop_back();
  }
  if (!isFinite || to.size() < first + 3)
  {
    to.resize(first);
  }
  return static_cast<int>(to.size() - first);
}
}

#endif
