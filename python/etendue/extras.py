"""Packages of the extra `report`, imported when they are used: a render needs none of them."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from etendue.exceptions import Error


def extra(module: str) -> ModuleType:
    """The module. Raises Error, saying what to install, when it is missing."""
    try:
        return import_module(module)
    except ModuleNotFoundError as missing:
        raise Error(
            f"the package that holds '{missing.name}' is not installed: "
            "pip install 'etendue[report]' installs all that comparisons and reports need"
        ) from missing
