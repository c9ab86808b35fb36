// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: what it says beforehand of the cells, the memory and the time that it will take.

#include "Support/AMRRun.h"
#include "Support/TestAmount.h"
#include "Support/VolumeMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// Cells thought of beforehand to those that there are.
double EstimateToCells(vtkSkdTreeAMR* filter)
{
  filter->Update();
  return Reported(filter, "EstimatedCells") / Reported(filter, "AllCells");
}

TEST(AMREstimate, OfCellsIsRightToFivePercent)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const DataSetPointer parts[] = { MakeTorus(), MakePolyData(TriangleSoup(300, 0.1)),
    MakePolyData(CubeTriangles(4)), MakePolyData(Helix(50, VTK_LINE)), MakeGrid(Tetrahedra(2)) };
  for (const DataSetPointer& part : parts)
  {
    for (const int test : { vtkSkdTreeAMR::EXACT, vtkSkdTreeAMR::BLIND })
    {
      AMRPointer filter = MakeAMR(part, 6);
      filter->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
      filter->SetOverlapTest(test);
      EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.05) << Reported(filter, "AllCells");
    }
  }
}

TEST(AMREstimate, CountsWhatAllCriteriaAskFor)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  AMRPointer filter = MakeAMR(MakeTorus(), 6);
  filter->RefineByNormalDeviationOn();
  EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.05);
  filter->RefineByNormalDeviationOff();
  filter->AddDistanceBand(0.1, 5);
  EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.05);
  filter->RemoveAllDistanceBands();
  filter->SetInsideLevel(5);
  EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.05);
  filter->SetBranchFactor(3);
  filter->SetMaximumLevel(4);
  filter->SetInsideLevel(0);
  filter->SetBaseDimensions(3, 2, 1);
  EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.05);
}

TEST(AMREstimate, IsWithinAFactorOfTwoWithBalanceAndLayers)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  for (int balance = 1; balance <= 3; ++balance)
  {
    AMRPointer filter = MakeAMR(MakeTorus(), 5);
    filter->SetBalance(balance);
    EXPECT_NEAR(EstimateToCells(filter), 1.0, 0.2);
    filter->SetBalance(vtkSkdTreeAMR::NONE);
    filter->SetGrowingLayers(balance);
    const double ratio = EstimateToCells(filter);
    EXPECT_TRUE(0.5 < ratio && ratio < 2.0) << ratio;
  }
}

TEST(AMREstimate, OfMemoryIsWithinAFactorOfTwo)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  for (const int type : { vtkSkdTreeAMR::HYPER_TREE_GRID, vtkSkdTreeAMR::UNSTRUCTURED_GRID })
  {
    for (const bool isMuchAsked : { false, true })
    {
      AMRPointer filter = MakeAMR(MakeTorus(), 6);
      filter->SetOutputType(type);
      filter->SetComputeDistance(isMuchAsked);
      filter->SetComputeVolumeFraction(isMuchAsked);
      filter->Update();
      const double ofOutput = 1024.0 * filter->GetOutputDataObject(0)->GetActualMemorySize();
      const double beside = 21.0 * Reported(filter, "AllCells"); // of the grid itself
      const double ratio = Reported(filter, "EstimatedBytes") / (ofOutput + beside);
      EXPECT_TRUE(0.5 < ratio && ratio < 2.0) << ratio;
      EXPECT_GT(Reported(filter, "EstimatedSeconds"), 0.0);
    }
  }
}

/// The progress text when the refinement begins.
TEST(AMREstimate, IsReportedBeforeItStarts)
{
  AMRPointer filter = MakeAMR(MakeTorus(), 6);
  std::vector<std::string> told;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&told);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* list, void*)
    {
      const char* text = vtkAlgorithm::SafeDownCast(caller)->GetProgressText();
      static_cast<std::vector<std::string>*>(list)->push_back(text ? text : "");
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  filter->RemoveAllObservers();
  const auto isEstimate = [](const std::string& text)
  { return text.find("about ") == 0 && text.find(" cells, ") != std::string::npos; };
  EXPECT_GT(std::count_if(told.begin(), told.end(), isEstimate), 5);
  EXPECT_EQ(told.back(), "");
}

TEST(AMREstimate, OfWhatCellLimitStopsIsOfTheWhole)
{
  AMRPointer whole = MakeAMR(MakeTorus(), 6);
  whole->Update();
  AMRPointer filter = MakeAMR(MakeTorus(), 6);
  filter->SetCellLimit(4000);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(Reported(filter, "EstimatedCells"), Reported(whole, "EstimatedCells"));
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("the maximum level about"), std::string::npos) << events.Warning;
}

}
