"""Reads and writes USD with `usd-core` (pip install lancret[usd]).

strands = lancret.usd.read("guides.usda")
with lancret.open(strands=strands, scalp=lancret.usd.read_mesh("guides.usda")) as groom:
    lancret.usd.write("hair.usdc", groom)
"""

from .checker import complaints
from .read import read
from .read_mesh import read_mesh
from .write import add_curves, write

__all__ = ["add_curves", "complaints", "read", "read_mesh", "write"]
