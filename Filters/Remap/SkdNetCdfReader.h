// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNetCdfReader.h
 * @brief What a netCDF file has, by name.
 */

#ifndef SkdNetCdfReader_h
#define SkdNetCdfReader_h

#include <cstddef>
#include <string>
#include <vector>

namespace skdtree
{
/// A file that is open as long as this lives. What fails first is kept, and nothing is read from
/// there on. Not for several threads at once: the library is not.
class SkdNetCdfReader
{
public:
  /// A file of the classic formats that is shorter than its header says is not read: the library
  /// takes what is missing for zeros.
  explicit SkdNetCdfReader(const std::string& fileName);
  ~SkdNetCdfReader();
  SkdNetCdfReader(const SkdNetCdfReader&) = delete;
  SkdNetCdfReader& operator=(const SkdNetCdfReader&) = delete;

  /// What is wrong, a sentence; empty if nothing is.
  const std::string& GetProblem() const { return this->Problem; }

  /// 0 if there is no such dimension: then nothing is wrong.
  std::size_t SizeOf(const std::string& dimension) const;
  bool Has(const std::string& variable) const;

  ///@{
  /// All values of a variable, which must have so many.
  std::vector<int> ReadIntegers(const std::string& variable, std::size_t size);
  std::vector<double> ReadNumbers(const std::string& variable, std::size_t size);
  ///@}

private:
  void Try(int status);
  void CheckLength();
  int Find(const std::string& variable, std::size_t size);
  template <class Value>
  std::vector<Value> Read(const std::string& variable, std::size_t size,
    int (*get)(int file, int variable, Value* values));

  std::string Name;
  std::string Problem;
  int Id = -1;
};
}

#endif
