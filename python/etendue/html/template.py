"""Jinja2, with the templates that all pages share."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from etendue.extras import extra

_SHARED = Path(__file__).parent


def rendered(template: Path, values: Mapping[str, object]) -> str:
    """The page. Templates beside `template` and those of this folder may be included."""
    jinja2 = extra("jinja2")
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader([template.parent, _SHARED]),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    page: str = environment.get_template(template.name).render(values)
    return page
