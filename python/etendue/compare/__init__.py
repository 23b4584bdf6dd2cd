"""Two pictures of one scene, by any renderers: how their brightness differs, and where."""

from etendue.compare.comparison import Comparison, Distance, compare
from etendue.compare.page import write_page
from etendue.compare.ratio import Ratio

__all__ = ["Comparison", "Distance", "Ratio", "compare", "write_page"]
