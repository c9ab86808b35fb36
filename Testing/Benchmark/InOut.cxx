// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_inout_benchmark [--answers] points file ...: which points are inside of surfaces, beside
/// VTK's filter and, where it is found, CGAL. A half of the points is anywhere near the bounds, the
/// other close to the surface. Prints a table of processor microseconds a point, searching
/// structures and all (medians of runs that take turns), of how many times the time of axis rays
/// that is, and of the results that are not those of CGAL, or without it of random rays, at points
/// that are farther from the surface than rounding. VTK gets 200 thousand of them at most.
/// With
/// --answers all but VTK run once, for the sake of the last column.
#include "InOut.h"
#include "ProcessorTime.h"

#include "Support/InOutRun.h"
#include "Support/RealMeshes.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkSelectEnclosedPoints.h"

#include <cstdio>
#include <cstdlib>

using namespace skdbench;
using namespace skdtest;

namespace
{
Sides SidesOf(const std::vector<double>& values)
{
  Sides sides;
  std::transform(values.begin(), values.end(), std::back_inserter(sides),
    [](double value) { return static_cast<signed char>(value); });
  return sides;
}

Sides AskVtk(vtkDataSet* points, vtkPolyData* surface)
{
  vtkNew<vtkSelectEnclosedPoints> filter;
  filter->SetInputData(points);
  filter->SetSurfaceData(surface);
  filter->Update();
  return SidesOf(PointArray(filter->GetOutput(), "SelectedPoints"));
}

struct Contender
{
  const char* Name;
  std::function<Sides(vtkDataSet*, vtkPolyData*)> Ask;
  std::size_t Most; // points that it gets
  Sides Answers = {};
  std::vector<double> Seconds = {};
};

/// Triangles turned inward are repaired for the methods that go by normals.
Contender OurMethod(const char* name, int method)
{
  const auto ask = [=](vtkDataSet* points, vtkPolyData* surface)
  {
    InOutPointer filter = MakeInOut(points, surface, method);
    filter->SetRepairOrientation(
      method == InOut::WINDING_NUMBER || method == InOut::NEAREST_FEATURE);
    return SidesOf(RunFor(filter, "SkdInside"));
  };
  return { name, ask, std::numeric_limits<std::size_t>::max() };
}

std::vector<Contender> MakeContenders(bool onlyAnswers)
{
  std::vector<Contender> contenders = { OurMethod("skD-tree, axis rays", InOut::AXIS_RAYS),
    OurMethod("skD-tree, random rays", InOut::RANDOM_RAYS),
    OurMethod("skD-tree, winding number", InOut::WINDING_NUMBER),
    OurMethod("skD-tree, nearest feature", InOut::NEAREST_FEATURE) };
  if (!onlyAnswers)
  {
    contenders.push_back({ "vtkSelectEnclosedPoints", AskVtk, 200000 });
  }
#ifdef SKDBENCH_HAS_CGAL
  contenders.push_back(
    { "CGAL, Side_of_triangle_mesh", AskCgalSides, std::numeric_limits<std::size_t>::max() });
#endif
  return contenders;
}

/// The triangles of a file, points of equal coordinates made one.
PolyDataPointer ReadTriangles(const std::string& file)
{
  const DataSetPointer data = ReadMesh(file);
  return data ? MakePolyData(Triangulated(SurfaceOf(data))) : PolyDataPointer();
}

std::vector<Point> MakePointsNear(vtkPolyData* surface, int count)
{
  Random random(61);
  Bounds box;
  surface->GetBounds(box.data());
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    Point x = random.InBox(Grown(box, 0.05 * Diagonal(box)));
    if (i % 2 == 0)
    {
      vtkCell* cell = surface->GetCell(random.Index(static_cast<int>(surface->GetNumberOfCells())));
      const double away = Diagonal(box) * std::pow(10.0, -2.0 - i % 5);
      cell->GetPoints()->GetPoint(random.Index(3), x.data());
      x = x + away * random.Direction();
    }
    points.push_back(x);
  }
  return points;
}

/// The points whose result may be either.
std::vector<bool> AtSurface(vtkDataSet* points, vtkPolyData* surface)
{
  Bounds box;
  surface->GetBounds(box.data());
  InOutPointer filter = MakeInOut(points, surface);
  filter->SetBoundaryBand(1e-13 * Scale(box));
  const std::vector<double> band = RunFor(filter, "SkdOnBoundary");
  return { band.begin(), band.end() };
}

long CountWrong(const Sides& answers, const Sides& right, const std::vector<bool>& isFree)
{
  long wrong = 0;
  for (std::size_t i = 0; i < answers.size() && i < right.size(); ++i)
  {
    wrong += !isFree[i] && right[i] >= 0 && answers[i] != right[i];
  }
  return wrong;
}

void Measure(const std::string& file, vtkPolyData* surface, int count, bool onlyAnswers)
{
  const std::vector<Point> points = MakePointsNear(surface, count);
  std::vector<Contender> contenders = MakeContenders(onlyAnswers);
  for (int repetition = 0; repetition < (onlyAnswers ? 1 : 3); ++repetition)
  {
    for (Contender& contender : contenders)
    {
      const std::size_t requested = std::min(points.size(), contender.Most);
      const auto queries = MakeQueries({ points.begin(), points.begin() + long(requested) });
      const double start = ProcessorSeconds();
      contender.Answers = contender.Ask(queries, surface);
      contender.Seconds.push_back((ProcessorSeconds() - start) / double(requested));
    }
  }
  const std::vector<bool> isFree = AtSurface(MakeQueries(points), surface);
  const Sides& last = contenders.back().Answers; // CGAL's, which has none of surfaces with gaps
  const bool isByCgal = last.size() == points.size();
  const Sides& right = isByCgal ? last : contenders[1].Answers;
  const double ours = Median(contenders.front().Seconds);
  for (Contender& contender : contenders)
  {
    std::printf("| %s, %lld triangles | %s | %.3f | %.2f | %ld of %zu |\n",
      std::filesystem::path(file).filename().c_str(),
      static_cast<long long>(surface->GetNumberOfCells()), contender.Name,
      1e6 * Median(contender.Seconds), Median(contender.Seconds) / ours,
      CountWrong(contender.Answers, right, isFree), contender.Answers.size());
    std::fflush(stdout);
  }
}

/// Rows of an image against the same points, scattered.
void MeasureImage(const std::string& file, vtkPolyData* surface, int count)
{
  Bounds box;
  surface->GetBounds(box.data());
  const int n = std::max(2, static_cast<int>(std::cbrt(count)));
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->SetOrigin(box[0], box[2], box[4]);
  image->SetSpacing(
    (box[1] - box[0]) / (n - 1), (box[3] - box[2]) / (n - 1), (box[5] - box[4]) / (n - 1));
  std::vector<Point> points(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPoint(i, points[i].data());
  }
  const auto scattered = MakeQueries(points);
  const auto time = [&](vtkDataSet* requested)
  {
    const double start = ProcessorSeconds();
    MakeInOut(requested, surface)->Update();
    return ProcessorSeconds() - start;
  };
  std::vector<double> ratios, seconds;
  for (int repetition = 0; repetition < 5; ++repetition)
  {
    seconds.push_back(time(image));
    ratios.push_back(time(scattered) / seconds.back());
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(seconds.begin(), seconds.end());
  std::printf("| %s, image of %d^3 | skD-tree, by rows; by points | %.3f | 1; %.2f | |\n",
    std::filesystem::path(file).filename().c_str(), n, 1e6 * seconds[2] / double(points.size()),
    ratios[2]);
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  const bool onlyAnswers = argc > 1 && std::string(argv[1]) == "--answers";
  const int first = onlyAnswers ? 2 : 1;
  if (argc < first + 2)
  {
    std::fprintf(stderr, "usage: skdtree_inout_benchmark [--answers] points file ...\n");
    return 1;
  }
  const int count = std::atoi(argv[first]);
  std::printf("| surface | by | us a point | x | other than it should be |\n");
  std::printf("| --- | --- | ---: | ---: | ---: |\n");
  for (int i = first + 1; i < argc; ++i)
  {
    const PolyDataPointer surface = ReadTriangles(argv[i]);
    if (surface && surface->GetNumberOfCells() > 0)
    {
      Measure(argv[i], surface, count, onlyAnswers);
      if (!onlyAnswers)
      {
        MeasureImage(argv[i], surface, count);
      }
    }
  }
  return 0;
}
