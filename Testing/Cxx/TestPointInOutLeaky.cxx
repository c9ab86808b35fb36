// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut on surfaces that leak, of the folder SKDTREE_EXTRA_DATA_DIR if it is there:
// at points that are marked by closed versions of them no more are wrong than by
// vtkSelectEnclosedPoints.

#include "Support/ClosedVersion.h"
#include "Support/Folders.h"
#include "Support/InOutRun.h"
#include "Support/RealMeshes.h"
#include "Support/TestAmount.h"

#include "vtkSelectEnclosedPoints.h"
#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

using namespace skdtest;

namespace
{

struct Leaky
{
  const char* File;
  double Ball; // radius by the diagonal of what must not reach points inside; 0: fans alone mark
  const char* ClosedBy = nullptr; // the same surface without gaps

  friend void PrintTo(const Leaky& leaky, std::ostream* os) { *os << leaky.File; }
};

struct Marks
{
  std::vector<Point> Points;
  std::vector<double> Inside;

  void Add(const Point& x, bool isInside)
  {
    this->Points.push_back(x);
    this->Inside.push_back(isInside ? 1 : 0);
  }

  /// So many of each kind, spread over all.
  Marks Some(int each) const
  {
    Marks some;
    for (const double kind : { 0.0, 1.0 })
    {
      const auto all = std::count(this->Inside.begin(), this->Inside.end(), kind);
      double found = 0.0;
      for (std::size_t i = 0; i < this->Points.size(); ++i)
      {
        const double before = found;
        found += this->Inside[i] == kind ? std::min(1.0, double(each) / double(all)) : 0.0;
        if (std::floor(found) > std::floor(before))
        {
          some.Add(this->Points[i], kind == 1.0);
        }
      }
    }
    return some;
  }

  int CountWrong(const std::vector<double>& answers) const
  {
    int wrong = 0;
    for (std::size_t i = 0; i < this->Inside.size(); ++i)
    {
      wrong += answers[i] != this->Inside[i];
    }
    return wrong;
  }
};

std::vector<double> InsideOf(const std::vector<Point>& points, const Mesh& closed)
{
  InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(closed));
  std::vector<double> inside = RunFor(filter, "SkdInside");
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
  return inside;
}

/// By the fans, and not close to one.
Marks MarkByFans(vtkPolyData* surface, const ClosedVersion& closed)
{
  Bounds box;
  surface->GetBounds(box.data());
  Random random(73);
  std::vector<Point> points;
  for (int i = 0; i < 12000; ++i)
  {
    points.push_back(random.InBox(box));
  }
  const std::vector<double> inside = InsideOf(points, closed.Whole);
  const PolyDataPointer fans = MakePolyData(closed.Fans);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(fans);
  locator->BuildLocator();
  Marks marks;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double nearest[3], dist2;
    vtkIdType cell;
    int subId;
    if (!locator->FindClosestPointWithinRadius(
          points[i].data(), 0.01 * Diagonal(box), nearest, cell, subId, dist2))
    {
      marks.Add(points[i], inside[i] == 1);
    }
  }
  return marks;
}

/// Where a ball and the fans agree.
Marks MarkByBall(vtkPolyData* surface, const ClosedVersion& closed, double radius)
{
  Bounds box;
  surface->GetBounds(box.data());
  const BallRadius maxDistance(surface, radius * Diagonal(box));
  const std::vector<double> inside = InsideOf(maxDistance.Points, closed.Whole);
  Marks marks;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    if ((inside[i] == 1) != maxDistance.IsCovered[i] && Contains(box, maxDistance.Points[i]))
    {
      marks.Add(maxDistance.Points[i], inside[i] == 1);
    }
  }
  return marks;
}

Marks MarkByMesh(vtkPolyData* surface, const std::string& file)
{
  Marks marks;
  for (const Point& x : RandomQueries(surface, 12000))
  {
    marks.Points.push_back(x);
  }
  marks.Inside = InsideOf(marks.Points, Triangulated(SurfaceOf(ReadMesh(file))));
  return marks;
}

class PointInOutLeaky : public testing::TestWithParam<Leaky>
{
};

INSTANTIATE_TEST_SUITE_P(Extra, PointInOutLeaky,
  testing::Values(Leaky{ "elephant-with-holes.vtp", 0.0, "elephant.vtp" },
    Leaky{ "pig_open.stl", 0.0 }, Leaky{ "bearing_occt.stl", 0.0 },
    Leaky{ "motorBike.vtp", 0.014 }));

TEST_P(PointInOutLeaky, NoMorePointsAreWrongThanByVtk)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const std::string folder = ExtraDataFolder() + "/A_surface/";
  const Leaky& leaky = GetParam();
  if (!std::filesystem::exists(folder + leaky.File))
  {
    GTEST_SKIP() << "no meshes in " << folder;
  }
  const Mesh mesh = Triangulated(SurfaceOf(ReadMesh(folder + leaky.File)));
  const PolyDataPointer surface = MakePolyData(mesh);
  const ClosedVersion closed(mesh);
  const Marks marks = (leaky.ClosedBy ? MarkByMesh(surface, folder + leaky.ClosedBy)
      : leaky.Ball > 0.0              ? MarkByBall(surface, closed, leaky.Ball)
                                      : MarkByFans(surface, closed))
                        .Some(1000);
  ASSERT_GT(std::count(marks.Inside.begin(), marks.Inside.end(), 1), 500);
  const auto input = MakeQueries(marks.Points);
  vtkNew<vtkSelectEnclosedPoints> other;
  other->SetInputData(input);
  other->SetSurfaceData(surface);
  other->Update();
  const int theirs = marks.CountWrong(PointArray(other->GetOutput(), "SelectedPoints"));
  RecordProperty("WrongByVtk", theirs);
  std::map<int, int> ours;
  for (int method :
    { InOut::AXIS_RAYS, InOut::RANDOM_RAYS, InOut::WINDING_NUMBER, InOut::AUTOMATIC })
  {
    ours[method] = marks.CountWrong(RunFor(MakeInOut(input, surface, method), "SkdInside"));
    EXPECT_LE(ours[method], theirs) << method;
    RecordProperty("WrongBy" + std::to_string(method), ours[method]);
  }
  EXPECT_LE(ours[InOut::AUTOMATIC], ours[InOut::WINDING_NUMBER]);
}

}
