// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpatialQueryRun.h
 * @brief vtkSkdTreeSpatialQuery run on a mesh, and its table by value
 */
#ifndef skdtest_SpatialQueryRun_h
#define skdtest_SpatialQueryRun_h

#include "Support/FilterRun.h"

#include "vtkImageData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSkdTreeSpatialQuery.h"
#include "vtkTable.h"

#include <ostream>

namespace skdtest
{

using QueryPointer = vtkSmartPointer<vtkSkdTreeSpatialQuery>;
using SpatialQuery = vtkSkdTreeSpatialQuery;

constexpr const char* RelationNames[] = { "ExactMatch", "Overlap", "Enclosure", "Containment",
  "Adjacency", "Nearest" };
constexpr const char* ShapeNames[] = { "Box", "Sphere", "Plane", "Line", "Points", "Cells" };

/// A grid of three cubes each way, with data.
inline DataSetPointer MakeBricks(double x = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 4, 4);
  image->SetOrigin(x, 0, 0);
  return WithData(image);
}

inline QueryPointer MakeQuery(vtkDataObject* input, int relation = SpatialQuery::OVERLAP)
{
  auto query = QueryPointer::New();
  query->SetInputDataObject(0, input);
  query->SetRelation(relation);
  return query;
}

inline void SetBox(SpatialQuery* query, const Bounds& box)
{
  query->SetShape(SpatialQuery::BOX);
  query->SetBoxPosition(box[0], box[2], box[4]);
  query->SetBoxLength(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
}

inline void SetSphere(SpatialQuery* query, const Point& center, double radius)
{
  query->SetShape(SpatialQuery::SPHERE);
  query->SetSphereCenter(center.data());
  query->SetSphereRadius(radius);
}

inline void SetPlane(SpatialQuery* query, const Point& origin, const Point& normal)
{
  query->SetShape(SpatialQuery::PLANE);
  query->SetPlaneOrigin(origin.data());
  query->SetPlaneNormal(normal.data());
}

inline void SetLine(SpatialQuery* query, const Point& a, const Point& b)
{
  query->SetShape(SpatialQuery::LINE);
  query->SetLinePoint1(a.data());
  query->SetLinePoint2(b.data());
}

/// A row of the table.
struct PairRow
{
  vtkIdType Query;
  vtkIdType Cell;
  double Optimistic;
  double Pessimistic;
  double Min; ///< NaN where there is no such column
  double Max;
};

inline std::vector<double> TableColumn(vtkTable* table, const char* name)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  values.resize(
    static_cast<std::size_t>(table->GetNumberOfRows()), std::numeric_limits<double>::quiet_NaN());
  return values;
}

inline std::vector<PairRow> RunQuery(SpatialQuery* query)
{
  query->Update();
  auto* table = vtkTable::SafeDownCast(query->GetOutputDataObject(2));
  const std::vector<double> queries = TableColumn(table, "SkdQueryId");
  const std::vector<double> cells = TableColumn(table, "SkdCellId");
  const std::vector<double> optimistic = TableColumn(table, "SkdOptimisticDistance");
  const std::vector<double> pessimistic = TableColumn(table, "SkdPessimisticDistance");
  const std::vector<double> least = TableColumn(table, "SkdMinimumDistance");
  const std::vector<double> most = TableColumn(table, "SkdMaximumDistance");
  std::vector<PairRow> rows;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    rows.push_back({ static_cast<vtkIdType>(queries[i]), static_cast<vtkIdType>(cells[i]),
      optimistic[i], pessimistic[i], least[i], most[i] });
  }
  return rows;
}

/// Of one query the cells, ascending as the table has them.
inline Ids CellsFound(SpatialQuery* query)
{
  Ids cells;
  for (const PairRow& row : RunQuery(query))
  {
    cells.push_back(row.Cell);
  }
  return cells;
}

}

#endif
