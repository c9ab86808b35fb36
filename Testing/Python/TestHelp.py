# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What help(), editors and type checkers show: every method of the classes has its comment, every
class its stub, and the layer over them is typed and documented."""

import ast
import inspect
import os

import vtkskdtree
from vtkskdtree import Locator, Tree, arrays, tree, vtkFiltersSkdTree, vtkSkdTreeCellLocator

FOLDER = os.path.dirname(vtkskdtree.__file__)
FROM_MACROS = {"IsTypeOf", "IsA", "SafeDownCast", "NewInstance", "GetNumberOfGenerationsFromBaseType",
    "GetNumberOfGenerationsFromBase"}
CLASSES = {name: made for name, made in vars(vtkFiltersSkdTree).items()
    if inspect.isclass(made) and name.startswith("vtkSkdTree")}


def own_methods(made):
    return [(name, method) for name, method in vars(made).items()
        if inspect.isroutine(method) and not name.startswith("_") and name not in FROM_MACROS]


def test_every_method_has_its_comment():
    assert len(CLASSES) > 10
    for name, made in CLASSES.items():
        assert len(made.__doc__) > 100, name
        for method, function in own_methods(made):
            signatures, _, text = function.__doc__.partition("\n\n")
            # In headers groups begin with //@{: VTK 9.1 reads the comment of a ///@{ for its first only.
            assert signatures.startswith(method + "(") and len(text.strip()) > 8, (name, method)


def words(thing):
    return " ".join(thing.__doc__.split())


def test_comments_are_whole():
    assert words(vtkSkdTreeCellLocator.FindAllHits).endswith("`tol` is that of IntersectWithLine.")
    assert "sorted by (t, cell id)" in words(vtkSkdTreeCellLocator.FindAllHits)
    assert words(vtkSkdTreeCellLocator.FindClosestPoints).endswith("and its distance.")
    assert "leave the outputs unchanged" in words(vtkFiltersSkdTree.vtkSkdTreeBatchCellLocator)
    assert Locator.FindAllHits.__doc__ == inspect.getdoc(vtkSkdTreeCellLocator.FindAllHits)


def test_every_class_has_its_stub():
    path = os.path.join(FOLDER, "vtkFiltersSkdTree.pyi")
    try:
        import vtkmodules.generate_pyi  # noqa: F401
    except ImportError:
        return
    with open(path, encoding="utf-8") as file:
        module = ast.parse(file.read())
    stubs = {node.name: {inner.name for inner in node.body if isinstance(inner, ast.FunctionDef)}
        for node in module.body if isinstance(node, ast.ClassDef)}
    assert set(stubs) == set(CLASSES)
    for name, made in CLASSES.items():
        missing = {method for method, _ in own_methods(made)} - stubs[name]
        assert not missing, (name, missing)


def test_layer_is_typed_and_documented():
    assert os.path.exists(os.path.join(FOLDER, "py.typed"))
    for module in (tree, arrays):
        names = [name for name in vars(module) if not name.startswith("_")]
        for name in names:
            thing = getattr(module, name)
            if getattr(thing, "__module__", None) != module.__name__:
                continue
            assert thing.__doc__, name
            functions = [thing] if inspect.isfunction(thing) else [
                function for _, function in inspect.getmembers(thing, inspect.isfunction)
                if function.__module__ == module.__name__]
            for function in functions:
                known = set(function.__annotations__)
                needed = set(inspect.signature(function).parameters) - {"self"} | {"return"}
                assert needed <= known, (name, function.__name__, needed - known)
    methods = [name for name, _ in own_methods(Tree)]
    for name in methods:
        assert len(getattr(Tree, name).__doc__) > 40, name
    with open(os.path.join(os.environ["SKDTREE_SOURCE_DIR"], "Plugin", "Documentation", "Python.md"),
            encoding="utf-8") as page:
        text = page.read()
    for name in methods:
        assert f"`{name}(" in text or f"tree.{name}(" in text, name
    assert {"Tree", "Locator"} <= set(dir(vtkskdtree))


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name)
