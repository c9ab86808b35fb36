// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Measures/MeasureInBox.h"
#include "CoreScenes.h"

#include <gtest/gtest.h>

#include <array>

using namespace coretest;

namespace
{

using skd::Box3;
using skd::Vector3;
using Triangles = std::vector<std::array<Vector3, 3>>;

/// The boundary of a box, normals out.
Triangles BoxSurface(const Box3& box)
{
  Triangles triangles;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const auto corner = [&](int u, int v)
      {
        Vector3 p;
        p[axis] = side ? box.Max[axis] : box.Min[axis];
        p[(axis + 1) % 3] = u ? box.Max[(axis + 1) % 3] : box.Min[(axis + 1) % 3];
        p[(axis + 2) % 3] = v ? box.Max[(axis + 2) % 3] : box.Min[(axis + 2) % 3];
        return p;
      };
      const Vector3 a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      triangles.push_back(
        side ? std::array<Vector3, 3>{ a, b, c } : std::array<Vector3, 3>{ a, c, b });
      triangles.push_back(
        side ? std::array<Vector3, 3>{ a, c, d } : std::array<Vector3, 3>{ a, d, c });
    }
  }
  return triangles;
}

double MeasureOf(const Triangles& triangles, const Box3& box, unsigned corner, bool isInside)
{
  skd::MeasureInBox measure(box, corner);
  for (const auto& t : triangles)
  {
    measure.Add(t[0], t[1], t[2]);
  }
  return measure.Measure(isInside);
}

Vector3 CornerOf(const Box3& box, unsigned corner)
{
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = corner >> axis & 1u ? box.Max[axis] : box.Min[axis];
  }
  return p;
}

double Common(const Box3& a, const Box3& b)
{
  double measure = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = std::max(a.Min[axis], b.Min[axis]);
    const double high = std::min(a.Max[axis], b.Max[axis]);
    const bool isFlat = b.Length(axis) == 0.0;
    measure *= isFlat ? (low <= high ? 1.0 : 0.0) : std::max(high - low, 0.0);
  }
  return measure;
}

/// On a coarse grid sides, edges and corners coincide all the time.
TEST(MeasureInBox, OfABoxIsWhatTheyHaveInCommon)
{
  Random random(5);
  int requested = 0;
  for (int i = 0; i < 60000; ++i)
  {
    const bool isGrid = i % 2 == 0;
    const auto coordinate = [&]
    { return isGrid ? static_cast<double>(random.Below(5)) : random.In(0.0, 4.0); };
    Box3 body;
    Box3 box;
    for (int k = 0; k < 2; ++k)
    {
      body.Add(Vector3{ { coordinate(), coordinate(), coordinate() } });
      box.Add(Vector3{ { coordinate(), coordinate(), coordinate() } });
    }
    const bool isSolid = body.Length(0) * body.Length(1) * body.Length(2) > 0.0;
    bool isOn = false; // a flat box in a side of the body
    for (int axis = 0; axis < 3; ++axis)
    {
      isOn |= box.Length(axis) == 0.0 &&
        (box.Min[axis] == body.Min[axis] || box.Min[axis] == body.Max[axis]);
    }
    const bool isPoint = box.Diagonal() == 0.0;
    const auto corner = static_cast<unsigned>(random.Below(8));
    const Vector3 p = CornerOf(box, corner);
    bool isInside = true;
    bool isAway = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      isInside &= body.Min[axis] < p[axis] && p[axis] < body.Max[axis];
      isAway |= body.Min[axis] > p[axis] || p[axis] > body.Max[axis];
    }
    if (!isSolid || isOn || isPoint || (!isInside && !isAway))
    {
      continue;
    }
    ++requested;
    ASSERT_NEAR(MeasureOf(BoxSurface(body), box, corner, isInside), Common(body, box), 1e-12) << i;
  }
  EXPECT_GT(requested, 10000);
}

Triangles Tetrahedron(const std::array<Vector3, 4>& p)
{
  const bool isRight = Dot(Cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0.0;
  Triangles t{ { p[0], p[2], p[1] }, { p[0], p[1], p[3] }, { p[1], p[2], p[3] },
    { p[2], p[0], p[3] } };
  for (auto& triangle : t)
  {
    if (!isRight)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return t;
}

double VolumeOf(const std::array<Vector3, 4>& p)
{
  return std::abs(Dot(Cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6.0;
}

bool IsInTetrahedron(const Triangles& t, const Vector3& x)
{
  bool isInside = true;
  for (const auto& f : t)
  {
    isInside &= Dot(Cross(f[1] - f[0], f[2] - f[0]), x - f[0]) < 0.0;
  }
  return isInside;
}

/// The parts of a box add up to what is in the box, and all boxes to the body.
TEST(MeasureInBox, PartsAddUpToTheWhole)
{
  Random random(6);
  for (int i = 0; i < 300; ++i)
  {
    const bool isGrid = i % 3 == 0; // corners of the body on corners, edges and sides of boxes
    std::array<Vector3, 4> p;
    for (Vector3& corner : p)
    {
      corner = random.Point<3>(0.0, 4.0);
      for (int axis = 0; axis < 3 && isGrid; ++axis)
      {
        corner[axis] = std::round(corner[axis]);
      }
    }
    const Triangles body = Tetrahedron(p);
    if (VolumeOf(p) == 0.0)
    {
      continue;
    }
    double sum = 0.0;
    for (int cell = 0; cell < 64; ++cell)
    {
      const Vector3 low{ { cell % 4 + 0.0, cell / 4 % 4 + 0.0, cell / 16 + 0.0 } };
      const Box3 box(low, low + Vector3{ { 1.0, 1.0, 1.0 } });
      // A corner away from the surface, if there is one.
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        double highest = -1.0;
        for (const auto& f : body)
        {
          const Vector3 n = Cross(f[1] - f[0], f[2] - f[0]);
          highest = std::max(highest, Dot(n, CornerOf(box, corner) - f[0]) / Norm(n));
        }
        if (std::abs(highest) > 1e-9)
        {
          const double measure =
            MeasureOf(body, box, corner, IsInTetrahedron(body, CornerOf(box, corner)));
          ASSERT_GE(measure, -1e-12);
          ASSERT_LE(measure, 1.0 + 1e-12);
          sum += measure;
          break;
        }
        ASSERT_LT(corner, 7u);
      }
    }
    ASSERT_NEAR(sum, VolumeOf(p), 1e-11) << i;
  }
}

TEST(MeasureInBox, EveryCornerGivesTheSame)
{
  Random random(7);
  for (int i = 0; i < 2000; ++i)
  {
    std::array<Vector3, 4> p;
    for (Vector3& corner : p)
    {
      corner = random.Point<3>(-1.0, 2.0);
    }
    const Triangles body = Tetrahedron(p);
    Box3 box({ { 0.0, 0.0, 0.0 } }, { { 1.0, 0.7, 0.4 } });
    for (int flat = 0; flat <= i % 3; ++flat)
    {
      box.Max[(i + flat) % 3] = flat > 0 ? box.Min[(i + flat) % 3] : box.Max[(i + flat) % 3];
    }
    double first = 0.0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const double measure =
        MeasureOf(body, box, corner, IsInTetrahedron(body, CornerOf(box, corner)));
      first = corner == 0 ? measure : first;
      ASSERT_NEAR(measure, first, 1e-12) << i << " " << corner;
    }
  }
}

}
