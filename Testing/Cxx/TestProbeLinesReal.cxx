// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe along lines through meshes that other people made: tetrahedra, inverted
// hexahedra, polyhedra that are not convex.

#include "Support/OnFile.h"
#include "Support/ProbeRun.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class LinesThroughFile : public OnFile
{
protected:
  void SetUp() override
  {
    OnFile::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Source = ReadMesh(GetParam());
    this->Source->GetPointData()->Initialize();
    this->Source->GetCellData()->Initialize();
    WithData(this->Source);
    this->Source->GetBounds(this->Box.data());
    Random random(81);
    for (int i = 0; i < 40; ++i)
    {
      this->From.push_back(random.InBox(this->Box));
      this->To.push_back(random.InBox(this->Box));
    }
  }

  PolyDataPointer MakeLines() const
  {
    Mesh lines;
    for (std::size_t i = 0; i < this->From.size(); ++i)
    {
      const vtkIdType first = lines.Add(this->From[i]);
      lines.Add(VTK_LINE, { first, lines.Add(this->To[i]) });
    }
    return MakePolyData(lines);
  }

  DataSetPointer Source;
  Bounds Box;
  std::vector<Point> From, To;
};

INSTANTIATE_TEST_SUITE_P(
  Shipped, LinesThroughFile, testing::ValuesIn(VolumeFiles(DataFolder())), NameOfFile());
INSTANTIATE_TEST_SUITE_P(
  Extra, LinesThroughFile, testing::ValuesIn(VolumeFiles(ExtraDataFolder())), NameOfFile());

TEST_P(LinesThroughFile, TheMiddleOfEachIntervalIsInItsCell)
{
  ProbePointer probe = MakeProbe(this->MakeLines(), this->Source);
  const Intervals found(probe);
  ASSERT_GT(found.Cells.size(), 40u);
  std::vector<Point> middles;
  for (std::size_t k = 0; k < found.Cells.size(); ++k)
  {
    middles.push_back(Lerp(found.From[k], found.To[k], 0.5));
  }
  ProbePointer points = MakeProbe(MakeQueries(middles), this->Source);
  points->SetRelativeTolerance(0.0);
  const std::vector<double> cells = ProbeArray(points, "SkdSourceCellId");
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    const bool isShort = found.Lengths[k] < 1e-9 * Diagonal(this->Box);
    ASSERT_TRUE(cells[k] == found.Cells[k] || isShort) << k;
  }
}

TEST_P(LinesThroughFile, PointsBetweenIntervalsAreOutside)
{
  ProbePointer probe = MakeProbe(this->MakeLines(), this->Source);
  const Intervals found(probe);
  std::vector<Point> between;
  double last = 0.0;
  for (std::size_t k = 0; k < found.Cells.size(); ++k)
  {
    const bool isSameLine = k > 0 && found.Lines[k] == found.Lines[k - 1];
    const auto line = static_cast<std::size_t>(found.Lines[k]);
    const double length = Distance(this->From[line], this->To[line]);
    last = isSameLine ? last : 0.0;
    ASSERT_GE(found.Entries[k], last);
    ASSERT_LE(found.Exits[k], length * (1 + 1e-12));
    if (found.Entries[k] - last > 1e-6 * length)
    {
      between.push_back(
        Lerp(this->From[line], this->To[line], 0.5 * (found.Entries[k] + last) / length));
    }
    last = found.Exits[k];
  }
  ProbePointer points = MakeProbe(MakeQueries(between), this->Source);
  points->SetRelativeTolerance(0.0);
  const std::vector<double> valid = ProbeArray(points, "SkdValid");
  EXPECT_EQ(std::count(valid.begin(), valid.end(), 1), 0);
}

TEST_P(LinesThroughFile, IntegralsOfALinearFieldAreExact)
{
  ProbePointer probe = MakeProbe(this->MakeLines(), this->Source);
  const Intervals found(probe);
  std::vector<double> expected(this->From.size(), 0.0);
  std::vector<double> within(this->From.size(), 0.0);
  for (std::size_t k = 0; k < found.Cells.size(); ++k)
  {
    const auto line = static_cast<std::size_t>(found.Lines[k]);
    expected[line] += found.Lengths[k] * 0.5 * (Linear(found.From[k]) + Linear(found.To[k]));
    within[line] += found.Lengths[k];
  }
  const std::vector<double> integrals = IntegralsOf(probe, "Linear_Integral");
  const std::vector<double> lengths = IntegralsOf(probe, "SkdLength");
  ASSERT_EQ(integrals.size(), expected.size());
  const double size = Scale(this->Box);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(integrals[i], expected[i], 1e-11 * size * (size + 7)) << i;
    EXPECT_NEAR(lengths[i], within[i], 1e-12 * size) << i;
  }
}

}
