// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdNetCdfReader.h"

// What CMake defines for the optional modules of vtk.module.
#if VTK_MODULE_ENABLE_VTK_netcdf
#include "vtk_netcdf.h"
#include "vtksys/SystemTools.hxx"
#endif

#include <array>

namespace skdtree
{
#if VTK_MODULE_ENABLE_VTK_netcdf
namespace
{
/// Bytes in the file, in words of four.
std::size_t Padded(std::size_t bytes)
{
  return (bytes + 3) / 4 * 4;
}

/// How many bytes a file of the classic formats has at least: the header with the lengths of names
/// and attributes as the format lays them down, and the values of all variables.
class ClassicLength
{
public:
  ClassicLength(int file, bool hasLongCounts, bool hasLongOffsets)
    : File(file)
    , Count(hasLongCounts ? 8 : 4)
    , Offset(hasLongOffsets ? 8 : 4)
  {
  }

  std::size_t Find()
  {
    int dimensions = 0, variables = 0, attributes = 0, unlimited = -1;
    nc_inq(this->File, &dimensions, &variables, &attributes, &unlimited);
    this->Bytes = 4 + this->Count + 3 * (4 + this->Count); // the magic number, records, three lists
    for (int i = 0; i < dimensions; ++i)
    {
      this->Lengths.push_back(0);
      nc_inq_dim(this->File, i, this->Name.data(), &this->Lengths.back());
      this->AddName();
      this->Bytes += this->Count;
    }
    this->AddAttributes(NC_GLOBAL, attributes);
    for (int i = 0; i < variables; ++i)
    {
      this->AddVariable(i);
    }
    return this->Bytes;
  }

private:
  void AddName() { this->Bytes += this->Count + Padded(std::string(this->Name.data()).size()); }

  static std::size_t SizeOf(nc_type type)
  {
    switch (type)
    {
      case NC_BYTE:
      case NC_CHAR:
        return 1;
      case NC_SHORT:
        return 2;
      case NC_DOUBLE:
        return 8;
      default:
        return 4;
    }
  }

  void AddAttributes(int variable, int number)
  {
    for (int i = 0; i < number; ++i)
    {
      nc_type type = NC_CHAR;
      std::size_t length = 0;
      nc_inq_attname(this->File, variable, i, this->Name.data());
      nc_inq_att(this->File, variable, this->Name.data(), &type, &length);
      this->AddName();
      this->Bytes += 4 + this->Count + Padded(length * SizeOf(type));
    }
  }

  void AddVariable(int id)
  {
    nc_type type = NC_CHAR;
    int rank = 0, attributes = 0;
    std::array<int, NC_MAX_VAR_DIMS> dimensions{};
    nc_inq_var(this->File, id, this->Name.data(), &type, &rank, dimensions.data(), &attributes);
    std::size_t values = 1;
    for (int i = 0; i < rank; ++i)
    {
      values *= this->Lengths[static_cast<std::size_t>(dimensions[static_cast<std::size_t>(i)])];
    }
    this->AddName();
    this->Bytes += this->Count * (1 + static_cast<std::size_t>(rank)) + 4 + this->Count;
    this->Bytes += this->Count + 4 + this->Offset; // the list of attributes, the type, the offset
    this->AddAttributes(id, attributes);
    this->Bytes += Padded(values * SizeOf(type));
  }

  int File;
  std::size_t Count;
  std::size_t Offset;
  std::size_t Bytes = 0;
  std::array<char, NC_MAX_NAME + 1> Name{};
  std::vector<std::size_t> Lengths;
};
}

SkdNetCdfReader::SkdNetCdfReader(const std::string& fileName)
  : Name(fileName)
{
  this->Try(nc_open(fileName.c_str(), NC_NOWRITE, &this->Id));
  if (this->Problem.empty())
  {
    this->CheckLength();
  }
}

SkdNetCdfReader::~SkdNetCdfReader()
{
  if (this->Id >= 0)
  {
    nc_close(this->Id);
  }
}

void SkdNetCdfReader::Try(int status)
{
  if (this->Problem.empty() && status != NC_NOERR)
  {
    const auto length = vtksys::SystemTools::FileLength(this->Name);
    const std::string size = " It has " + std::to_string(length) + " bytes: it may be cut short.";
    this->Problem = "The file " + this->Name + " could not be read: " + nc_strerror(status) + "." +
      (vtksys::SystemTools::FileExists(this->Name, true) ? size : "");
  }
}

void SkdNetCdfReader::CheckLength()
{
  int format = 0;
  this->Try(nc_inq_format(this->Id, &format));
  const bool isClassic = format == NC_FORMAT_CLASSIC;
  if (!isClassic && format != NC_FORMAT_64BIT)
  {
    return;
  }
  const std::size_t wanted = ClassicLength(this->Id, false, !isClassic).Find();
  const std::size_t there = vtksys::SystemTools::FileLength(this->Name);
  if (this->Problem.empty() && there < wanted)
  {
    this->Problem = "The file " + this->Name + " was cut short: it has " + std::to_string(there) +
      " of " + std::to_string(wanted) + " bytes.";
  }
}

std::size_t SkdNetCdfReader::SizeOf(const std::string& dimension) const
{
  int id = -1;
  std::size_t size = 0;
  const bool isThere =
    this->Problem.empty() && nc_inq_dimid(this->Id, dimension.c_str(), &id) == NC_NOERR;
  return isThere && nc_inq_dimlen(this->Id, id, &size) == NC_NOERR ? size : 0;
}

bool SkdNetCdfReader::Has(const std::string& variable) const
{
  int id = -1;
  return this->Problem.empty() && nc_inq_varid(this->Id, variable.c_str(), &id) == NC_NOERR;
}

int SkdNetCdfReader::Find(const std::string& variable, std::size_t size)
{
  int id = -1, rank = 0;
  std::array<int, NC_MAX_VAR_DIMS> dimensions{};
  if (this->Problem.empty())
  {
    this->Try(nc_inq_varid(this->Id, variable.c_str(), &id));
    this->Try(nc_inq_var(this->Id, id, nullptr, nullptr, &rank, dimensions.data(), nullptr));
  }
  std::size_t values = 1;
  for (int i = 0; i < rank; ++i)
  {
    std::size_t length = 0;
    nc_inq_dimlen(this->Id, dimensions[static_cast<std::size_t>(i)], &length);
    values *= length;
  }
  if (this->Problem.empty() && values != size)
  {
    this->Problem = "The file " + this->Name + " could not be read: " + variable + " has " +
      std::to_string(values) + " values instead of " + std::to_string(size) + ".";
  }
  return id;
}

template <class Value>
std::vector<Value> SkdNetCdfReader::Read(
  const std::string& variable, std::size_t size, int (*get)(int file, int variable, Value* values))
{
  const int id = this->Find(variable, size);
  std::vector<Value> values(this->Problem.empty() ? size : 0);
  if (!values.empty())
  {
    this->Try(get(this->Id, id, values.data()));
  }
  return values;
}

std::vector<int> SkdNetCdfReader::ReadIntegers(const std::string& variable, std::size_t size)
{
  return this->Read(variable, size, nc_get_var_int);
}

std::vector<double> SkdNetCdfReader::ReadNumbers(const std::string& variable, std::size_t size)
{
  return this->Read(variable, size, nc_get_var_double);
}

#else

SkdNetCdfReader::SkdNetCdfReader(const std::string& fileName)
  : Name(fileName)
  , Problem("The file " + fileName +
      " could not be read: this build has no netCDF. Build it where VTK's netCDF and its headers "
      "are (Debian: libnetcdf-dev).")
{
}

SkdNetCdfReader::~SkdNetCdfReader() = default;

std::size_t SkdNetCdfReader::SizeOf(const std::string&) const
{
  return 0;
}

bool SkdNetCdfReader::Has(const std::string&) const
{
  return false;
}

std::vector<int> SkdNetCdfReader::ReadIntegers(const std::string&, std::size_t)
{
  return {};
}

std::vector<double> SkdNetCdfReader::ReadNumbers(const std::string&, std::size_t)
{
  return {};
}

#endif
}
