// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of weights of vtkSkdTreeRemap, read back by netCDF and used as other programs use them.

#include "Support/EventCounter.h"
#include "Support/Folders.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#ifdef SKDTREE_HAS_NETCDF
#include "vtk_netcdf.h"

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

std::string TemporaryFile(const std::string& name)
{
  return TemporaryFolder() + "/" + name;
}

class File
{
public:
  explicit File(const std::string& name)
  {
    EXPECT_EQ(nc_open(name.c_str(), NC_NOWRITE, &this->Id), NC_NOERR) << name;
  }
  ~File() { nc_close(this->Id); }

  std::size_t Size(const char* name) const
  {
    int dimension = -1;
    std::size_t size = 0;
    EXPECT_EQ(nc_inq_dimid(this->Id, name, &dimension), NC_NOERR) << name;
    nc_inq_dimlen(this->Id, dimension, &size);
    return size;
  }

  std::vector<double> Read(const char* name, std::size_t size) const
  {
    int variable = -1;
    std::vector<double> values(size);
    EXPECT_EQ(nc_inq_varid(this->Id, name, &variable), NC_NOERR) << name;
    EXPECT_EQ(nc_get_var_double(this->Id, variable, values.data()), NC_NOERR) << name;
    return values;
  }

  std::string Text(const char* name, const char* variable = nullptr) const
  {
    int id = NC_GLOBAL;
    std::size_t length = 0;
    if (variable)
    {
      nc_inq_varid(this->Id, variable, &id);
    }
    EXPECT_EQ(nc_inq_attlen(this->Id, id, name, &length), NC_NOERR) << name;
    std::string text(length, ' ');
    nc_get_att_text(this->Id, id, name, text.data());
    return text;
  }

private:
  int Id = -1;
};

double Y22(const Point& x)
{
  return 2.0 + x[0] * x[0] - x[1] * x[1];
}

struct Pair
{
  Mesh From = CubedSphere(8);
  Mesh To = IcosahedralDual(6);
  std::vector<double> Averages = CellAverages(this->From, Y22);
  PolyDataPointer Source = WithCellArray(MakePolyData(this->From), "f", this->Averages);
  PolyDataPointer Input = MakePolyData(this->To);
};

std::vector<double> Ones(std::size_t size)
{
  return std::vector<double>(size, 1.0);
}

RemapPointer WriteFile(
  vtkDataObject* input, vtkDataObject* source, const std::string& name, int method, int format)
{
  RemapPointer remap = MakeRemap(input, source, method);
  remap->SetWeightsFileName(name.c_str());
  remap->SetWeightsFileFormat(format);
  remap->Update();
  return remap;
}
}

File FileOf(const Pair& pair, const char* name, int method, int format)
{
  const std::string path = TemporaryFile(name);
  WriteFile(pair.Input, pair.Source, path, method, format);
  return File(path);
}

// sum S[k] f[col[k]] is what the filter itself gives.
TEST(RemapWeightsFile, EsmfWeightsGiveTheSameField)
{
  const Pair pair;
  const std::string name = TemporaryFile("weights_esmf.nc");
  const RemapPointer remap =
    WriteFile(pair.Input, pair.Source, name, Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  const File file(name);
  const std::size_t a = file.Size("n_a"), b = file.Size("n_b"), links = file.Size("n_s");
  ASSERT_EQ(a, pair.From.Cells.size());
  ASSERT_EQ(b, pair.To.Cells.size());
  EXPECT_EQ(file.Text("normalization"), "fracarea");
  EXPECT_EQ(file.Text("units", "xc_a"), "degrees");
  const auto row = file.Read("row", links), col = file.Read("col", links);
  const auto weights = file.Read("S", links);
  std::vector<double> mapped(b, 0.0);
  for (std::size_t k = 0; k < links; ++k)
  {
    mapped.at(static_cast<std::size_t>(row[k]) - 1) +=
      weights[k] * pair.Averages.at(static_cast<std::size_t>(col[k]) - 1);
  }
  const std::vector<double> own = RemappedCells(remap, "f");
  const auto areas = file.Read("area_b", b), fractions = file.Read("frac_b", b);
  double sphere = 0.0;
  for (std::size_t i = 0; i < b; ++i)
  {
    ASSERT_NEAR(mapped[i], own[i], 1e-14);
    ASSERT_NEAR(fractions[i], 1.0, 1e-12);
    sphere += areas[i];
  }
  EXPECT_NEAR(sphere, 4.0 * std::acos(-1.0), 1e-12);
}

TEST(RemapWeightsFile, CentresAreWithinCorners)
{
  const Pair pair;
  const File file =
    FileOf(pair, "weights_corners.nc", Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  const std::size_t a = file.Size("n_a"), corners = file.Size("nv_a");
  ASSERT_EQ(corners, 4u);
  EXPECT_EQ(file.Size("nv_b"), 6u);
  const auto x = file.Read("xc_a", a), y = file.Read("yc_a", a);
  const auto xv = file.Read("xv_a", 4 * a), yv = file.Read("yv_a", 4 * a);
  for (std::size_t i = 0; i < a; ++i)
  {
    const auto south = std::min_element(&yv[4 * i], &yv[4 * i] + 4);
    const auto north = std::max_element(&yv[4 * i], &yv[4 * i] + 4);
    // Below and above by what an arc bulges over its ends.
    ASSERT_GT(y[i], *south - 2.0);
    ASSERT_LT(y[i], *north + 2.0);
    ASSERT_GE(x[i], 0.0);
    ASSERT_LE(x[i], 360.0);
    const double radians = std::acos(-1.0) / 180.0;
    double longest = 0.0;
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k)
    {
      longest = std::max(longest,
        std::acos(std::sin(radians * y[i]) * std::sin(radians * yv[k]) +
          std::cos(radians * y[i]) * std::cos(radians * yv[k]) *
            std::cos(radians * (x[i] - xv[k]))));
    }
    ASSERT_LT(longest, 0.2) << i; // 8 cells to a quarter of the equator
  }
}

// With the field's own gradient the second and third weights make it one order better.
TEST(RemapWeightsFile, ScripWeightsOfTheGradientAreOfSecondOrder)
{
  const Pair pair;
  const File file =
    FileOf(pair, "weights_scrip.nc", Remap::CONSERVATIVE_SECOND_ORDER, Remap::SCRIP);
  const std::size_t a = file.Size("src_grid_size"), b = file.Size("dst_grid_size");
  const std::size_t links = file.Size("num_links");
  ASSERT_EQ(file.Size("num_wgts"), 3u);
  const auto source = file.Read("src_address", links), target = file.Read("dst_address", links);
  const auto matrix = file.Read("remap_matrix", 3 * links);
  const auto longitudes = file.Read("src_grid_center_lon", a);
  const auto latitudes = file.Read("src_grid_center_lat", a);
  const auto areas = file.Read("dst_grid_area", b);
  std::vector<double> first(b, 0.0), second(b, 0.0), drift(a, 0.0);
  const double radians = std::acos(-1.0) / 180.0;
  for (std::size_t k = 0; k < links; ++k)
  {
    const auto from = static_cast<std::size_t>(source[k]) - 1;
    const auto to = static_cast<std::size_t>(target[k]) - 1;
    const double lon = radians * longitudes[from], lat = radians * latitudes[from];
    const double byLatitude = -2.0 * std::cos(lat) * std::sin(lat) * std::cos(2.0 * lon);
    const double byLongitude = -2.0 * std::cos(lat) * std::sin(2.0 * lon); // over the cosine
    first[to] += matrix[3 * k] * pair.Averages[from];
    second[to] += matrix[3 * k] * pair.Averages[from] + matrix[3 * k + 1] * byLatitude +
      matrix[3 * k + 2] * byLongitude;
    drift[from] += areas[to] * (matrix[3 * k + 1] + matrix[3 * k + 2]);
  }
  const std::vector<double> exact = CellAverages(pair.To, Y22);
  EXPECT_LT(L2Error(second, exact, areas), 0.1 * L2Error(first, exact, areas));
  for (const double of : drift)
  {
    ASSERT_NEAR(of, 0.0, 1e-14); // moments are about the centroid: nothing is gained or lost
  }
}

TEST(RemapWeightsFile, OfVolumesAndOfPartlyCoveredCells)
{
  const auto donor = MakeGrid(Transformed(Tetrahedra(2), 0.5, { 0, 0, 0 }));
  const auto target = MakeGrid(Transformed(Hexahedra(2), 0.75, { 0, 0, 0 }));
  WithCellArray(donor, "f", std::vector<double>(donor->GetNumberOfCells(), 2.0));
  const std::string name = TemporaryFile("weights_volume.nc");
  const RemapPointer remap = MakeRemap(target, donor, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetNormalization(Remap::WHOLE);
  remap->SetWeightsFileName(name.c_str());
  remap->Update();
  const File file(name);
  EXPECT_EQ(file.Text("normalization"), "destarea");
  const std::size_t b = file.Size("n_b"), links = file.Size("n_s");
  const auto row = file.Read("row", links), weights = file.Read("S", links);
  const auto fractions = file.Read("frac_b", b);
  std::vector<double> sums(b, 0.0);
  for (std::size_t k = 0; k < links; ++k)
  {
    sums[static_cast<std::size_t>(row[k]) - 1] += weights[k];
  }
  for (std::size_t i = 0; i < b; ++i)
  {
    EXPECT_NEAR(sums[i], fractions[i], 1e-14);
  }
  EXPECT_NEAR(fractions[0], 1.0, 1e-14);
  EXPECT_NEAR(fractions[1], 1.0 / 3.0, 1e-14);
  const auto x = file.Read("xc_b", b), z = file.Read("zc_b", b);
  EXPECT_NEAR(x[1], 1.125, 1e-14);
  EXPECT_NEAR(z[0], 0.375, 1e-14);
}

TEST(RemapWeightsFile, IsWrittenAgainOnlyWhenSomethingChanged)
{
  const Pair pair;
  const std::string name = TemporaryFile("weights_again.nc");
  const RemapPointer remap =
    WriteFile(pair.Input, pair.Source, name, Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  std::ofstream(name) << "mine";
  WithCellArray(pair.Source, "f", pair.Averages)->Modified(); // a time step
  remap->Update();
  EXPECT_EQ(std::ifstream(name).peek(), 'm');
  remap->SetWeightsFileFormat(Remap::SCRIP);
  remap->Update();
  EXPECT_EQ(File(name).Text("conventions"), "SCRIP");
}

TEST(RemapWeightsFile, GridDimensionsAreThoseOfStructuredGrids)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 3, 1);
  const std::string name = TemporaryFile("weights_sizes.nc");
  WriteFile(
    image, MakePolyData(Sheet(3, VTK_QUAD)), name, Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  const File file(name);
  EXPECT_EQ(file.Size("src_grid_rank"), 1u);
  EXPECT_EQ(file.Read("src_grid_dims", 1), (std::vector<double>{ 9 }));
  EXPECT_EQ(file.Size("dst_grid_rank"), 2u);
  EXPECT_EQ(file.Read("dst_grid_dims", 2), (std::vector<double>{ 3, 2 }));
}

namespace
{
/// A remap that applies a file, and its warning.
struct Applied
{
  RemapPointer Filter;
  EventCounter Events;

  Applied(const std::string& name, vtkDataObject* input, vtkDataObject* source)
    : Filter(MakeRemap(input, source, Remap::WEIGHTS_FROM_FILE))
    , Events(Filter)
  {
    this->Filter->SetAppliedWeightsFileName(name.c_str());
    this->Filter->Update();
  }
};
}

TEST(RemapWeightsFile, FilesAreApplied)
{
  const Pair pair;
  const std::string name = TemporaryFile("weights_applied.nc");
  for (const int form : { Remap::ESMF, Remap::SCRIP })
  {
    const RemapPointer remap =
      WriteFile(pair.Input, pair.Source, name, Remap::CONSERVATIVE_FIRST_ORDER, form);
    const std::vector<double> own = RemappedCells(remap, "f");
    const Applied applied(name, pair.Input, pair.Source);
    const std::vector<double> values = RemappedCells(applied.Filter, "f");
    EXPECT_EQ(applied.Events.Warnings, 0);
    ASSERT_EQ(values.size(), own.size());
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      ASSERT_NEAR(values[i], own[i], 1e-14);
    }
  }
}

// What does not count has no share, and what is in no entry has no value.
TEST(RemapWeightsFile, AppliedWithMissingValuesAndWithoutEntries)
{
  const Mesh from = Sheet(4, VTK_QUAD);
  const GridPointer input = MakeGrid(Transformed(Sheet(3, VTK_QUAD), 2.0, { 0, 0, 0 }));
  std::vector<double> values(16, 3.0);
  values[0] = std::numeric_limits<double>::quiet_NaN();
  const GridPointer source = WithCellArray(MakeGrid(from), "f", values);
  const std::string name = TemporaryFile("weights_missing.nc");
  WriteFile(input, source, name, Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  const Applied applied(name, input, source);
  const std::vector<double> mapped = RemappedCells(applied.Filter, "f");
  EXPECT_NEAR(mapped[0], 3.0, 1e-15);
  EXPECT_TRUE(std::isnan(mapped[2]));
  EXPECT_EQ(
    RemappedCells(applied.Filter, "SkdValid"), (std::vector<double>{ 1, 1, 0, 1, 1, 0, 0, 0, 0 }));
  EXPECT_EQ(Reported(applied.Filter, "InputCellsEmpty"), 5);
}

TEST(RemapWeightsFile, FilesOfOtherMeshesAndBrokenOnesAreNotApplied)
{
  const Pair pair;
  const std::string name = TemporaryFile("weights_other.nc");
  WriteFile(pair.Input, pair.Source, name, Remap::CONSERVATIVE_FIRST_ORDER, Remap::ESMF);
  const PolyDataPointer other = WithCellArray(MakePolyData(CubedSphere(3)), "f", Ones(54));
  const Applied toOther(name, other, pair.Source);
  EXPECT_NE(toOther.Events.Warning.find("from 384 to 362 cells or points. Source has 384 cells and "
                                        "386 points, Input 54 cells and 56 points"),
    std::string::npos)
    << toOther.Events.Warning;
  EXPECT_EQ(Applied(name, pair.Input, other).Events.Warnings, 1);
  EXPECT_EQ(Applied("", pair.Input, pair.Source).Events.Warnings, 1);
  EXPECT_EQ(Applied(name + ".none", pair.Input, pair.Source).Events.Warnings, 1);
  std::ifstream whole(name, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(whole), {});
  for (const std::size_t less : { 1u, 8u, 700u, 5000u, 40000u })
  {
    const std::string cut = TemporaryFile("weights_cut.nc");
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, bytes.size() - less);
    const Applied applied(cut, pair.Input, pair.Source);
    EXPECT_NE(applied.Events.Warning.find("was cut short: it has"), std::string::npos) << less;
    EXPECT_EQ(applied.Events.Warnings, 1);
    EXPECT_TRUE(RemappedCells(applied.Filter, "f").empty());
  }
  for (const std::size_t left : { 3u, 200u })
  {
    const std::string cut = TemporaryFile("weights_cut.nc");
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, left);
    const Applied applied(cut, pair.Input, pair.Source);
    EXPECT_NE(
      applied.Events.Warning.find("has " + std::to_string(left) + " bytes"), std::string::npos)
      << applied.Events.Warning;
    EXPECT_EQ(applied.Events.Warnings, 1);
  }
}

TEST(RemapWeightsFile, SaysWhyThereIsNone)
{
  const Pair pair;
  const std::string name = TemporaryFile("no/such/folder/weights.nc");
  const auto warning = [&](int method, int format, vtkDataObject* input, vtkDataObject* source)
  {
    const RemapPointer remap = MakeRemap(input, source, method);
    remap->SetWeightsFileName(name.c_str());
    remap->SetWeightsFileFormat(format);
    const EventCounter events(remap);
    remap->Update();
    return events.Warning;
  };
  const auto contains = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  const int first = Remap::CONSERVATIVE_FIRST_ORDER;
  EXPECT_TRUE(
    contains(warning(first, Remap::ESMF, pair.Input, pair.Source), "could not be written"));
  EXPECT_TRUE(contains(
    warning(Remap::INTERPOLATION, Remap::ESMF, pair.Input, pair.Source), "conservative methods"));
  const auto grid = MakeGrid(Hexahedra(1));
  EXPECT_TRUE(contains(warning(first, Remap::SCRIP, grid, grid), "on a sphere"));
}
#endif
