// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structure.h"
#include "Triangles.h"

#include "vtkDataSet.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>

namespace skdbench
{
namespace
{

using namespace skdtest;

// CGAL's fastest: its exact kernels take longer.
using Kernel = CGAL::Simple_cartesian<double>;
using Primitive =
  CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 AsCgal(const Point& p)
{
  return { p[0], p[1], p[2] };
}

Point AsPoint(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

/// Triangles in an AABB tree, with the points from which its distance queries start.
class CgalStructure : public Structure
{
public:
  bool Build(vtkDataSet* data) override
  {
    const auto triangles = TrianglesOf(data);
    if (!triangles)
    {
      return false;
    }
    this->Triangles.clear();
    this->Triangles.reserve(triangles->size());
    for (const Corners& corners : *triangles)
    {
      this->Triangles.emplace_back(AsCgal(corners.A), AsCgal(corners.B), AsCgal(corners.C));
    }
    this->Boxes.clear();
    this->Boxes.insert(this->Triangles.cbegin(), this->Triangles.cend());
    this->Boxes.build();
    this->Boxes.accelerate_distance_queries();
    return true;
  }

  bool Ask(QueryKind queryKind, const Query& query, Answer& answer) override
  {
    switch (queryKind)
    {
      case QueryKind::ClosestPoint:
        this->Closest(query, answer);
        return true;
      case QueryKind::FirstHit:
        this->FirstHit(query, answer);
        return true;
      case QueryKind::AllHits:
        this->AllHits(query, answer);
        return true;
      default:
        return false;
    }
  }

private:
  vtkIdType IdOf(Primitive::Id id) const { return id - this->Triangles.cbegin(); }

  void Closest(const Query& query, Answer& answer)
  {
    const auto found = this->Boxes.closest_point_and_primitive(AsCgal(query.From));
    answer.Where = AsPoint(found.first);
    answer.Cell = this->IdOf(found.second);
    answer.Value = Dot(answer.Where - query.From, answer.Where - query.From);
  }

  /// Only rays are stopped at the first hit; the ray goes on behind the segment's end.
  void FirstHit(const Query& query, Answer& answer)
  {
    answer.Cell = -1;
    const Kernel::Ray_3 ray(AsCgal(query.From), AsCgal(query.To));
    const auto hit = this->Boxes.first_intersection(ray);
    const auto* where = hit ? boost::get<Kernel::Point_3>(&hit->first) : nullptr;
    if (where)
    {
      this->Take(query, AsPoint(*where), this->IdOf(hit->second), answer);
    }
  }

  static void Take(const Query& query, const Point& where, vtkIdType cell, Answer& answer)
  {
    const Point along = query.To - query.From;
    const double t = Dot(where - query.From, along) / Dot(along, along);
    if (t <= 1.0)
    {
      answer.Cell = cell;
      answer.Value = t;
      answer.Where = where;
    }
  }

  void AllHits(const Query& query, Answer& answer)
  {
    const Kernel::Segment_3 segment(AsCgal(query.From), AsCgal(query.To));
    this->Hits.clear();
    this->Boxes.all_intersections(segment, std::back_inserter(this->Hits));
    this->Order.clear();
    for (const Hit& hit : this->Hits)
    {
      const auto* where = boost::get<Kernel::Point_3>(&hit.first);
      const double far = where ? CGAL::squared_distance(segment.source(), *where) : 0.0;
      this->Order.emplace_back(far, this->IdOf(hit.second));
    }
    std::sort(this->Order.begin(), this->Order.end());
    this->Ids.clear();
    for (const auto& hit : this->Order)
    {
      this->Ids.push_back(hit.second);
    }
    answer.Cells = this->Ids.data();
    answer.NumberOfCells = static_cast<vtkIdType>(this->Ids.size());
  }

  using Hit = Tree::Intersection_and_primitive_id<Kernel::Segment_3>::Type;

  std::vector<Kernel::Triangle_3> Triangles;
  Tree Boxes;
  std::vector<Hit> Hits;
  std::vector<std::pair<double, vtkIdType>> Order;
  std::vector<vtkIdType> Ids;
};

}

std::vector<Kind> CgalKinds()
{
  return { { "CGAL AABB tree", Family::Peer, [] { return std::make_unique<CgalStructure>(); }, true,
    1.2e7 } };
}

}
