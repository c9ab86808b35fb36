// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief the data sets that are searched: made here, or read from files
 */
#ifndef skdbench_Scenes_h
#define skdbench_Scenes_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace skdbench
{

struct Scene
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataSet>()> Make; // nullptr when it cannot be read
};

enum class Size
{
  Tiny,  // seconds in all, to see that everything runs
  Usual, // in and out of cache
  Large  // a million cells each
};

std::vector<Scene> MadeScenes(Size size);

/// A file: vtp, vtu, vtk, ply.
Scene FileScene(const std::string& path);

/// The data sets (vtp, vtu) of a folder, by name.
std::vector<Scene> FolderScenes(const std::string& folder);

/// A closed, bumpy, noisy surface about the origin with 12 n^2 triangles.
vtkSmartPointer<vtkDataSet> NoisySphere(int n);

/// The cube [0, n]^3, turned, in 6 n^3 tetrahedra.
vtkSmartPointer<vtkDataSet> TurnedTetrahedra(int n);

/// Makes what VTK makes on the first access (cells, bounds), so that no structure is charged for
/// it.
void Touch(vtkDataSet* data);

}

#endif
