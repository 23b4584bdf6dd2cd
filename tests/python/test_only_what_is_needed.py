"""What a picture does not show is neither opened nor kept, and textures stay within their limit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from pxr import Sdf, UsdGeom, UsdShade

import etendue
from etendue import _core
from support.hdr_file import write_hdr
from support.stage_builder import StageBuilder, Types

SMALL = etendue.RenderOptions(resolution=(8, 8), spp=1, integrator="path", threads=1)


@pytest.fixture
def unreadable(tmp_path: Path) -> Path:
    """No image: whoever opens it for texels fails."""
    file = tmp_path / "unreadable.png"
    file.write_bytes(b"no picture")
    return file


def wear_unreadable(build: StageBuilder, mesh: UsdGeom.Mesh, file: Path) -> UsdShade.Material:
    node = build.node("UsdUVTexture", "/Looks/Texture", file=Sdf.AssetPath(str(file)))
    material = build.material(path="/Looks", diffuseColor=node.CreateOutput("rgb", Types.Float3))
    build.bind(mesh, material)
    return material


def test_texture_that_is_seen_is_opened(build: StageBuilder, unreadable: Path) -> None:
    """What makes the tests below tests."""
    wear_unreadable(build, build.lit_quad().quad("/Wearer"), unreadable)
    with pytest.raises(etendue.FileError, match=r"/Looks/Texture: cannot read .*unreadable\.png"):
        etendue.open(build.stage).render(**SMALL)


@pytest.mark.parametrize("reason", ["unbound", "invisible", "guide", "inactive"])
def test_texture_that_is_not_seen_is_not_opened(
    build: StageBuilder, unreadable: Path, reason: str
) -> None:
    wearer = build.lit_quad().quad("/Wearer")
    wear_unreadable(build, wearer, unreadable)
    match reason:
        case "unbound":
            UsdShade.MaterialBindingAPI(wearer).UnbindAllBindings()
        case "invisible":
            wearer.MakeInvisible()
        case "guide":
            wearer.CreatePurposeAttr("guide")
        case "inactive":
            wearer.GetPrim().SetActive(False)
    assert build.read().scene.textures == []
    etendue.open(build.stage).render(**SMALL)


def test_group_without_instances_is_not_placed(build: StageBuilder, unreadable: Path) -> None:
    scene = build.lit_quad().read().scene
    texture = scene.add_texture(_core.TextureDesc(name="/T", file=str(unreadable)))
    model = _core.DiffuseMaterial(reflectance=_core.ColorInput(texture=texture))
    material = scene.add_material(_core.MaterialDesc(name="/M", model=model))
    shape = _core.ShapeDesc(name="/S", geometry=0, materials=[material])
    group = scene.add_group(_core.GroupDesc(name="/G", shapes=[shape]))
    settings = _core.RenderSettings(width=8, height=8, samples_per_pixel=1)
    alone = _core.RenderSession(scene, settings).memory_use
    assert alone.vertices == 5 * 12 + 2 * 12
    scene.add_instance(_core.InstanceDesc(name="/I", group=group))
    with pytest.raises(etendue.FileError, match=r"unreadable\.png"):
        _core.RenderSession(scene, settings)


def test_material_that_nothing_is_made_of_is_not_converted(
    build: StageBuilder, unreadable: Path
) -> None:
    """A description may hold what no shape uses: neither its texture is opened nor its index of
    refraction looked at."""
    scene = build.lit_quad().read().scene
    texture = scene.add_texture(_core.TextureDesc(name="/T", file=str(unreadable)))
    glass = _core.DielectricMaterial(ior=-1.0, reflection_tint=_core.ColorInput(texture=texture))
    bound = scene.add_material(_core.MaterialDesc(name="/Glass", model=glass))
    settings = _core.RenderSettings(width=8, height=8, samples_per_pixel=1)
    needs = _core.RenderSession(scene, settings).requirements
    assert needs.materials == [True, False]
    assert needs.textures == [[False] * 4]
    assert not needs.lobes.smooth_transmission
    shapes = scene.shapes
    shapes[0].materials = [bound]
    scene.shapes = shapes
    with pytest.raises(etendue.FileError, match=r"unreadable\.png"):
        _core.RenderSession(scene, settings)


def test_light_that_is_off_leaves_its_texture_alone(build: StageBuilder, unreadable: Path) -> None:
    light = build.lit_quad().light("DomeLight", "/Dome", intensity=0.0)
    light.GetAttribute("inputs:texture:file").Set(Sdf.AssetPath(str(unreadable)))
    etendue.open(build.stage).render(**SMALL)
    light.GetAttribute("inputs:intensity").Set(1.0)
    with pytest.raises(etendue.FileError, match=r"unreadable\.png"):
        etendue.open(build.stage).render(**SMALL)


def test_strategies_that_carry_nothing_are_left_out(build: StageBuilder) -> None:
    build.quad()
    build.camera()
    build.light("SphereLight", radius=0.0)
    scene = build.read().scene
    settings = _core.RenderSettings()
    carrying = _core.find_requirements(scene, settings).strategies
    assert not carrying.emission_hit  # no path finds a point
    assert carrying.direct_light
    assert carrying.connection
    assert carrying.light_image
    assert not carrying.lens_hit  # a pinhole
    settings.max_depth = 1
    assert not _core.find_requirements(scene, settings).strategies.connection
    settings.integrator = _core.IntegratorKind.Path
    assert not _core.find_requirements(scene, settings).light_paths


def test_last_render_takes_the_geometry(build: StageBuilder) -> None:
    stage = etendue.open(build.lit_quad().stage)
    again = stage.render(**SMALL)
    image = stage.session(last=True, **SMALL).run()
    np.testing.assert_array_equal(image.color, again.color)
    assert stage.scene.geometries == []
    with pytest.raises(etendue.SceneError, match="given to its last render"):
        stage.session(**SMALL)


# ------------------------------------------------------------------------------- memory of textures


def test_textures_stay_within_their_limit(build: StageBuilder, tmp_path: Path) -> None:
    """A hundred pictures of 0.75 MB each once decoded. Each of two threads, the one that opens them
    and the one that renders, may hold eight of them beyond the limit."""
    pixels = 256
    first = tmp_path / "0.hdr"
    write_hdr(first, np.full((pixels, pixels, 3), 0.5))
    build.camera()
    build.light(intensity=50.0)
    scene = build.read().scene
    for number in range(100):
        file = tmp_path / f"{number + 1}.hdr"
        file.hardlink_to(first)
        texture = scene.add_texture(_core.TextureDesc(name="/T", file=str(file)))
        model = _core.DiffuseMaterial(reflectance=_core.ColorInput(texture=texture))
        mesh = _core.MeshDesc(
            points=0.1 * np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]),
            face_vertex_counts=np.array([4]),
            face_vertex_indices=np.arange(4),
            st=np.array([(0, 0), (1, 0), (1, 1), (0, 1)]),
        )
        place = np.eye(4)
        place[:2, 3] = 0.1 * (number // 10), 0.1 * (number % 10)
        scene.add_shape(
            _core.ShapeDesc(
                name="/S",
                geometry=scene.add_geometry(mesh),
                materials=[scene.add_material(_core.MaterialDesc(name="/M", model=model))],
                parent_from_object=place,
            )
        )
    picture = pixels * pixels * 3 * 4
    held: dict[float, int] = {}
    images = []
    for limit in (10.0, 1000.0):
        settings = _core.RenderSettings(width=120, height=90, samples_per_pixel=2, threads=1)
        settings.integrator = _core.IntegratorKind.Path
        settings.texture_memory = limit
        session = _core.RenderSession(scene, settings)
        session.start()
        session.wait()
        held[limit] = session.memory_use.textures
        images.append(session.snapshot().array(_core.Aov.Color))
    assert held[10.0] <= 10 * 2**20 + 16 * picture
    assert held[1000.0] >= 100 * picture
    np.testing.assert_array_equal(images[0], images[1])
