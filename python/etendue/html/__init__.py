"""What our pages share. A page is one file: it shows the same without a network, and in a year."""

from etendue.html.pictures import common_exposure, picture_url
from etendue.html.ratio_map import Legend, legend, ratio_map_url
from etendue.html.template import rendered

__all__ = ["Legend", "common_exposure", "legend", "picture_url", "ratio_map_url", "rendered"]
