// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdWeightsFile.h"

#include "Remap/SkdNetCdf.h"
#include "Remap/SkdWeightsGrid.h"
#include "Remap/SkdWeightsMatrix.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <tuple>
#include <type_traits>

namespace skdtree
{
namespace
{
using Numbers = std::vector<double>;

/// What is written, whatever the names.
struct Weights
{
  SkdWeightsGrid Source;
  SkdWeightsGrid Target;
  SkdWeightsMatrix Matrix;
  double SourceUnit = 1.0; ///< areas of the source are measures times this
};

/// Those of a process. `corners`: a cell of the target has no more.
Weights Gather(const SkdWeightsFileSettings& settings, vtkDataSet* donor,
  const std::vector<SkdWeightsBlock>& blocks, int corners, bool withMeasures)
{
  const bool isOnSphere = settings.Space == SkdOverlapSpace::Sphere;
  Weights all;
  all.Matrix.WeightsPerEntry = settings.WithGradients ? 3 : 1;
  all.Matrix.WithMeasures = withMeasures;
  all.Target.CornersPerCell = isOnSphere ? static_cast<std::size_t>(corners) : 0;
  if (blocks.empty())
  {
    return all;
  }
  SkdOverlapCells source = blocks.front().Weights->GetDonor();
  std::fill(source.Covered.begin(), source.Covered.end(), 0.0);
  all.Source.CornersPerCell = isOnSphere ? static_cast<std::size_t>(SkdCornersPerCell(donor)) : 0;
  for (const SkdWeightsBlock& block : blocks)
  {
    all.Matrix.Add(*block.Weights, settings.Normalization, all.Target.Size());
    all.Target.Add(block.Weights->GetTarget(), isOnSphere, block.Weights->GetRadius());
    const std::vector<double>& covered = block.Weights->GetDonor().Covered;
    std::transform(covered.begin(), covered.end(), source.Covered.begin(), source.Covered.begin(),
      std::plus<double>());
  }
  const double radius = blocks.front().Weights->GetRadius();
  all.SourceUnit = isOnSphere ? 1.0 / (radius * radius) : 1.0;
  all.Source.Add(source, isOnSphere, radius);
  if (isOnSphere)
  {
    all.Source.AddCorners(donor);
    for (const SkdWeightsBlock& block : blocks)
    {
      all.Target.AddCorners(block.Target);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
/// What a process has of the whole: the number of cells, the cells and their rows, the entries.
Numbers PackRows(Weights& own, const std::vector<vtkIdType>& rows)
{
  Numbers packed{ 0.0 };
  const auto add = [&packed](const auto& number) { packed.push_back(number); };
  const auto rowOf = [&rows](std::size_t cell)
  { return cell < rows.size() ? rows[cell] : vtkIdType(-1); };
  for (std::size_t cell = 0; cell < own.Target.Size(); ++cell)
  {
    if (rowOf(cell) >= 0)
    {
      packed.front() += 1.0;
      packed.push_back(static_cast<double>(rowOf(cell)));
      own.Target.TransferCell(cell, add);
    }
  }
  for (std::size_t entry = 0; entry < own.Matrix.Size(); ++entry)
  {
    const vtkIdType row = rowOf(static_cast<std::size_t>(own.Matrix.Rows[entry]) - 1);
    if (row >= 0)
    {
      own.Matrix.Rows[entry] = static_cast<int>(row + 1);
      own.Matrix.TransferEntry(entry, add);
    }
  }
  return packed;
}

/// Returns the number of cells.
std::size_t UnpackRows(const Numbers& packed, Weights& all)
{
  std::size_t at = 0;
  const auto take = [&](auto& number)
  { number = static_cast<std::decay_t<decltype(number)>>(packed[at++]); };
  std::size_t cells = 0;
  take(cells);
  for (std::size_t i = 0; i < cells; ++i)
  {
    std::size_t cell = 0;
    take(cell);
    all.Target.TransferCell(cell, take);
  }
  std::size_t entry = all.Matrix.Size();
  all.Matrix.Resize(entry + (packed.size() - at) / all.Matrix.NumbersPerEntry());
  while (at < packed.size())
  {
    all.Matrix.TransferEntry(entry++, take);
  }
  return cells;
}

/// The whole of what several processes have, for the one that writes. What is wrong, or nothing.
std::string GatherShares(const SkdWeightsShare& share, Weights& all)
{
  const Numbers own = PackRows(all, share.Rows);
  std::size_t cells = 0;
  if (share.IsWriter)
  {
    all.Target.Resize(static_cast<std::size_t>(share.NumberOfRows));
    all.Matrix.Resize(0);
  }
  share.Gather(own, [&](const Numbers& packed) { cells += UnpackRows(packed, all); });
  if (!share.IsWriter)
  {
    return "";
  }
  if (cells != all.Target.Size())
  {
    return "not all cells of Input were mapped.";
  }
  all.Matrix.Sort();
  const double unit = all.SourceUnit;
  Numbers covered(all.Source.Size(), 0.0);
  for (std::size_t entry = 0; entry < all.Matrix.Size(); ++entry)
  {
    covered[static_cast<std::size_t>(all.Matrix.Columns[entry]) - 1] += all.Matrix.Measures[entry];
  }
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    const double whole = all.Source.Areas[i] / unit;
    all.Source.Fractions[i] = whole > 0.0 ? covered[i] / whole : 0.0;
  }
  return "";
}

//------------------------------------------------------------------------------
void AddEsmfGrid(
  SkdWeightsGrid& grid, bool isOnSphere, const std::string& suffix, SkdNetCdfContents& contents)
{
  const std::string cells = "n" + suffix;
  const std::string corners = "nv" + suffix;
  const std::string rank = suffix == "_a" ? "src_grid_rank" : "dst_grid_rank";
  const std::string units = isOnSphere ? "degrees" : "1";
  contents.Dimensions.emplace_back(cells, grid.Size());
  contents.Dimensions.emplace_back(rank, grid.Sizes.size());
  auto& variables = contents.Variables;
  variables.push_back(
    { suffix == "_a" ? "src_grid_dims" : "dst_grid_dims", { rank }, "", std::move(grid.Sizes) });
  variables.push_back({ "xc" + suffix, { cells }, units, std::move(grid.Centres[0]) });
  variables.push_back({ "yc" + suffix, { cells }, units, std::move(grid.Centres[1]) });
  if (isOnSphere)
  {
    contents.Dimensions.emplace_back(corners, grid.CornersPerCell);
    variables.push_back({ "xv" + suffix, { cells, corners }, units, std::move(grid.Corners[0]) });
    variables.push_back({ "yv" + suffix, { cells, corners }, units, std::move(grid.Corners[1]) });
  }
  else
  {
    variables.push_back({ "zc" + suffix, { cells }, units, std::move(grid.Centres[2]) });
  }
  variables.push_back({ "mask" + suffix, { cells }, "unitless", std::move(grid.Mask) });
  variables.push_back(
    { "area" + suffix, { cells }, isOnSphere ? "square radians" : "1", std::move(grid.Areas) });
  variables.push_back({ "frac" + suffix, { cells }, "unitless", std::move(grid.Fractions) });
}

void AddEsmf(Weights& all, bool isOnSphere, SkdNetCdfContents& contents)
{
  AddEsmfGrid(all.Source, isOnSphere, "_a", contents);
  AddEsmfGrid(all.Target, isOnSphere, "_b", contents);
  contents.Dimensions.emplace_back("n_s", all.Matrix.Rows.size());
  contents.Variables.push_back({ "col", { "n_s" }, "", std::move(all.Matrix.Columns) });
  contents.Variables.push_back({ "row", { "n_s" }, "", std::move(all.Matrix.Rows) });
  contents.Variables.push_back({ "S", { "n_s" }, "", std::move(all.Matrix.Weights) });
  contents.Attributes.emplace_back("conventions", "NCAR-CSM");
  contents.Attributes.emplace_back("ESMF_regrid_method", "First-order Conservative");
  contents.Attributes.emplace_back("domain_a", "Source");
  contents.Attributes.emplace_back("domain_b", "Input");
}

//------------------------------------------------------------------------------
void AddScripGrid(SkdWeightsGrid& grid, const std::string& prefix, SkdNetCdfContents& contents)
{
  const std::string cells = prefix + "_grid_size";
  const std::string corners = prefix + "_grid_corners";
  const std::string rank = prefix + "_grid_rank";
  contents.Dimensions.emplace_back(cells, grid.Size());
  contents.Dimensions.emplace_back(corners, grid.CornersPerCell);
  contents.Dimensions.emplace_back(rank, grid.Sizes.size());
  const auto add =
    [&](const char* name, std::vector<std::string> dimensions, const char* units, auto&& values)
  {
    contents.Variables.push_back(
      { prefix + name, std::move(dimensions), units, std::forward<decltype(values)>(values) });
  };
  add("_grid_dims", { rank }, "", std::move(grid.Sizes));
  add("_grid_center_lat", { cells }, "degrees", std::move(grid.Centres[1]));
  add("_grid_center_lon", { cells }, "degrees", std::move(grid.Centres[0]));
  add("_grid_corner_lat", { cells, corners }, "degrees", std::move(grid.Corners[1]));
  add("_grid_corner_lon", { cells, corners }, "degrees", std::move(grid.Corners[0]));
  add("_grid_imask", { cells }, "unitless", std::move(grid.Mask));
  add("_grid_area", { cells }, "square radians", std::move(grid.Areas));
  add("_grid_frac", { cells }, "unitless", std::move(grid.Fractions));
}

void AddScrip(Weights& all, SkdNetCdfContents& contents)
{
  AddScripGrid(all.Source, "src", contents);
  AddScripGrid(all.Target, "dst", contents);
  contents.Dimensions.emplace_back("num_links", all.Matrix.Rows.size());
  contents.Dimensions.emplace_back("num_wgts", all.Matrix.WeightsPerEntry);
  contents.Variables.push_back(
    { "src_address", { "num_links" }, "", std::move(all.Matrix.Columns) });
  contents.Variables.push_back({ "dst_address", { "num_links" }, "", std::move(all.Matrix.Rows) });
  contents.Variables.push_back(
    { "remap_matrix", { "num_links", "num_wgts" }, "", std::move(all.Matrix.Weights) });
  contents.Integers.emplace_back("remap_order", all.Matrix.WeightsPerEntry > 1 ? 2 : 1);
  contents.Attributes.emplace_back("conventions", "SCRIP");
  contents.Attributes.emplace_back("source_grid", "Source");
  contents.Attributes.emplace_back("dest_grid", "Input");
}

std::string WriteFile(const SkdWeightsFileSettings& settings, Weights& all)
{
  const bool isWhole = settings.Normalization == SkdNormalization::Whole;
  SkdNetCdfContents contents;
  contents.Attributes = { { "title", "Weights of vtkSkdTreeRemap" },
    { "normalization", isWhole ? "destarea" : "fracarea" },
    { "map_method", "Conservative remapping" } };
  if (settings.Format == SkdWeightsFormat::Scrip)
  {
    AddScrip(all, contents);
  }
  else
  {
    AddEsmf(all, settings.Space == SkdOverlapSpace::Sphere, contents);
  }
  return SkdWriteNetCdf(settings.Name, contents);
}

/// What cannot be written, before anything is done.
std::string ProblemOf(const SkdWeightsFileSettings& settings, vtkDataSet* donor,
  const std::vector<SkdWeightsBlock>& blocks, const SkdWeightsShare* share)
{
  const std::string file = "The file " + settings.Name + " was not written: ";
  if (blocks.empty() && !share)
  {
    return file + "weights are those of conservative methods, and there are none.";
  }
  if (settings.Format == SkdWeightsFormat::Scrip && settings.Space != SkdOverlapSpace::Sphere)
  {
    return file + "SCRIP's form is for meshes on a sphere. Choose ESMF's, or the table of weights.";
  }
  vtkIdType cells = share ? share->NumberOfRows : 0;
  for (const SkdWeightsBlock& block : blocks)
  {
    cells += share ? 0 : block.Target->GetNumberOfCells();
  }
  constexpr vtkIdType most = std::numeric_limits<int>::max();
  return std::max(cells, donor->GetNumberOfCells()) > most
    ? file + "its form has no more than 2147483647 cells a mesh."
    : std::string();
}
}

bool SkdWeightsFileSettings::operator==(const SkdWeightsFileSettings& other) const
{
  return std::tie(
           this->Name, this->Format, this->Space, this->Normalization, this->WithGradients) ==
    std::tie(other.Name, other.Format, other.Space, other.Normalization, other.WithGradients);
}

std::vector<int> SkdGridSizesOf(const std::vector<SkdBlock>& blocks)
{
  std::vector<int> sizes;
  if (blocks.size() == 1)
  {
    int points[3] = { 1, 1, 1 };
    if (auto* image = vtkImageData::SafeDownCast(blocks.front().Mesh))
    {
      image->GetDimensions(points);
    }
    else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(blocks.front().Mesh))
    {
      rectilinear->GetDimensions(points);
    }
    else if (auto* structured = vtkStructuredGrid::SafeDownCast(blocks.front().Mesh))
    {
      structured->GetDimensions(points);
    }
    std::transform(points, points + 3, points, [](int number) { return number - 1; });
    std::copy_if(
      points, points + 3, std::back_inserter(sizes), [](int number) { return number > 0; });
  }
  return sizes.size() == 2 ? sizes : std::vector<int>();
}

int SkdCornersPerCell(const std::vector<SkdBlock>& blocks)
{
  int corners = 1;
  for (const SkdBlock& block : blocks)
  {
    corners = std::max(corners, SkdCornersPerCell(block.Mesh));
  }
  return corners;
}

std::string SkdWriteWeights(const SkdWeightsFileSettings& settings, vtkDataSet* donor,
  const std::vector<SkdWeightsBlock>& blocks, const SkdWeightsGrids& grids,
  const SkdWeightsShare* share)
{
  std::string problem = ProblemOf(settings, donor, blocks, share);
  if (!problem.empty()) // on all processes
  {
    return problem;
  }
  std::vector<SkdBlock> targets;
  for (const SkdWeightsBlock& block : blocks)
  {
    targets.push_back({ block.Target, 0 });
  }
  Weights all = Gather(settings, donor, blocks,
    share ? share->CornersPerCell : SkdCornersPerCell(targets), share != nullptr);
  problem = share ? GatherShares(*share, all) : std::string();
  if (!problem.empty())
  {
    return "The file " + settings.Name + " was not written: " + problem;
  }
  if (share && !share->IsWriter)
  {
    return "";
  }
  all.Source.SetSizes(grids.Source);
  all.Target.SetSizes(grids.Target);
  return WriteFile(settings, all);
}
}
