// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap from real tetrahedra, some of them turned inside out, to hexahedra.

#include "Support/Folders.h"
#include "Support/RealMeshes.h"
#include "Support/RemapRun.h"
#include "Support/TestAmount.h"
#include "Support/VolumeMeshes.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

/// As many cubes as hold the mesh.
GridPointer CubesAround(vtkDataSet* mesh, int n)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const double size =
    1.02 * std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  return MakeGrid(Transformed(Hexahedra(n), size / n,
    { bounds[0] - 0.007 * size, bounds[2] - 0.009 * size, bounds[4] - 0.011 * size }));
}
}

TEST(RemapRealVolumes, TetrahedraToHexahedraKeepTheIntegral)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const std::string file = ExtraDataFolder() + "/B_volume/aneurysm_tets.vtu";
  const DataSetPointer source = std::filesystem::exists(file) ? ReadMesh(file) : nullptr;
  if (!source || source->GetNumberOfCells() == 0)
  {
    GTEST_SKIP() << file << " is not there, or VTK cannot read it";
  }
  std::vector<double> values, ones;
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
  {
    values.push_back(std::sin(0.01 * static_cast<double>(i)));
    ones.push_back(0.7);
  }
  WithCellArray(source, "field", values);
  WithCellArray(source, "constant", ones);
  const GridPointer cubes = CubesAround(source, 8);
  for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    const RemapPointer remap = MakeRemap(cubes, source, method);
    const std::vector<double> constant = RemappedCells(remap, "constant");
    vtkFieldData* report = remap->GetOutputDataObject(0)->GetFieldData();
    for (vtkIdType i = 0; i < 2; ++i)
    {
      const double whole = report->GetArray("SkdReportSourceIntegral")->GetTuple1(i);
      const double mapped = report->GetArray("SkdReportTargetIntegral")->GetTuple1(i);
      EXPECT_LT(report->GetArray("SkdReportConservationError")->GetTuple1(i), 1e-13);
      EXPECT_NEAR(whole, mapped, 1e-12 * 2973.0); // of the volume
    }
    vtkIdType valid = 0;
    for (const double value : constant)
    {
      valid += std::isnan(value) ? 0 : 1;
      ASSERT_TRUE(std::isnan(value) || std::abs(value - 0.7) < 1e-14);
    }
    EXPECT_GT(valid, 20); // the vessel fills a small part of its box
    EXPECT_LT(valid, 512);
  }
}

/// Of donor cells that are covered in part, too: their gradients count in what is expected.
TEST(RemapRealVolumes, TheErrorOfPartlyCoveredCellsIsRounding)
{
  const GridPointer source = MakeGrid(Transformed(Tetrahedra(3), 1.0 / 3.0, { 0, 0, 0 }));
  std::vector<double> values;
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
  {
    values.push_back(std::sin(static_cast<double>(i)));
  }
  WithCellArray(source, "field", values);
  const GridPointer cubes = MakeGrid(Transformed(Hexahedra(3), 0.2, { 0.11, 0.12, 0.13 }));
  const RemapPointer remap = MakeRemap(cubes, source, Remap::CONSERVATIVE_SECOND_ORDER);
  remap->SetLimiter(Remap::NO_LIMITER);
  remap->Update();
  EXPECT_LT(Reported(remap, "ConservationError"), 1e-14);
}
