#pragma once

#include <etendue/scene_description.h>

#include "math/vec.h"

namespace etendue::test {

/// The scene `scale` times as large, lit so that its picture is the same: radiances stay, what is authored as power or
/// intensity grows with area.
[[nodiscard]] SceneDescription scaled(SceneDescription scene, double scale);

/// The same scene, whose groups' shapes lie elsewhere in their groups and whose instances bring them back.
[[nodiscard]] SceneDescription moved_within_groups(SceneDescription scene, const Vec3& offset);

/// The scene elsewhere, moved by its transforms: authored points stay as they are.
[[nodiscard]] SceneDescription moved(SceneDescription scene, const Vec3& offset);

}  // namespace etendue::test
