// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFieldCriterion.h
 * @brief Whether a field varies within a box, or has values of interest there.
 *
 * The values that count in a box are those of the field's points in it, and those interpolated at
 * its corners and its middle; of cell data those of the cells that meet it. Of arrays with several
 * components the magnitude. Values that are not finite do not count. Blocks are looked at one by
 * one.
 */

#ifndef SkdFieldCriterion_h
#define SkdFieldCriterion_h

#include "Refine/SkdParts.h"

#include <set>
#include <string>

enum class SkdFieldTest
{
  Difference, ///< of two values in the box: more than the threshold
  Gradient,   ///< of a cell that meets the box: two of its points differ by more than the
              ///< threshold times their distance; only of point data
  Value       ///< one in the range
};

struct SkdFieldSettings
{
  std::set<std::string> Arrays;
  SkdFieldTest Test = SkdFieldTest::Difference;
  double Threshold = 0.0;
  double Range[2] = { 0.0, 1.0 };
};

class SkdFieldCriterion
{
public:
  /// Takes the arrays of the leaves, point data before cell data. Trees are kept while the meshes
  /// are the same. Throws as SkdParts::Update() does.
  void Update(const std::vector<SkdLeaf>& leaves, const SkdFieldSettings& settings, double epsilon);

  /// The names that no leaf has, of the data that the test needs.
  std::set<std::string> GetMissing() const { return this->Missing; }

  /// Whether one of the arrays passes the test. Thread-safe.
  bool IsWanted(const skd::Box3& box) const;

private:
  /// The values of one array of one leaf.
  struct Column
  {
    std::uint32_t Part;
    bool IsOfPoints;
    std::vector<double> Values;
  };
  class Look;

  void TakeArray(std::uint32_t part, vtkDataSet* mesh, const std::string& name);
  std::vector<double> FindGradients(std::uint32_t part, const std::vector<double>& values) const;
  void AddListed(const Column& column, const skd::Box3& box, Look& look) const;
  void AddSamples(const Column& column, const skd::Box3& box, Look& look) const;

  SkdParts Meshes;
  SkdFieldSettings Settings;
  std::vector<Column> Columns;
  std::set<std::string> Missing;
};

#endif
