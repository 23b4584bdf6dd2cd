"""The tree keeps the direction of its rooms, and the check that says so notices otherwise."""

from __future__ import annotations

from pathlib import Path

import pytest

from layering.layering import ARROWS, violations

ROOT = Path(__file__).resolve().parents[2]


def plant(root: Path, place: str, line: str) -> None:
    file = root / place
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"// first\n{line}\n" if file.suffix != ".py" else f"\n{line}\n")


def test_tree_keeps_its_direction() -> None:
    assert violations(ROOT) == []


def test_every_room_is_known() -> None:
    rooms = {path.name for path in (ROOT / "core" / "src").iterdir() if path.is_dir()}
    assert rooms <= set(ARROWS)


@pytest.mark.parametrize(
    ("place", "line"),
    [
        ("core/src/math/vec.h", '#include "geometry/ray.h"'),
        ("core/src/util/text.cpp", '#include "math/vec.h"'),
        ("core/src/texture/image.cpp", '#include "bsdf/bsdf.h"'),
        ("core/src/light/dome.cpp", '#include "scene/scene.h"'),
        ("core/src/bsdf/diffuse.h", '#include "light/light.h"'),
        ("core/src/accel/embree_accel.cpp", '#include "camera/camera.h"'),
        ("core/src/film/film.cpp", '#include "integrator/path/path.h"'),
        ("core/src/film/film.cpp", '#include "geometry/ray.h"'),
        ("core/src/scene/scene.cpp", '#include "film/film.h"'),
        ("core/src/integrator/path/path.cpp", '#include "session/render_session.h"'),
        ("core/src/integrator/path/path.cpp", '#include "io/exr.h"'),
        ("core/src/integrator/path/path.cpp", '#include "integrator/bdpt/vertex.h"'),
        ("core/src/light/dome.cpp", "#include <io/exr.h>"),
        ("core/src/geometry/mesh.cpp", "#include <embree3/rtcore.h>"),
        ("core/src/geometry/mesh.h", "  #  include <embree3/rtcore.h>"),
        ("core/src/film/film.cpp", "#include <OpenImageIO/imageio.h>"),
        ("core/src/session/display.cpp", "#include <OpenColorIO/OpenColorIO.h>"),
        ("core/src/film/film.cpp", "#include <tbb/parallel_for.h>"),
        ("core/src/film/film.cpp", "#include <oneapi/tbb/parallel_for.h>"),
        ("core/src/io/exr.cpp", "#include <pybind11/pybind11.h>"),
        ("core/src/math/special.cpp", "#include <boost/math/special_functions.hpp>"),
        ("core/src/magic/wand.h", ""),
        ("core/include/etendue/film_view.h", '#include "film/film.h"'),
        ("core/include/etendue/film_view.h", "#include <tbb/parallel_for.h>"),
        ("python/bindings/film.cpp", '#include "film/film.h"'),
        ("python/bindings/film.cpp", '#include "../../core/src/film/film.h"'),
        ("python/bindings/film.cpp", "#include <OpenImageIO/imageio.h>"),
        ("plugin/hdEtendue/mesh.cpp", "#include <geometry/mesh.h>"),
        ("plugin/hdEtendue/mesh.cpp", "#include <pybind11/pybind11.h>"),
        ("python/etendue/cli.py", "from pxr import Usd"),
        ("python/etendue/validation/cases.py", "import pxr.Usd"),
    ],
)
def test_violation_is_seen(tmp_path: Path, place: str, line: str) -> None:
    plant(tmp_path, place, line)
    found = violations(tmp_path)
    assert len(found) == 1
    assert found[0].startswith(place)


@pytest.mark.parametrize(
    ("place", "line"),
    [
        ("core/src/session/render_session.cpp", '#include "math/vec.h"'),
        ("core/src/session/render_session.cpp", '#include "io/exr.h"'),
        ("core/src/session/render_session.cpp", "#include <tbb/parallel_for.h>"),
        ("core/src/integrator/bdpt/mis.cpp", '#include "integrator/integrator.h"'),
        ("core/src/integrator/bdpt/mis.cpp", '#include "integrator/bdpt/vertex.h"'),
        ("core/src/integrator/bdpt/mis.cpp", '#include "film/film.h"'),
        ("core/src/scene/scene.cpp", '#include "io/exr.h"'),
        ("core/src/accel/embree_accel.cpp", "#include <embree3/rtcore.h>"),
        ("core/src/texture/image.cpp", "#include <OpenImageIO/imageio.h>"),
        ("core/src/texture/image.h", "#include <OpenImageIO/imageio.h>"),
        ("core/src/math/vec.h", "#include <etendue/error.h>"),
        ("core/src/math/vec.h", "#include <cmath>"),
        ("core/include/etendue/film_view.h", "#include <etendue/export.h>"),
        ("python/bindings/film.cpp", "#include <pybind11/numpy.h>"),
        ("python/bindings/film.cpp", "#include <etendue/film_view.h>"),
        ("plugin/hdEtendue/mesh.cpp", "#include <pxr/usd/usdGeom/mesh.h>"),
        ("python/etendue/usd_reader/stage.py", "from pxr import Usd"),
    ],
)
def test_permitted_line_passes(tmp_path: Path, place: str, line: str) -> None:
    plant(tmp_path, place, line)
    assert violations(tmp_path) == []


def test_third_party_stays_in_its_room(tmp_path: Path) -> None:
    plant(tmp_path, "core/src/texture/detail.h", "#include <OpenImageIO/imageio.h>")
    plant(tmp_path, "core/src/texture/image.h", '#include "texture/detail.h"')
    plant(tmp_path, "core/src/texture/image.cpp", '#include "texture/image.h"')
    assert violations(tmp_path) == []
    plant(tmp_path, "core/src/scene/scene.cpp", '#include "texture/image.h"')
    assert len(violations(tmp_path)) == 1
