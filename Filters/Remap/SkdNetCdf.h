// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNetCdf.h
 * @brief A netCDF file written at once, by the library that VTK uses.
 */

#ifndef SkdNetCdf_h
#define SkdNetCdf_h

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace skdtree
{
/// What a file has: everything by name, in this order.
struct SkdNetCdfContents
{
  struct Variable
  {
    std::string Name;
    std::vector<std::string> Dimensions; ///< the last varies fastest
    std::string Units;                   ///< "": the variable has no such attribute
    std::variant<std::vector<int>, std::vector<double>> Values;
  };

  std::vector<std::pair<std::string, std::size_t>> Dimensions;
  std::vector<std::pair<std::string, std::string>> Attributes; ///< of the whole file
  std::vector<std::pair<std::string, int>> Integers;           ///< its attributes that are numbers
  std::vector<Variable> Variables;
};

/// Writes a file in the classic format with 64-bit offsets, in place of one that is there. What is
/// wrong, a sentence; empty if nothing is. Not for several threads at once: the library is not.
std::string SkdWriteNetCdf(const std::string& fileName, const SkdNetCdfContents& contents);
}

#endif
