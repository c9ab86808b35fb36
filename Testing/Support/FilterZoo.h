// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterZoo.h
 * @brief every filter and the locator, set up to look at a mesh of some cells in [0, 2.5]^3
 */
#ifndef skdtest_FilterZoo_h
#define skdtest_FilterZoo_h

#include "Support/MeshBuilder.h"

#include "vtkAlgorithm.h"

#include <functional>
#include <string>
#include <vector>

namespace skdtest
{

/// A filter with the mesh as one of its inputs.
struct FilterSetup
{
  std::string Name;
  std::function<vtkSmartPointer<vtkAlgorithm>(vtkDataObject* mesh)> Make;
};

/// All filters, and each in every part that a mesh may take in it.
const std::vector<FilterSetup>& AllFilterSetups();

/// All outputs of an updated filter by value: points, types and sizes of cells, point ids, arrays.
std::vector<double> AnswersOf(vtkAlgorithm* filter);

/// Whether these are the same numbers or NaN in the same places.
bool AreEqual(const std::vector<double>& a, const std::vector<double>& b);

/// The locator's results of a few queries of all kinds, its tree built beforehand.
std::vector<double> LocatorAnswers(vtkDataSet* mesh);

}

#endif
