// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeDevice.h"
#include "Structure.h"
#include "Triangles.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <embree3/rtcore.h>

#include <algorithm>

namespace skdbench
{
namespace
{

using namespace skdtest;

Point ClosestOnSegment(const Point& x, const Point& a, const Point& b)
{
  const double length2 = Dot(b - a, b - a);
  const double t = length2 > 0.0 ? Dot(x - a, b - a) / length2 : 0.0;
  return Lerp(a, b, std::clamp(t, 0.0, 1.0));
}

Point Nearer(const Point& x, const Point& p, const Point& q)
{
  return Distance(x, q) < Distance(x, p) ? q : p;
}

/// In double, as an application of Embree would: its own part ends at the leaf.
Point ClosestOnTriangle(const Point& x, const Corners& c)
{
  const Point ab = c.B - c.A;
  const Point ac = c.C - c.A;
  const Point normal = Cross(ab, ac);
  const double area2 = Dot(normal, normal);
  const double v = Dot(Cross(x - c.A, ac), normal);
  const double w = Dot(Cross(ab, x - c.A), normal);
  if (area2 > 0.0 && v >= 0.0 && w >= 0.0 && v + w <= area2)
  {
    return c.A + (v / area2) * ab + (w / area2) * ac;
  }
  const Point onTwo = Nearer(x, ClosestOnSegment(x, c.A, c.B), ClosestOnSegment(x, c.B, c.C));
  return Nearer(x, onTwo, ClosestOnSegment(x, c.C, c.A));
}

/// A ray that takes every hit: the context comes first, as Embree wants it.
struct Collector
{
  RTCIntersectContext Context;
  std::vector<std::pair<float, vtkIdType>>* Hits;
};

void TakeAndGoOn(const RTCFilterFunctionNArguments* arguments)
{
  auto* collector = reinterpret_cast<Collector*>(arguments->context);
  const float t = RTCRayN_tfar(arguments->ray, 1, 0);
  collector->Hits->push_back({ t, RTCHitN_primID(arguments->hit, 1, 0) });
  arguments->valid[0] = 0;
}

/// Triangles in single precision; robust, as exact as Embree gets.
class EmbreeStructure : public Structure
{
public:
  ~EmbreeStructure() override { this->Release(); }

  bool Build(vtkDataSet* data) override
  {
    auto triangles = TrianglesOf(data);
    if (!triangles)
    {
      return false;
    }
    this->Triangles = std::move(*triangles);
    this->Release();
    this->Scene = rtcNewScene(EmbreeDevice());
    rtcSetSceneFlags(
      this->Scene, RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    RTCGeometry geometry = rtcNewGeometry(EmbreeDevice(), RTC_GEOMETRY_TYPE_TRIANGLE);
    this->FillBuffers(geometry, data);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
    return rtcGetDeviceError(EmbreeDevice()) == RTC_ERROR_NONE;
  }

  bool Ask(QueryKind queryKind, const Query& query, Answer& answer) override
  {
    switch (queryKind)
    {
      case QueryKind::ClosestPoint:
        this->Closest(query, std::numeric_limits<double>::infinity(), answer);
        return true;
      case QueryKind::ClosestPointWithinRadius:
        this->Closest(query, query.Radius, answer);
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

  double Precision() const override { return 1e-5; }

private:
  void Release()
  {
    if (this->Scene)
    {
      rtcReleaseScene(this->Scene);
    }
  }

  void FillBuffers(RTCGeometry geometry, vtkDataSet* data)
  {
    const std::size_t count = this->Triangles.size();
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), data->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < 3 * data->GetNumberOfPoints(); ++i)
    {
      points[i] = static_cast<float>(data->GetPoint(i / 3)[i % 3]);
    }
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
    vtkNew<vtkIdList> ids;
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      data->GetCellPoints(static_cast<vtkIdType>(cell), ids);
      for (int i = 0; i < 3; ++i)
      {
        corners[3 * cell + i] = static_cast<unsigned>(ids->GetId(i));
      }
    }
  }

  static RTCRayHit RayOf(const Query& query)
  {
    const Point direction = query.To - query.From;
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(query.From[0]);
    ray.ray.org_y = static_cast<float>(query.From[1]);
    ray.ray.org_z = static_cast<float>(query.From[2]);
    ray.ray.dir_x = static_cast<float>(direction[0]);
    ray.ray.dir_y = static_cast<float>(direction[1]);
    ray.ray.dir_z = static_cast<float>(direction[2]);
    ray.ray.tfar = 1.0f;
    ray.ray.mask = 0xffffffffu;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return ray;
  }

  void FirstHit(const Query& query, Answer& answer)
  {
    RTCRayHit ray = RayOf(query);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->Scene, &context, &ray);
    const bool hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    answer.Cell = hit ? static_cast<vtkIdType>(ray.hit.primID) : -1;
    answer.Value = ray.ray.tfar;
    answer.Where = Lerp(query.From, query.To, answer.Value);
  }

  void AllHits(const Query& query, Answer& answer)
  {
    this->Hits.clear();
    this->Ids.clear();
    RTCRayHit ray = RayOf(query);
    Collector collector;
    rtcInitIntersectContext(&collector.Context);
    collector.Context.filter = TakeAndGoOn;
    collector.Hits = &this->Hits;
    rtcIntersect1(this->Scene, &collector.Context, &ray);
    std::sort(this->Hits.begin(), this->Hits.end());
    for (const auto& hit : this->Hits)
    {
      this->Ids.push_back(hit.second);
    }
    answer.Cells = this->Ids.data();
    answer.NumberOfCells = static_cast<vtkIdType>(this->Ids.size());
  }

  struct Search
  {
    const std::vector<Corners>& Triangles;
    const Point& From;
    Answer& Best;
  };

  static bool Improve(RTCPointQueryFunctionArguments* arguments)
  {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    const Point where = ClosestOnTriangle(search.From, search.Triangles[arguments->primID]);
    const Point gap = where - search.From;
    const double dist2 = Dot(gap, gap);
    if (!(dist2 < search.Best.Value))
    {
      return false;
    }
    search.Best.Value = dist2;
    search.Best.Where = where;
    search.Best.Cell = arguments->primID;
    arguments->query->radius = static_cast<float>(std::sqrt(dist2));
    return true;
  }

  void Closest(const Query& query, double radius, Answer& answer)
  {
    answer.Cell = -1;
    answer.Value = radius * radius;
    Search search{ this->Triangles, query.From, answer };
    RTCPointQuery ball{};
    ball.x = static_cast<float>(query.From[0]);
    ball.y = static_cast<float>(query.From[1]);
    ball.z = static_cast<float>(query.From[2]);
    ball.radius = static_cast<float>(radius);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(this->Scene, &ball, &context, Improve, &search);
  }

  RTCScene Scene = nullptr;
  std::vector<Corners> Triangles;
  std::vector<std::pair<float, vtkIdType>> Hits;
  std::vector<vtkIdType> Ids;
};

}

std::vector<Kind> EmbreeKinds()
{
  return { { "Embree", Family::Peer, [] { return std::make_unique<EmbreeStructure>(); } } };
}

}
