// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeKinds.h
 * @brief the meshes of volume cells that filters are measured on, by name
 */
#ifndef skdbench_VolumeKinds_h
#define skdbench_VolumeKinds_h

#include "Support/VolumeMeshes.h"

#include <algorithm>
#include <string>

namespace skdbench
{

struct Kind
{
  const char* Name;
  skdtest::Mesh (*Make)(int n);
  int CellsACube;
};

inline const Kind Kinds[] = { { "tetrahedra", skdtest::Tetrahedra, 6 },
  { "hexahedra", skdtest::Hexahedra, 1 }, { "wedges", skdtest::Wedges, 2 },
  { "pyramids", skdtest::Pyramids, 6 }, { "polyhedra", skdtest::Polyhedra, 1 } };

/// Whether a program's arguments from the third on name it, or there are none.
inline bool IsWanted(const Kind& kind, int argc, char* argv[])
{
  return argc < 4 ||
    std::any_of(
      argv + 3, argv + argc, [&](const char* name) { return kind.Name == std::string(name); });
}

}

#endif
