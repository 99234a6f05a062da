"""No module of the package or of the Blender add-on imports itself through others."""

import ast
import graphlib
import unittest
from pathlib import Path

from .support import ROOT

PACKAGES = (
    ROOT / "python" / "lancret",
    ROOT / "python" / "blender" / "lancret_blender",
)


def modules(package: Path) -> dict[str, ast.Module]:
    """The syntax tree of each module of a package, by its dotted name."""
    trees = {}
    for path in sorted(package.rglob("*.py")):
        parts = [package.name, *path.relative_to(package).with_suffix("").parts]
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        trees[name] = ast.parse(path.read_text(), path)
    return trees


def imports(name: str, tree: ast.Module, names: set[str], is_package: bool) -> set[str]:
    """The modules of the same package that a module imports, anywhere in its code."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            up = node.level - 1 if is_package else node.level
            parents = name.split(".")[: -up or None] if node.level else []
            base = ".".join(parents + (node.module.split(".") if node.module else []))
            for alias in node.names:
                submodule = f"{base}.{alias.name}"
                found.add(submodule if submodule in names else base)
    return found & names


def graph(package: Path) -> dict[str, set[str]]:
    trees = modules(package)
    names = set(trees)
    packages = {name.rpartition(".")[0] for name in names} | {package.name}
    return {
        name: imports(name, tree, names, name in packages)
        for name, tree in trees.items()
    }


class Imports(unittest.TestCase):
    def test_have_no_circle(self):
        for package in PACKAGES:
            with self.subTest(package=package.name):
                edges = graph(package)
                self.assertGreater(sum(map(len, edges.values())), 10)
                graphlib.TopologicalSorter(edges).prepare()  # raises CycleError

    def test_of_every_form_are_found(self):
        tree = ast.parse(
            "import a.b\nfrom . import c\nfrom .d import x\n"
            "def f():\n    from .. import e, y\n"
        )
        names = {"a", "a.b", "a.p.c", "a.p.d", "a.e"}
        self.assertEqual(
            imports("a.p.q", tree, names, False), {"a.b", "a.p.c", "a.p.d", "a.e", "a"}
        )
