# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's accessor mesh.skd: what vtkskdtree does with a mesh, as methods of the mesh.

PyVista 0.48 and later find it by the entry point of the wheel; elsewhere import vtkskdtree.accessor once.
"""

from __future__ import annotations

import functools
from typing import Any, Callable

import pyvista

from . import operations
from .tree import Tree


class SkdAccessor:
    """The queries of vtkskdtree.Tree and the functions of vtkskdtree for one mesh of PyVista.

    As in mesh.skd.closest(points) and mesh.skd.union(other, ...). The tree is built by the first query and
    kept with the mesh; after changing arrays of the mesh in place call mesh.skd.tree.update(). Functions
    give back meshes of PyVista."""

    def __init__(self, dataset: Any) -> None:
        self._mesh = dataset

    @functools.cached_property
    def tree(self) -> Tree:
        """The tree of the mesh, for settings and for functions that take one."""
        return Tree(self._mesh)


def _method_of_tree(query: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(query)
    def method(self: SkdAccessor, *arguments: Any, **named: Any) -> Any:
        return query(self.tree, *arguments, **named)

    return method


def _method_of_mesh(function: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def method(self: SkdAccessor, *arguments: Any, **named: Any) -> Any:
        return function(self._mesh, *arguments, **named)

    return method


for _name in ("closest", "k_nearest", "within", "rays", "segments", "find_cells", "interpolate", "in_boxes", "pairs",
        "collide", "signed_distance", "contains", "winding_number"):
    setattr(SkdAccessor, _name, _method_of_tree(getattr(Tree, _name)))
for _name in ("union", "intersection", "difference", "symmetric_difference", "split", "section",
        "intersection_curves", "compare", "thickness", "remap"):
    setattr(SkdAccessor, _name, _method_of_mesh(getattr(operations, _name)))

pyvista.register_dataset_accessor("skd", pyvista.DataSet)(SkdAccessor)
