// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sets of boxes that trees are tried on: the usual, the degenerate, the tiny, huge and far.
#ifndef coretest_CoreScenes_h
#define coretest_CoreScenes_h

#include "Core/Geometry/Box.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace coretest
{

template <int D>
using Boxes = std::vector<skd::Box<D>>;

template <int D>
struct Scene
{
  std::string Name;
  coretest::Boxes<D> Boxes;
};

/// Random numbers of a fixed seed.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  double In(double low, double high)
  {
    return low + (high - low) * std::ldexp(static_cast<double>(this->Engine() >> 11), -53);
  }
  std::size_t Below(std::size_t count) { return static_cast<std::size_t>(this->Engine() % count); }

  template <int D>
  skd::Vector<D> Point(double low, double high)
  {
    skd::Vector<D> point;
    for (int axis = 0; axis < D; ++axis)
    {
      point[axis] = this->In(low, high);
    }
    return point;
  }

  template <int D>
  skd::Vector<D> Point(const skd::Box<D>& box)
  {
    skd::Vector<D> point;
    for (int axis = 0; axis < D; ++axis)
    {
      // Rounding must not carry it out of a thin box.
      point[axis] =
        std::clamp(this->In(box.Min[axis], box.Max[axis]), box.Min[axis], box.Max[axis]);
    }
    return point;
  }

  template <int D>
  skd::Vector<D> Corner(const skd::Box<D>& box)
  {
    skd::Vector<D> corner;
    for (int axis = 0; axis < D; ++axis)
    {
      corner[axis] = this->Below(2) == 0 ? box.Min[axis] : box.Max[axis];
    }
    return corner;
  }

  template <int D>
  skd::Vector<D> Direction()
  {
    for (;;)
    {
      const skd::Vector<D> direction = this->Point<D>(-1.0, 1.0);
      const double length = Norm(direction);
      if (length > 0.1 && length <= 1.0)
      {
        return (1.0 / length) * direction;
      }
    }
  }

private:
  std::mt19937_64 Engine;
};

template <int D>
skd::Vector<D> Filled(double value)
{
  skd::Vector<D> vector;
  std::fill_n(vector.X, D, value);
  return vector;
}

/// The vector of zeros with `value` at `axis`.
template <int D>
skd::Vector<D> Along(int axis, double value)
{
  skd::Vector<D> vector = Filled<D>(0.0);
  vector[axis] = value;
  return vector;
}

template <int D>
skd::Box<D> BoxAround(const skd::Vector<D>& centre, const skd::Vector<D>& half)
{
  return skd::Box<D>(centre - half, centre + half);
}

template <int D>
skd::Box<D> BoundsOf(const Boxes<D>& boxes)
{
  skd::Box<D> bounds;
  for (const skd::Box<D>& box : boxes)
  {
    bounds.Add(box);
  }
  return bounds;
}

/// A box in which to look around a set: as large again on every side, and never flat.
template <int D>
skd::Box<D> Around(const Boxes<D>& boxes)
{
  const skd::Box<D> bounds = BoundsOf(boxes);
  double size = 0.0;
  for (int axis = 0; axis < D && !bounds.IsEmpty(); ++axis)
  {
    size = std::max(size, bounds.Length(axis));
  }
  return bounds.IsEmpty() ? BoxAround(Filled<D>(0.0), Filled<D>(1.0))
                          : bounds.Inflated(size > 0.0 ? 0.5 * size : 1.0);
}

/// Boxes in about [-1, 1], n of them, by a rule for the i-th.
template <int D, class Rule>
Boxes<D> Generate(std::size_t n, Rule rule)
{
  Boxes<D> boxes;
  for (std::size_t i = 0; i < n; ++i)
  {
    boxes.push_back(rule(i));
  }
  return boxes;
}

template <int D>
Boxes<D> RandomBoxes(std::size_t n, std::uint64_t seed = 1)
{
  Random random(seed);
  const double half = 0.6 * std::pow(static_cast<double>(n) + 1.0, -1.0 / D);
  return Generate<D>(n,
    [&](std::size_t) { return BoxAround(random.Point<D>(-1.0, 1.0), random.Point<D>(0.0, half)); });
}

template <int D>
Boxes<D> ClusteredBoxes(std::size_t n)
{
  Random random(2);
  const auto nearCentre = [&](std::size_t i)
  {
    Random cluster(i % 5);
    const skd::Vector<D> centre = cluster.Point<D>(-1.0, 1.0);
    return BoxAround(centre + random.Point<D>(-1e-3, 1e-3), random.Point<D>(0.0, 1e-4));
  };
  return Generate<D>(n, nearCentre);
}

template <int D>
Boxes<D> EqualBoxes(std::size_t n)
{
  return Boxes<D>(n, BoxAround(Filled<D>(0.25), Filled<D>(0.5)));
}

/// Nested about one centre: no median separates them.
template <int D>
Boxes<D> NestedBoxes(std::size_t n)
{
  return Generate<D>(n,
    [n](std::size_t i)
    {
      return BoxAround(
        Filled<D>(0.0), Filled<D>(static_cast<double>(i + 1) / static_cast<double>(n)));
    });
}

/// Touching one another along the first axis, in order.
template <int D>
Boxes<D> LineOfBoxes(std::size_t n)
{
  return Generate<D>(n,
    [](std::size_t i)
    {
      const double at = static_cast<double>(i);
      return skd::Box<D>(Along<D>(0, at), Along<D>(0, at + 1.0));
    });
}

/// In a plane (D = 1: a point), at a height that is no short binary fraction.
template <int D>
Boxes<D> FlatBoxes(std::size_t n)
{
  Boxes<D> boxes = RandomBoxes<D>(n, 3);
  for (skd::Box<D>& box : boxes)
  {
    box.Min[D - 1] = box.Max[D - 1] = 0.3;
  }
  return boxes;
}

template <int D>
Boxes<D> PointBoxes(std::size_t n)
{
  Random random(4);
  return Generate<D>(n,
    [&](std::size_t)
    {
      const skd::Vector<D> point = random.Point<D>(-1.0, 1.0);
      return skd::Box<D>(point, point);
    });
}

/// Long along one axis, all but nothing along the others.
template <int D>
Boxes<D> SliverBoxes(std::size_t n)
{
  Random random(5);
  return Generate<D>(n,
    [&](std::size_t i)
    {
      skd::Vector<D> half = random.Point<D>(0.0, 1e-7);
      half[static_cast<int>(i % D)] = random.In(0.5, 1.0);
      return BoxAround(random.Point<D>(-1.0, 1.0), half);
    });
}

/// Sizes and distances to a corner over ten decades.
template <int D>
Boxes<D> GradedBoxes(std::size_t n)
{
  Random random(6);
  return Generate<D>(n,
    [&](std::size_t)
    {
      const double size = std::pow(10.0, random.In(-10.0, 0.0));
      return BoxAround(size * random.Point<D>(0.0, 1.0), size * random.Point<D>(0.0, 0.3));
    });
}

/// Each box about four times.
template <int D>
Boxes<D> DuplicateBoxes(std::size_t n)
{
  Boxes<D> boxes = RandomBoxes<D>(n, 7);
  for (std::size_t i = 0; i < n; ++i)
  {
    boxes[i] = boxes[i % (n / 4 + 1)];
  }
  return boxes;
}

/// Cells of a lattice: most pairs touch in a face, an edge or a corner and nowhere else.
template <int D>
Boxes<D> LatticeBoxes(std::size_t n)
{
  const auto side = static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(n), 1.0 / D)));
  return Generate<D>(n,
    [side](std::size_t i)
    {
      skd::Vector<D> corner;
      for (int axis = 0; axis < D; ++axis, i /= side)
      {
        corner[axis] = static_cast<double>(i % side);
      }
      return skd::Box<D>(corner, corner + Filled<D>(1.0));
    });
}

template <int D>
Boxes<D> Transformed(Boxes<D> boxes, double scale, double offset)
{
  for (skd::Box<D>& box : boxes)
  {
    box.Min = scale * box.Min + Filled<D>(offset);
    box.Max = scale * box.Max + Filled<D>(offset);
  }
  return boxes;
}

/// One of each kind. Those whose squared lengths leave the range of double only on demand.
template <int D>
std::vector<Scene<D>> AllScenes(std::size_t n, bool withUnsquarable)
{
  std::vector<Scene<D>> scenes{ { "random", RandomBoxes<D>(n) },
    { "clustered", ClusteredBoxes<D>(n) }, { "equal", EqualBoxes<D>(n) },
    { "nested", NestedBoxes<D>(n) }, { "line", LineOfBoxes<D>(n) }, { "flat", FlatBoxes<D>(n) },
    { "points", PointBoxes<D>(n) }, { "slivers", SliverBoxes<D>(n) },
    { "graded", GradedBoxes<D>(n) }, { "duplicates", DuplicateBoxes<D>(n) },
    { "lattice", LatticeBoxes<D>(n) },
    { "offset 1e9", Transformed<D>(RandomBoxes<D>(n), 1.0, 1e9) },
    { "flat, offset 1e9", Transformed<D>(FlatBoxes<D>(n), 1.0, 1e9) },
    { "offset 1e15", Transformed<D>(RandomBoxes<D>(n), 100.0, 1e15) },
    { "scale 1e-150", Transformed<D>(RandomBoxes<D>(n), 1e-150, 0.0) },
    { "scale 1e150", Transformed<D>(RandomBoxes<D>(n), 1e150, 0.0) } };
  if (withUnsquarable)
  {
    scenes.push_back({ "scale 1e-300", Transformed<D>(RandomBoxes<D>(n), 1e-300, 0.0) });
    scenes.push_back({ "scale 1e300", Transformed<D>(RandomBoxes<D>(n), 1e300, 0.0) });
  }
  for (Scene<D>& scene : scenes)
  {
    scene.Name += ", " + std::to_string(n) + " boxes";
  }
  return scenes;
}

/// Query points: around and inside, at corners and in boxes, at the middle, and far away.
template <int D>
std::vector<skd::Vector<D>> QueryPoints(const Boxes<D>& boxes)
{
  Random random(8);
  const skd::Box<D> around = Around(boxes);
  std::vector<skd::Vector<D>> points{ around.Centroid(),
    around.Centroid() + (100.0 * around.Length(0)) * random.Direction<D>() };
  for (int i = 0; i < 3; ++i)
  {
    points.push_back(random.Point(around));
    if (!boxes.empty())
    {
      points.push_back(random.Corner(boxes[random.Below(boxes.size())]));
      points.push_back(random.Point(boxes[random.Below(boxes.size())]));
    }
  }
  return points;
}

}

#endif
