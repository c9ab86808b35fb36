// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every type of cell in every filter and the locator, whole and harmed: no crash; cells that are
// broken are named once, and the results are those without them. SKDTREE_ALL_HARMS=all runs all
// combinations, or those of one type by its number; by default each filter gets a part of 32.

#include "Support/EachFilter.h"
#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/HarmedMeshes.h"
#include "Support/MessageCounter.h"

#include "vtkSkdTreeCellLocator.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

using namespace skdtest;

namespace
{

/// The messages about broken cells.
class BrokenCounter : public MessageCounter
{
public:
  explicit BrokenCounter(vtkObject* watched)
    : MessageCounter(watched, "Broken cells are ignored")
  {
  }
};

std::vector<double> RunSetup(const FilterSetup& setup, vtkDataSet* mesh, bool isBroken)
{
  const auto filter = setup.Make(mesh);
  BrokenCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, isBroken ? 1 : 0) << counter.Last;
  return AnswersOf(filter);
}

/// By default of all combinations so many, the same ones each time.
bool IsDrawn(std::size_t filter, int type, int harm)
{
  const char* wanted = std::getenv("SKDTREE_ALL_HARMS");
  if (wanted)
  {
    return std::strcmp(wanted, "all") == 0 || std::atoi(wanted) == type;
  }
  const std::size_t number =
    (filter * 97 + static_cast<std::size_t>(type)) * 31 + static_cast<std::size_t>(harm);
  return (number * 2654435761u >> 7) % 32 == 0;
}

/// What a crash is in.
void Announce(const std::string& what)
{
  if (std::getenv("SKDTREE_ALL_HARMS"))
  {
    std::cerr << what << std::endl;
  }
}

class HarmedCells : public EachFilter
{
};

INSTANTIATE_TEST_SUITE_P(Filters, HarmedCells,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

TEST_P(HarmedCells, DoNoHarm)
{
  for (const int type : AllCellTypes())
  {
    for (int harm = 0; harm < NumberOfHarms; ++harm)
    {
      const GridPointer mesh =
        IsDrawn(GetParam(), type, harm) ? MakeHarmed(type, static_cast<Harm>(harm)) : nullptr;
      if (!mesh)
      {
        continue;
      }
      SCOPED_TRACE(NameOfType(type) + " " + NameOf(static_cast<Harm>(harm)));
      Announce(this->Setup.Name + " " + NameOfType(type) + " " + NameOf(static_cast<Harm>(harm)));
      const bool isBroken = IsBroken(static_cast<Harm>(harm));
      const std::vector<double> answers = RunSetup(this->Setup, WithData(mesh), isBroken);
      if (isBroken)
      {
        const GridPointer rest = WithData(MakeWithoutHarmed(type, static_cast<Harm>(harm)));
        EXPECT_TRUE(AreEqual(answers, RunSetup(this->Setup, rest, false)));
      }
    }
  }
}

TEST_P(HarmedCells, OfPolyDataDoNoHarm)
{
  for (const int type : { VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON, VTK_TRIANGLE_STRIP })
  {
    for (int harm = 0; harm < NumberOfHarms; ++harm)
    {
      const PolyDataPointer mesh = IsDrawn(GetParam(), type + 1, harm)
        ? MakeHarmedPolyData(type, static_cast<Harm>(harm), harm % 2 == 0)
        : nullptr;
      if (!mesh)
      {
        continue;
      }
      SCOPED_TRACE(NameOfType(type) + " " + NameOf(static_cast<Harm>(harm)));
      const bool isBroken = IsBroken(static_cast<Harm>(harm));
      const std::vector<double> answers = RunSetup(this->Setup, WithData(mesh), isBroken);
      if (isBroken)
      {
        const PolyDataPointer rest =
          WithData(MakePolyDataWithoutHarmed(type, static_cast<Harm>(harm)));
        EXPECT_TRUE(AreEqual(answers, RunSetup(this->Setup, rest, false)));
      }
    }
  }
}

TEST(HarmedCellsOfLocator, DoNoHarm)
{
  QuietWindow quiet;
  for (const int type : AllCellTypes())
  {
    for (int harm = 0; harm < NumberOfHarms; ++harm)
    {
      const GridPointer mesh = MakeHarmed(type, static_cast<Harm>(harm));
      if (mesh && IsDrawn(99, type, harm))
      {
        SCOPED_TRACE(NameOfType(type) + " " + NameOf(static_cast<Harm>(harm)));
        const std::vector<double> answers = LocatorAnswers(mesh);
        if (IsBroken(static_cast<Harm>(harm)))
        {
          const GridPointer rest = MakeWithoutHarmed(type, static_cast<Harm>(harm));
          EXPECT_EQ(answers, LocatorAnswers(rest));
        }
      }
    }
  }
}

TEST(BrokenCells, AreNamedOnceByTheLocatorWithWhatIsWrong)
{
  const struct
  {
    int Type;
    Harm Done;
    const char* Fault;
  } cases[] = { { VTK_QUAD, Harm::TooFewPoints, "has 3 points, which its type (9) does not have" },
    { VTK_TETRA, Harm::IdTooLarge, "uses point 1000000032 of 32" },
    { VTK_TETRA, Harm::IdNegative, "uses point -1000000000 of 32" },
    { VTK_TRIANGLE, Harm::OffsetTooLarge, "exceed the connectivity array" },
    { VTK_POLYHEDRON, Harm::FacesOfOthers, "has faces that are not polygons of its points" } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Fault);
    const GridPointer mesh = MakeHarmed(one.Type, one.Done);
    vtkNew<vtkSkdTreeCellLocator> locator;
    EventCounter events(locator);
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    EXPECT_EQ(events.Errors, 0);
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find(one.Fault), std::string::npos) << events.Warning;
    EXPECT_NE(events.Warning.find("cell 3"), std::string::npos) << events.Warning;
    const vtkIdType broken = one.Done == Harm::OffsetTooLarge ? 2 : 1;
    EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), broken);
    EXPECT_EQ(locator->GetNumberOfCellsInTree(), 8 - broken);
  }
}

TEST(BrokenCells, WholeCellsOfEveryTypeAreNotNamed)
{
  for (const int type : AllCellTypes())
  {
    for (int order = 1; order <= (IsHigherOrder(type) ? HighestOrder() : 1); ++order)
    {
      SCOPED_TRACE(NameOfType(type) + " " + std::to_string(order));
      const GridPointer mesh = MakeHarmed(type, Harm::None, order);
      vtkNew<vtkSkdTreeCellLocator> locator;
      EventCounter events(locator);
      locator->SetDataSet(mesh);
      locator->BuildLocator();
      EXPECT_EQ(events.Warnings, 0) << events.Warning;
      EXPECT_EQ(locator->GetNumberOfCellsInTree(), type == VTK_EMPTY_CELL ? 0 : 8);
    }
  }
}

TEST(BrokenCells, AreTakenOutOfWhatIsPassedOn)
{
  const GridPointer mesh = WithData(MakeHarmed(VTK_HEXAHEDRON, Harm::IdNegative));
  const auto filter = AllFilterSetups().back().Make(mesh);
  BrokenCounter counter(filter);
  filter->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfCells(), 8);
  EXPECT_EQ(output->GetCellType(3), VTK_EMPTY_CELL);
  EXPECT_EQ(output->GetCellType(4), VTK_HEXAHEDRON);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(7), 70.0);
  EXPECT_EQ(mesh->GetCellType(3), VTK_HEXAHEDRON) << "the input is left as it is";
}

TEST(BrokenCells, OfBlocksAreNamedTogetherWithTheirBlocks)
{
  const GridPointer whole = MakeHarmed(VTK_HEXAHEDRON, Harm::None);
  const GridPointer broken = MakeHarmed(VTK_HEXAHEDRON, Harm::TooFewPoints);
  const auto blocks = MakeBlocks({ whole, broken, broken });
  const auto filter = AllFilterSetups().front().Make(blocks);
  BrokenCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
  EXPECT_NE(counter.Last.find("Input port 1: Block 2: 1 of 8 cells"), std::string::npos)
    << counter.Last;
  EXPECT_NE(counter.Last.find("Block 3: 1 of 8 cells"), std::string::npos) << counter.Last;
  EXPECT_EQ(Reported(filter, "SourceCells"), 22.0);
}

TEST(BrokenCells, OfAMeshThatIsModifiedAreFound)
{
  const GridPointer mesh = MakeHarmed(VTK_TETRA, Harm::None);
  const auto filter = AllFilterSetups().front().Make(mesh);
  BrokenCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, 0);
  const vtkIdType ids[4] = { 8, 9, 77, 11 };
  mesh->GetCells()->ReplaceCellAtId(2, 4, ids);
  mesh->Modified();
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
  EXPECT_NE(counter.Last.find("cell 2, which uses point 77 of 32"), std::string::npos)
    << counter.Last;
}

}
