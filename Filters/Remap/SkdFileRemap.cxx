// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdFileRemap.h"

#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdLoop.h"
#include "Remap/SkdDonorGradients.h"
#include "Remap/SkdNetCdfReader.h"
#include "Remap/SkdOverlapPieces.h"
#include "vtkDataSet.h"
#include "vtkMath.h"

#include <algorithm>
#include <iterator>

namespace skdtree
{
namespace
{
/// The names that a kind of file uses.
struct Names
{
  const char* Rows;
  const char* Columns;
  const char* Entries;
  const char* Row;
  const char* Column;
  const char* Weights;
};

constexpr Names Kinds[] = { { "n_b", "n_a", "n_s", "row", "col", "S" },
  { "dst_grid_size", "src_grid_size", "num_links", "dst_address", "src_address", "remap_matrix" } };

/// Whether all numbers are from 1 to a size, or whatever if that is not known; the first that is
/// not becomes `wrong`.
bool AreWithin(const std::vector<int>& numbers, std::size_t size, int& wrong)
{
  const auto found = std::find_if(numbers.begin(), numbers.end(),
    [size](int number)
    { return number < 1 || (size > 0 && static_cast<std::size_t>(number) > size); });
  wrong = found != numbers.end() ? *found : 0;
  return found == numbers.end();
}

std::size_t SizeOf(const std::vector<SkdBlock>& blocks, int type)
{
  std::size_t size = 0;
  for (const SkdBlock& block : blocks)
  {
    size += static_cast<std::size_t>(block.Mesh->GetNumberOfElements(type));
  }
  return size;
}

std::string Told(std::size_t size)
{
  return size > 0 ? std::to_string(size) : std::string("an unknown number of");
}
}

//------------------------------------------------------------------------------
std::string SkdFileWeights::Read(const std::string& fileName)
{
  *this = {};
  this->Name = fileName;
  SkdNetCdfReader file(fileName);
  if (!file.GetProblem().empty())
  {
    return file.GetProblem();
  }
  const auto* names = std::find_if(std::begin(Kinds), std::end(Kinds),
    [&](const Names& kind)
    { return file.Has(kind.Row) && file.Has(kind.Column) && file.Has(kind.Weights); });
  if (names == std::end(Kinds))
  {
    return "The file " + fileName +
      " has no weights: neither row, col and S nor dst_address, src_address and remap_matrix.";
  }
  const std::size_t entries = file.SizeOf(names->Entries);
  this->Rows = file.SizeOf(names->Rows);
  this->Columns = file.SizeOf(names->Columns);
  this->WeightsPerEntry = std::max<std::size_t>(file.SizeOf("num_wgts"), 1);
  this->Row = file.ReadIntegers(names->Row, entries);
  this->Column = file.ReadIntegers(names->Column, entries);
  this->Weights = file.ReadNumbers(names->Weights, entries * this->WeightsPerEntry);
  if (!file.GetProblem().empty())
  {
    return file.GetProblem();
  }
  int wrong = 0;
  const bool isRight =
    AreWithin(this->Row, this->Rows, wrong) && AreWithin(this->Column, this->Columns, wrong);
  return isRight ? std::string()
                 : "The file " + fileName + " is broken: it has the row or column " +
      std::to_string(wrong) + ".";
}

//------------------------------------------------------------------------------
SkdFileRemap::SkdFileRemap(const SkdFileWeights& weights, vtkDataSet* donor,
  const std::vector<SkdBlock>& blocks, vtkAlgorithm* algorithm)
  : Weights(weights)
  , Donor(donor)
  , Blocks(blocks)
  , Algorithm(algorithm)
{
}

std::string SkdFileRemap::Match(int wanted)
{
  const auto greatest = [](const std::vector<int>& numbers)
  {
    return numbers.empty()
      ? std::size_t(0)
      : static_cast<std::size_t>(*std::max_element(numbers.begin(), numbers.end()));
  };
  const auto fits = [](std::size_t size, std::size_t most, std::size_t there)
  { return size > 0 ? size == there : most <= there; };
  const auto find =
    [&](std::size_t size, const std::vector<int>& numbers, std::size_t cells, std::size_t points)
  {
    const std::size_t most = greatest(numbers);
    return fits(size, most, cells) ? static_cast<int>(vtkDataObject::CELL)
      : fits(size, most, points)   ? static_cast<int>(vtkDataObject::POINT)
                                   : -1;
  };
  const auto cells = static_cast<std::size_t>(this->Donor->GetNumberOfCells());
  const auto points = static_cast<std::size_t>(this->Donor->GetNumberOfPoints());
  const std::size_t targetCells = SizeOf(this->Blocks, vtkDataObject::CELL);
  const std::size_t targetPoints = SizeOf(this->Blocks, vtkDataObject::POINT);
  const SkdFileWeights& file = this->Weights;
  this->Meshes.SourceType = find(file.Columns, file.Column, cells, points);
  this->Meshes.TargetType =
    find(file.Rows, file.Row, wanted == vtkDataObject::POINT ? targetPoints : targetCells,
      wanted == vtkDataObject::CELL ? targetCells : targetPoints);
  if (wanted >= 0 && this->Meshes.TargetType >= 0)
  {
    this->Meshes.TargetType = wanted;
  }
  if (this->Meshes.SourceType >= 0 && this->Meshes.TargetType >= 0)
  {
    return std::string();
  }
  return "The weights of " + file.Name + " are of other meshes: from " + Told(file.Columns) +
    " to " + Told(file.Rows) + " cells or points. Source has " + std::to_string(cells) +
    " cells and " + std::to_string(points) + " points, Input " + std::to_string(targetCells) +
    " cells and " + std::to_string(targetPoints) + " points.";
}

//------------------------------------------------------------------------------
// The derivatives by the latitude, and by the longitude over the cosine of the latitude, of each
// cell's components, one after the other.
std::vector<double> SkdFileRemap::Expand(const SkdDonorField& field) const
{
  SkdOverlapSettings settings;
  settings.Space = SkdOverlapSpace::Sphere;
  const SkdOverlapSurface surface(this->Donor, this->Donor, settings);
  SkdOverlapPieces pieces;
  SkdOverlapCells cells;
  SkdLoop loop(this->Algorithm, 0, 0.0, 0.5, 8);
  pieces.Read(this->Donor, surface, { false, settings.SkipsGhosts }, loop);
  pieces.Measure(surface, cells);
  const SkdDonorGradients gradients(this->Donor, cells, { { 0.0, 0.0, 0.0 } }, true);
  const std::vector<char> all(cells.Measures.size(), 1);
  const auto components = static_cast<std::size_t>(field.Components);
  std::vector<double> derivatives(2 * all.size() * components, 0.0);
  for (std::size_t c = 0; c < components; ++c)
  {
    const std::vector<skd::Vector3> slopes =
      gradients.FindTangential(field, static_cast<int>(c), all);
    for (std::size_t i = 0; i < slopes.size(); ++i)
    {
      if (cells.Measures[i] > 0.0)
      {
        const auto axes = SkdLonLatAxesAt(cells.Centroids[i]);
        double* two = derivatives.data() + 2 * (i * components + c);
        two[0] = surface.GetRadius() * skd::Dot(slopes[i], axes.North);
        two[1] = surface.GetRadius() * skd::Dot(slopes[i], axes.East);
      }
    }
  }
  return derivatives;
}

std::vector<double> SkdFileRemap::Map(
  const SkdDonorField& field, std::vector<unsigned char>& isMapped) const
{
  const std::size_t rows = SizeOf(this->Blocks, this->Meshes.TargetType);
  const auto components = static_cast<std::size_t>(field.Components);
  const std::size_t step = this->Weights.WeightsPerEntry;
  const bool isSecond = step == 3 && this->Meshes.SourceType == vtkDataObject::CELL;
  const std::vector<double> derivatives = isSecond ? this->Expand(field) : std::vector<double>();
  std::vector<double> values(rows * components, 0.0), all(rows, 0.0), counted(rows, 0.0);
  isMapped.assign(rows, 0);
  for (std::size_t k = 0; k < this->Weights.Row.size(); ++k)
  {
    const auto row = static_cast<std::size_t>(this->Weights.Row[k] - 1);
    const auto column = static_cast<std::size_t>(this->Weights.Column[k] - 1);
    const double* weights = this->Weights.Weights.data() + k * step;
    all[row] += weights[0];
    if (field.Counts[column] == 0)
    {
      continue;
    }
    isMapped[row] = 1;
    counted[row] += weights[0];
    for (std::size_t c = 0; c < components; ++c)
    {
      const std::size_t at = column * components + c;
      values[row * components + c] += weights[0] * field.Values[at];
      values[row * components + c] +=
        isSecond ? weights[1] * derivatives[2 * at] + weights[2] * derivatives[2 * at + 1] : 0.0;
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    const bool isWhole = counted[row] == all[row];
    isMapped[row] = isMapped[row] != 0 && (isWhole || counted[row] != 0.0) ? 1 : 0;
    const double by = isMapped[row] == 0 ? vtkMath::Nan() : isWhole ? 1.0 : all[row] / counted[row];
    std::transform(&values[row * components], &values[row * components] + components,
      &values[row * components], [by](double value) { return by * value; });
  }
  return values;
}
}
