// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdNetCdf.h"

// What CMake defines for the optional modules of vtk.module.
#if VTK_MODULE_ENABLE_VTK_netcdf
#include "vtk_netcdf.h"
#endif

#include <algorithm>
#include <map>

namespace skdtree
{
#if VTK_MODULE_ENABLE_VTK_netcdf
namespace
{
/// A file in the making. The first thing that fails is kept, and nothing is done from there on.
class File
{
public:
  explicit File(const std::string& name) { this->Try(nc_create(name.c_str(), Mode, &this->Id)); }

  ~File() { this->Close(); }

  void Define(const SkdNetCdfContents& contents)
  {
    for (const auto& [name, size] : contents.Dimensions)
    {
      this->Try([&, &name = name, size = size]
        { return nc_def_dim(this->Id, name.c_str(), size, &this->Dimensions[name]); });
    }
    for (const auto& [name, text] : contents.Attributes)
    {
      this->AddText(NC_GLOBAL, name.c_str(), text);
    }
    for (const auto& [name, number] : contents.Integers)
    {
      this->Try([&, &name = name, &number = number]
        { return nc_put_att_int(this->Id, NC_GLOBAL, name.c_str(), NC_INT, 1, &number); });
    }
    for (const SkdNetCdfContents::Variable& variable : contents.Variables)
    {
      this->Define(variable);
    }
    this->Try([&] { return nc_enddef(this->Id); });
  }

  void Put(const SkdNetCdfContents::Variable& variable)
  {
    const int id = this->Variables[variable.Name];
    const auto* integers = std::get_if<std::vector<int>>(&variable.Values);
    this->Try(
      [&]
      {
        return integers
          ? nc_put_var_int(this->Id, id, integers->data())
          : nc_put_var_double(this->Id, id, std::get<std::vector<double>>(variable.Values).data());
      });
  }

  /// NC_NOERR if all went well.
  int Close()
  {
    if (this->Id >= 0)
    {
      const int status = nc_close(this->Id);
      this->Status = this->Status == NC_NOERR ? status : this->Status;
      this->Id = -1;
    }
    return this->Status;
  }

private:
  static constexpr int Mode = NC_CLOBBER | NC_64BIT_OFFSET;

  void Define(const SkdNetCdfContents::Variable& variable)
  {
    std::vector<int> dimensions(variable.Dimensions.size());
    std::transform(variable.Dimensions.begin(), variable.Dimensions.end(), dimensions.begin(),
      [&](const std::string& name) { return this->Dimensions[name]; });
    const nc_type type =
      std::holds_alternative<std::vector<int>>(variable.Values) ? NC_INT : NC_DOUBLE;
    this->Try(
      [&]
      {
        return nc_def_var(this->Id, variable.Name.c_str(), type,
          static_cast<int>(dimensions.size()), dimensions.data(), &this->Variables[variable.Name]);
      });
    if (!variable.Units.empty())
    {
      this->AddText(this->Variables[variable.Name], "units", variable.Units);
    }
  }

  void AddText(int variable, const char* name, const std::string& text)
  {
    this->Try([&] { return nc_put_att_text(this->Id, variable, name, text.size(), text.c_str()); });
  }

  void Try(int status) { this->Status = this->Status == NC_NOERR ? status : this->Status; }

  template <class Step>
  void Try(const Step& step)
  {
    this->Status = this->Status == NC_NOERR ? step() : this->Status;
  }

  int Id = -1;
  int Status = NC_NOERR;
  std::map<std::string, int> Dimensions;
  std::map<std::string, int> Variables;
};
}

std::string SkdWriteNetCdf(const std::string& fileName, const SkdNetCdfContents& contents)
{
  File file(fileName);
  file.Define(contents);
  for (const SkdNetCdfContents::Variable& variable : contents.Variables)
  {
    file.Put(variable);
  }
  const int status = file.Close();
  return status == NC_NOERR
    ? std::string()
    : "The file " + fileName + " could not be written: " + nc_strerror(status) + ".";
}

#else

std::string SkdWriteNetCdf(const std::string& fileName, const SkdNetCdfContents&)
{
  return "The file " + fileName +
    " was not written: this build has no netCDF. Build it where VTK's netCDF and its headers are "
    "(Debian: libnetcdf-dev), or take the table of weights.";
}

#endif
}
