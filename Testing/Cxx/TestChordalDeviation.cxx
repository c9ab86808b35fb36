// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// A curved cell reaches beyond the box of its points, but not beyond its safety box; a straight one
// does not reach beyond at all.

#include "Support/LocatorCalls.h"
#include "Support/ParametricReference.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

struct Kind
{
  int Type;
  int Order;
};

std::vector<Kind> Kinds()
{
  std::vector<Kind> kinds;
  for (int type : AllCellTypes())
  {
    for (int order = 1; order <= (IsHigherOrder(type) ? HighestOrder() + 1 : 1); ++order)
    {
      if (DomainOf(type) != Domain::None)
      {
        kinds.push_back({ type, order });
      }
    }
  }
  return kinds;
}

std::string NameOfKind(const testing::TestParamInfo<Kind>& info)
{
  return NameOfType(info.param.Type) + "Order" + std::to_string(info.param.Order);
}

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << NameOfType(kind.Type);
}

class ChordalDeviation : public testing::TestWithParam<Kind>
{
protected:
  /// The points of the pyramid of 13 points are where its parametric coordinates are, those of a
  /// cube: drawn together towards the tip they are those of a straight pyramid.
  static Mesh StraightCell()
  {
    Mesh cell = ReferenceCell(GetParam().Type, GetParam().Order);
    return GetParam().Type != VTK_QUADRATIC_PYRAMID
      ? cell
      : cell.Map(
          [](const Point& p) -> Point {
            return { p[0] * (1 - p[2]), p[1] * (1 - p[2]), p[2] };
          });
  }
};

INSTANTIATE_TEST_SUITE_P(All, ChordalDeviation, testing::ValuesIn(Kinds()), NameOfKind);

Bounds SafetyBoxOf(vtkSkdTreeCellLocator* locator)
{
  vtkNew<vtkDoubleArray> boxes;
  locator->GetSafetyBoxes(boxes);
  Bounds box;
  boxes->GetTuple(0, box.data());
  return box;
}

Point PointIn(Random& random, const ParametricCell& cell)
{
  Point p;
  do
  {
    p = { random.Between(-1, 1), random.Between(0, 1), random.Between(0, 1) };
    p[1] = cell.Dimension() > 1 ? p[1] : 0.0;
    p[2] = cell.Dimension() > 2 ? p[2] : 0.0;
  } while (!cell.Contains(p));
  return p;
}

TEST_P(ChordalDeviation, StaysInTheSafetyBox)
{
  Random random(140);
  for (int shape = 0; shape < 10; ++shape)
  {
    const double size = 0.05 * shape;
    const auto grid = MakeGrid(StraightCell().Map(
      [&](const Point& p)
      {
        return Bent(p) +
          Point{ random.Between(-size, size), random.Between(-size, size),
            random.Between(-size, size) };
      }));
    const Bounds box = SafetyBoxOf(MakeLocator(grid));
    vtkNew<vtkGenericCell> loaded;
    grid->GetCell(0, loaded);
    ParametricCell cell(loaded->GetRepresentativeCell());
    for (int i = 0; i < 400; ++i)
    {
      const Point x = cell.At(PointIn(random, cell));
      ASSERT_EQ(Distance(box, x), 0.0) << "shape " << shape;
    }
  }
}

TEST_P(ChordalDeviation, OfAStraightCellIsNothingButRounding)
{
  const auto grid = MakeGrid(StraightCell().Map(Rotated));
  const auto locator = MakeLocator(grid);
  const Bounds box = SafetyBoxOf(locator);
  for (int side = 0; side < 6; ++side)
  {
    EXPECT_NEAR(box[side], grid->GetBounds()[side], 1e-6);
  }
}

}
