// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedMeshes.h
 * @brief the meshes that tests of a query walk through, by name
 */
#ifndef skdtest_NamedMeshes_h
#define skdtest_NamedMeshes_h

#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"

#include <ostream>

namespace skdtest
{

struct NamedMesh
{
  const char* Name;
  std::function<DataSetPointer()> Make;

  // What the name of a parameter is in the output of GoogleTest.
  friend void PrintTo(const NamedMesh& mesh, std::ostream* os) { *os << mesh.Name; }
};

/// For INSTANTIATE_TEST_SUITE_P.
struct NameOfMesh
{
  template <typename Info>
  std::string operator()(const Info& info) const
  {
    return info.param.Name;
  }
};

std::vector<NamedMesh> CurveMeshes();

std::vector<NamedMesh> SurfaceMeshes();

std::vector<NamedMesh> VolumeMeshes();

std::vector<NamedMesh> AllMeshes();

}

#endif
