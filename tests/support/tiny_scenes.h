#pragma once

#include <etendue/scene_description.h>

namespace etendue::test {

/// Small scenes that exercise one kind of transport each; all but delta_lights have lights that paths can find by
/// chance, so that camera strategies alone see everything.
[[nodiscard]] SceneDescription diffuse_box();         ///< lamp under the ceiling, a block
[[nodiscard]] SceneDescription indirect_box();        ///< lamp turned to the ceiling
[[nodiscard]] SceneDescription glossy_box();          ///< rough metal, UsdPreviewSurface plastic
[[nodiscard]] SceneDescription phong_box();           ///< a block and a ball of classic Phong
[[nodiscard]] SceneDescription layered_box();         ///< coated rough ball, rough pane
[[nodiscard]] SceneDescription glass_box();           ///< smooth glass sphere, large lamp
[[nodiscard]] SceneDescription rough_glass_box();     ///< frosted glass sphere
[[nodiscard]] SceneDescription mirror_box();          ///< mirror sphere
[[nodiscard]] SceneDescription smooth_normals_box();  ///< low-polygon spheres with smooth normals
[[nodiscard]] SceneDescription sky();                 ///< dome and a broad sun over a plane with a sphere
[[nodiscard]] SceneDescription image_sky();           ///< a dome with a latlong image, turned, over a plane and a ball
[[nodiscard]] SceneDescription shaped_lights();       ///< beams of all kinds, a cylinder, a picture on a rect
[[nodiscard]] SceneDescription many_lights();         ///< every kind of light that has a size, a glowing mesh too
[[nodiscard]] SceneDescription aimed_lights();        ///< lamp, ball and sun aimed at two small frosted glass balls
[[nodiscard]] SceneDescription light_crowd();         ///< 300 small lamps that face everywhere, and a faint dome
[[nodiscard]] SceneDescription delta_lights();        ///< point and delta sun
[[nodiscard]] SceneDescription lens_box();            ///< wide thin lens before the diffuse box
[[nodiscard]] SceneDescription orthographic_box();    ///< orthographic view from below, the lamp in the picture
[[nodiscard]] SceneDescription orthographic_sky();    ///< orthographic view of the sky's scene, the sky in the picture
[[nodiscard]] SceneDescription instanced_box();       ///< mirrored, scaled instances, some glowing
[[nodiscard]] SceneDescription pool();                ///< small lamp over water, seen from the waterline
[[nodiscard]] SceneDescription coordinate_planes();   ///< lights that lie exactly in the planes z = 0 and y = 0

}  // namespace etendue::test
