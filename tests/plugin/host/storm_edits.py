"""The edits of a storm."""

from __future__ import annotations

from collections.abc import Callable

from pxr import Gf, UsdGeom, UsdLux, UsdShade

from plugin.host.storm_scene import (
    CAMERA,
    COPIES,
    INNER_COPIES,
    LAMP,
    SECOND_LAMP,
    StormScene,
    grid,
)


class StormEdits:
    """Edits in random order, in rounds of one of each kind: the last of each kind is never long ago
    when the storm ends, so that what it left undone can be seen.
    """

    def __init__(self, scene: StormScene) -> None:
        self._scene = scene
        self._chance = scene.chance
        self._round: list[Callable[[], None]] = []

    def make_one(self) -> None:
        """The next edit."""
        if not self._round:
            self._round = list(self._kinds())
            self._chance.shuffle(self._round)
        self._round.pop()()

    def _kinds(self) -> tuple[Callable[[], None], ...]:
        return (
            self._move,
            self._hide,
            self._tag,
            self._remesh,
            self._take_away,
            self._rebind,
            self._rebind_subset,
            self._regroup_faces,
            self._recolor,
            self._exchange_texture,
            self._switch_texture,
            self._scatter,
            self._shift_copies,
            self._hide_copies,
            self._dim,
            self._hide_lamp,
            self._switch_second_lamp,
            self._turn_camera,
            self._change_lens,
        )

    def _mostly(self, shown: str, hidden: str) -> str:
        """So that there is something left to be seen."""
        return shown if self._chance.random() < 0.75 else hidden

    # ----------------------------------------------------------------------------------- shapes

    def _move(self) -> None:
        self._scene.place(self._scene.any_imageable())

    def _hide(self) -> None:
        visibility = self._scene.any_imageable().CreateVisibilityAttr()
        visibility.Set(self._mostly("inherited", "invisible"))

    def _tag(self) -> None:
        purpose = self._scene.any_imageable().CreatePurposeAttr()
        purpose.Set(self._mostly(self._chance.choice(("default", "render")), "guide"))

    def _remesh(self) -> None:
        grid(self._scene.any_sheet(), self._chance.randint(1, 8), self._chance.uniform(0, 1))

    def _take_away(self) -> None:
        self._scene.stage.RemovePrim(self._scene.any_sheet().GetPath())

    # -------------------------------------------------------------------------------- materials

    def _any_subset(self) -> UsdGeom.Subset:
        return UsdGeom.Subset(self._scene.any_sheet().GetPrim().GetChild("Part"))

    def _rebind(self) -> None:
        self._scene.bind(self._scene.any_sheet())

    def _rebind_subset(self) -> None:
        self._scene.bind(self._any_subset())

    def _regroup_faces(self) -> None:
        subset = self._any_subset()
        faces = len(UsdGeom.Mesh(subset.GetPrim().GetParent()).GetFaceVertexCountsAttr().Get())
        subset.GetIndicesAttr().Set(range(self._chance.randint(1, faces)))

    def _recolor(self) -> None:
        color = Gf.Vec3f(*(self._chance.uniform(0.1, 0.9) for _ in range(3)))
        self._scene.surface().GetInput("diffuseColor").Set(color)

    def _image_of(self, surface: UsdShade.Shader) -> UsdShade.Shader:
        return UsdShade.Shader(surface.GetPrim().GetParent().GetChild("Image"))

    def _exchange_texture(self) -> None:
        file = self._image_of(self._scene.surface()).GetInput("file")
        file.Set(self._chance.choice(self._scene.textures))

    def _switch_texture(self) -> None:
        surface = self._scene.surface()
        color = surface.GetInput("diffuseColor")
        if color.HasConnectedSource():
            color.ClearSources()
        else:
            color.ConnectToSource(self._image_of(surface).GetOutput("rgb"))

    # ------------------------------------------------------------------------------- instancers

    def _any_copies(self) -> UsdGeom.PointInstancer:
        path = self._chance.choice((COPIES, INNER_COPIES))
        return UsdGeom.PointInstancer.Get(self._scene.stage, path)

    def _scatter(self) -> None:
        self._scene.scatter(self._any_copies())

    def _shift_copies(self) -> None:
        positions = self._any_copies().GetPositionsAttr()
        shift = Gf.Vec3f(self._chance.uniform(-1, 1), 0, 0)
        positions.Set([place + shift for place in positions.Get()])

    def _hide_copies(self) -> None:
        hidden = self._chance.sample(range(5), self._chance.randint(0, 2))
        self._any_copies().CreateInvisibleIdsAttr().Set(hidden)

    # --------------------------------------------------------------------------- light and view

    def _dim(self) -> None:
        lamp = UsdLux.RectLight.Get(self._scene.stage, LAMP)
        lamp.GetIntensityAttr().Set(self._chance.uniform(10, 60))
        lamp.GetWidthAttr().Set(self._chance.uniform(0.5, 3))

    def _hide_lamp(self) -> None:
        lamp = UsdGeom.Imageable.Get(self._scene.stage, LAMP)
        lamp.CreateVisibilityAttr().Set(self._mostly("inherited", "invisible"))

    def _switch_second_lamp(self) -> None:
        stage = self._scene.stage
        if stage.GetPrimAtPath(SECOND_LAMP):
            stage.RemovePrim(SECOND_LAMP)
            return
        kind = self._chance.choice((UsdLux.SphereLight, UsdLux.DiskLight, UsdLux.DistantLight))
        lamp = kind.Define(stage, SECOND_LAMP)
        lamp.CreateIntensityAttr(2 if kind is UsdLux.DistantLight else 20)
        self._scene.place(lamp)

    def _turn_camera(self) -> None:
        camera = UsdGeom.Camera.Get(self._scene.stage, CAMERA)
        UsdGeom.XformCommonAPI(camera).SetRotate((-10, self._chance.uniform(-15, 15), 0))

    def _change_lens(self) -> None:
        camera = UsdGeom.Camera.Get(self._scene.stage, CAMERA)
        attribute, least, greatest = self._chance.choice(
            (
                (camera.GetFocalLengthAttr(), 25, 50),
                (camera.GetHorizontalApertureAttr(), 30, 40),
                (camera.GetFocusDistanceAttr(), 5, 12),
                (camera.GetFStopAttr(), 0.3, 3),
            )
        )
        attribute.Set(self._chance.uniform(least, greatest))
