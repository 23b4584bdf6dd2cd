"""Two pictures of one scene, by any renderers: how their brightness differs, and where."""

from etendue.comparison.comparison import Comparison, compare
from etendue.comparison.distance import Distance
from etendue.comparison.page import write_page
from etendue.comparison.ratio import Ratio

__all__ = ["Comparison", "Distance", "Ratio", "compare", "write_page"]
