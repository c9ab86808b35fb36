// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFieldCriterion.h
 * @brief Whether a field varies within a cell, or has values of interest there.
 *
 * The values in a cell are those of the field's points in it, and those interpolated at its corners
 * and its centre; of cell data those of the field's cells that intersect it. Arrays with several
 * components use the magnitude. Values that are not finite are ignored. Blocks are tested
 * separately.
 *
 * The normalised second difference (SkdSecondDifference.h) is that of interpolated values alone.
 */

#ifndef SkdFieldCriterion_h
#define SkdFieldCriterion_h

#include "Bodies/SkdParts.h"
#include "Core/Parallel/Processes.h"
#include "Meshing/Refine/SkdRegion.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace skdtree
{
enum class SkdFieldTest
{
  Difference, ///< of two values in the cell: more than the threshold
  Gradient,   ///< of a field's cell that meets the cell: two of its points differ by more than the
              ///< threshold times their distance; only of point data
  Value,      ///< one in the range
  SecondDifference ///< normalised, of values on the points of the cell's box: more than the
                   ///< threshold
};

struct SkdFieldSettings
{
  std::set<std::string> Arrays;
  SkdFieldTest Test = SkdFieldTest::Difference;
  double Threshold = 0.0;
  double Range[2] = { 0.0, 1.0 };
  bool IsRelative = false; ///< both are relative to the range of values; see SetLimits
};

class SkdFieldCriterion
{
public:
  /// Reads the arrays of the blocks, point data before cell data. Trees are reused while the meshes
  /// are unchanged. Throws like SkdParts::Update().
  void Update(
    const std::vector<SkdBlock>& blocks, const SkdFieldSettings& settings, double epsilon);

  /// After Update() of a field of which each process may have another part: what is relative is so
  /// to the range of values of all. All of them must call it together, with the same settings.
  void ShareRanges(const skd::Processes& processes);

  /// The names of arrays that no block has in the data that the test needs.
  std::set<std::string> GetMissing() const { return this->Missing; }

  /// Whether one of the arrays passes the test. Thread-safe.
  bool IsWanted(const SkdRegion& region) const;

private:
  /// The values of one array of one block.
  struct Column
  {
    std::uint32_t Part;
    std::string Name;
    bool IsOfPoints;
    std::vector<double> Values;
    double Threshold;
    double Range[2];
  };
  class Look;
  struct ValueRange
  {
    double Least = std::numeric_limits<double>::max();
    double Most = std::numeric_limits<double>::lowest();

    void Add(double value)
    {
      this->Least = std::min(this->Least, value);
      this->Most = std::max(this->Most, value);
    }
  };

  void TakeArray(std::uint32_t part, vtkDataSet* mesh, const std::string& name);
  std::vector<double> FindGradients(std::uint32_t part, const std::vector<double>& values) const;
  void AddListed(const Column& column, const SkdRegion& region, Look& look) const;
  SkdFoundCell FindAt(const Column& column, const skd::Vector3& x, double maxDistance) const;
  double InterpolateAt(const Column& column, const skd::Vector3& x, double maxDistance) const;
  void AddSamples(const Column& column, const SkdRegion& region, Look& look) const;
  bool IsWanted(const Column& column, const SkdRegion& region) const;
  bool IsRelative() const;
  void FindRanges();
  void SetLimits();

  SkdParts Meshes;
  SkdFieldSettings Settings;
  std::vector<Column> Columns;
  std::map<std::string, ValueRange> Ranges; // of arrays, if limits are relative to them
  std::set<std::string> Missing;
};
}

#endif
