// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurveSet.h
 * @brief The curve cells of some data sets as pieces in Bernstein form.
 */

#ifndef SkdCurveSet_h
#define SkdCurveSet_h

#include "Core/Curves/BezierCurve.h"
#include "Core/Parallel/Processes.h"
#include "Curves/SkdCurveJoints.h"
#include "Pipeline/SkdBlocks.h"

#include <string>
#include <vector>

class vtkCell;
class vtkIdList;

namespace skdtree
{
/// How the points of a polyline are joined.
struct SkdPolylineForm
{
  enum Kinds
  {
    Straight, ///< by straight lines
    Cardinal, ///< by vtkCardinalSpline, over chord lengths
    Kochanek  ///< by vtkKochanekSpline, over chord lengths
  };
  Kinds Kind = Straight;
  double Tension = 0.0; ///< these of a Kochanek spline
  double Bias = 0.0;
  double Continuity = 0.0;

  /// From the properties of filters. NaN counts as 0.
  static SkdPolylineForm Of(int kind, double tension, double bias, double continuity);

  bool operator==(const SkdPolylineForm& other) const
  {
    return this->Kind == other.Kind && this->Tension == other.Tension && this->Bias == other.Bias &&
      this->Continuity == other.Continuity;
  }
};

/// A cell that is a curve.
struct SkdCurve
{
  int Block; ///< index in the list of blocks
  vtkIdType CellId;
  std::size_t FirstPiece;
  std::size_t LastPiece; ///< one beyond
  int Intervals;         ///< what its parameter counts: points of a polyline less one, or 1
  bool IsClosed;
  double Length;
};

class SkdCurveSet
{
public:
  /// Reads lines, polylines, quadratic, cubic, Lagrange and Bezier curves. Pieces and curves of
  /// zero length, ghosts, and the curves reported by GetFaults() are ignored. With processes, each
  /// has some of the cells, and what is relative to the size of the curves is so to that of all.
  void Read(const std::vector<SkdBlock>& blocks, const SkdPolylineForm& form,
    const skd::Processes* processes = nullptr);

  const std::vector<SkdCurve>& GetCurves() const { return this->Curves; }
  std::size_t GetNumberOfPieces() const { return this->Pieces.size(); }
  std::size_t GetCurveOf(std::size_t piece) const { return this->Pieces[piece].Curve; }

  /// The piece relative to `origin`. With an origin of 0, lines have exactly the coordinates of
  /// their points.
  skd::BezierCurve GetPiece(std::size_t piece, const skd::Vector3& origin) const;

  /// @{ A point of a piece as a parameter of its curve, 0 to 1 (for polylines by point numbers),
  /// and as arc length from the start.
  double GetParameter(std::size_t piece, double t) const;
  double GetArcLength(std::size_t piece, double t) const;
  ///@}

  /// The points of the cell and their interpolation weights: linear between points of a polyline.
  void GetWeights(std::size_t piece, double t, vtkIdList* ids, std::vector<double>& weights) const;

  /// Of the curves of all processes.
  const skd::Box3& GetBounds() const { return this->Bounds; }

  /// Joints of cells whose ends coincide to within rounding.
  const SkdCurveJoints& GetJoints() const { return this->Joints; }

  /// Whether a parameter, the number of a piece in its curve and T, is where an open curve starts
  /// or ends, to within `slack`; the joint there.
  bool IsAtEnd(std::size_t curve, double u, double slack, std::size_t& joint) const;

  /// Messages about cells that could not be read: "3 cells are not curves". Of a mesh that has
  /// cells of other processes, too, its own are counted (SkdOwnCellsOf).
  std::vector<std::string> GetFaults() const;

private:
  struct Piece
  {
    skd::Vector3 Origin;
    double LengthBefore;
    std::size_t FirstPoint;
    std::size_t Curve;
    int Degree;
    int Interval;
  };

  void ReadCell(vtkDataSet* mesh, int block, vtkIdType cellId);
  void AddLines(const std::vector<skd::Vector3>& points);
  void AddSplines(const std::vector<skd::Vector3>& points, bool isClosed);
  void AddPiece(const skd::BezierCurve& form, const skd::Vector3& origin, int interval);
  bool AddPolyline(vtkCell* cell, SkdCurve& curve);
  bool AddNative(vtkCell* cell);
  void Close(SkdCurve& curve);
  void JoinEnds();
  void AddBoundsOf(const skd::Processes& processes);

  /// Cells that are not read.
  struct Faults
  {
    vtkIdType NotCurves = 0;
    vtkIdType NoLength = 0;
    vtkIdType NotFinite = 0;
    vtkIdType NotMeasurable = 0;
    vtkIdType BadWeights = 0;
    vtkIdType TooHigh = 0;
  };

  std::vector<SkdBlock> Blocks;
  std::vector<SkdCurve> Curves;
  std::vector<Piece> Pieces;
  std::vector<skd::Homogeneous> Points;
  skd::Box3 Bounds;
  SkdCurveJoints Joints;
  SkdPolylineForm Form;
  Faults Found;
};
}

#endif
