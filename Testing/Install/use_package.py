# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Use the Python package in plain Python; it must come from below the folder that is named."""

import os
import sys

import vtkskdtree
from vtkskdtree import vtkSkdTreeCellLocator, vtkSkdTreeClosestPoint
from vtkmodules.vtkCommonDataModel import vtkImageData

folder = os.path.realpath(sys.argv[1])
assert os.path.realpath(vtkskdtree.__file__).startswith(folder), vtkskdtree.__file__

grid = vtkImageData()
grid.SetDimensions(5, 5, 5)
locator = vtkSkdTreeCellLocator()
locator.SetDataSet(grid)
locator.BuildLocator()
assert locator.FindCell([1.5, 2.5, 3.5]) == 1 + 4 * (2 + 4 * 3)

closest = vtkSkdTreeClosestPoint()
closest.SetInputData(grid)
closest.SetSourceData(grid)
closest.Update()
assert closest.GetOutputDataObject(0).GetPointData().GetArray("SkdDistance").GetRange() == (0, 0)
tree = vtkskdtree.Tree(grid)
assert tree.find_cells([[1.5, 2.5, 3.5]]).cell.tolist() == [1 + 4 * (2 + 4 * 3)]
assert tree.closest([[2, 2, 7]]).distance.tolist() == [3]
print("vtkskdtree", vtkskdtree.__version__, "from", folder)
