"""The systems of the corpus as formulas, entered by their modules."""

from . import bodies, galaxies, lattices, statistics, wells
from .common import SYSTEMS

__all__ = ["SYSTEMS", "bodies", "galaxies", "lattices", "statistics", "wells"]
