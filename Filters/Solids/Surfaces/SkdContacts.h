// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdContacts.h
 * @brief Pairs of triangles that touch or are near, as output data sets of the filter.
 */

#ifndef SkdContacts_h
#define SkdContacts_h

#include "Pipeline/SkdJoinedIds.h"
#include "Solids/Surfaces/SkdContactKey.h"
#include "Solids/Surfaces/SkdContactPoints.h"
#include "Solids/Surfaces/SkdCurves.h"

class vtkDataSetAttributes;
class vtkFieldData;
class vtkPolyData;
class vtkTable;

namespace skdtree
{
class SkdTransport;

/// What pairs have in common.
enum class SkdContactKind
{
  Near,
  Point,
  Segment,
  Area
};

SkdContactKind SkdKindOf(const skd::TriangleContact& contact);

class SkdContacts
{
public:
  ///@{
  /// Arrays of the outputs.
  static constexpr const char* FirstCellName = "SkdFirstCellId";
  static constexpr const char* SecondCellName = "SkdSecondCellId";
  static constexpr const char* FirstBlockName = "SkdFirstBlockIndex";
  static constexpr const char* SecondBlockName = "SkdSecondBlockIndex";
  static constexpr const char* ClosedName = "SkdCurveClosed";
  static constexpr const char* LengthName = "SkdCurveLength";
  static constexpr const char* KindName = "SkdContact";
  static constexpr const char* DistanceName = "SkdDistance";
  static constexpr const char* FirstPointName = "SkdFirstPoint";
  static constexpr const char* SecondPointName = "SkdSecondPoint";
  ///@}

  /// The data sets of a surface. Block indices are output for composite data. Ids are those in
  /// the whole of a mesh in pieces: by block and cell, or where there are none by SkdJoinedIds.
  struct Side
  {
    const std::vector<SkdBlock>& Blocks;
    bool IsComposite;
    std::vector<std::vector<vtkIdType>> Ids;
  };

  SkdContacts(Side first, Side second, const SkdPlacement& placement,
    const std::vector<SkdTrianglePair>& pairs);

  const SkdContactPoints& GetPoints() const { return this->Points; }

  /// The curves: polylines with the ids of each segment at its first point, or a cell for each
  /// segment. Isolated points of contact are vertices. Returns the number of curves without
  /// vertices. With a transport the first surface lies in pieces (see SkdSpreadCurves), and all
  /// processes call it together.
  vtkIdType FillCurves(vtkPolyData* curves, bool isJoined, SkdTransport* transport) const;

  /// The convex polygons in which triangles of one plane overlap.
  vtkIdType FillOverlaps(vtkPolyData* overlaps) const;

  /// A row for each pair of cells, and for each that is near but does not touch a line between
  /// their nearest points.
  void FillPairs(vtkTable* table, vtkPolyData* gaps) const;

private:
  struct Row
  {
    std::uint32_t FirstCell;
    std::uint32_t SecondCell;
    SkdContactKind Kind;
    std::size_t Pair;
    double Dist2;
    skd::Vector3 FirstPoint;
    skd::Vector3 SecondPoint;
  };

  void AddMeasures(vtkPolyData* output, const SkdCurves& curves) const;
  SkdCurveParts FindParts() const;
  void FindSegments(SkdCurveParts& parts) const;
  void FindLonePoints(SkdCurveParts& parts) const;
  void KeepLowest(std::vector<SkdEndPair>& lone) const;
  bool HasOwnIds() const { return !this->First.Ids.empty(); }
  bool IsLower(std::size_t a, std::size_t b) const; // of two pairs
  SkdCurves JoinAlone(SkdCurveParts parts) const;
  SkdCurves JoinSpread(SkdCurveParts parts, bool isJoined, SkdTransport& transport) const;
  const skd::Vector3& PositionOf(std::uint32_t point, const SkdCurves& curves) const;
  bool IsBefore(std::uint32_t a, std::uint32_t b) const;
  SkdContactKey KeyOf(const SkdContactPoints::Location& location) const;
  SkdContactLabel LabelOf(std::size_t pair) const;
  static std::pair<vtkIdType, int> CellOf(const Side& side, const std::vector<SkdJoinedIds>& joined,
    const SkdMovedTriangles& triangles,
    std::uint32_t triangle); // its id in the whole, and its block's index
  std::vector<Row> FindRows() const;
  Row MakeRow(std::size_t index) const;
  void FillGaps(const std::vector<Row>& rows, vtkPolyData* gaps) const;
  void AddLabels(const std::vector<std::size_t>& pairs, vtkFieldData* to,
    const std::vector<SkdContactLabel>& received = {}) const;
  void FillSeparate(vtkPolyData* output, const SkdCurves& curves) const;
  void FillJoined(vtkPolyData* output, const SkdCurves& curves) const;

  Side First;
  Side Second;
  std::vector<SkdJoinedIds> FirstIds;
  std::vector<SkdJoinedIds> SecondIds;
  const SkdPlacement& Placement;
  const std::vector<SkdTrianglePair>& Pairs;
  SkdContactPoints Points;
};
}

#endif
