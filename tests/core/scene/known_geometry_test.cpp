// What a scene takes over from the one before it.

#include <gtest/gtest.h>

#include "scene/known_geometry.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// Two balls of the same description, in different places, and a mesh.
SceneDescription balls() {
    SceneBuilder b;
    const int grey = b.diffuse(0.5);
    b.sphere({0, 0, 0}, 1, grey);
    b.scene().shapes.push_back(b.scene().shapes[0]);
    b.scene().shapes[1].parent_from_object = translation({3, 0, 0});
    b.shape(low_polygon_sphere(6, 4, false), grey);
    return b.scene();
}

std::vector<PlacedShape> place(const SceneDescription& scene, const KnownGeometry& known, bool as_mesh = false) {
    std::vector<PlacedShape> placed;
    for (const ShapeDesc& shape : scene.shapes)
        placed.push_back(place_shape(shape, scene, as_mesh, find_requirements(scene, {}).texture_coordinates, known));
    return placed;
}

TEST(KnownGeometry, IsTheSameDescriptionInTheSamePlace) {
    const SceneDescription scene = balls();
    const std::vector<PlacedShape> first = place(scene, {});
    KnownGeometry known;
    known.add(first);
    known.sort();
    SceneDescription edited = scene;
    std::swap(edited.shapes[0], edited.shapes[1]);
    edited.shapes[2].materials = {0};
    const std::vector<PlacedShape> same = place(edited, known);
    EXPECT_EQ(same[0].geometry, first[1].geometry);
    EXPECT_EQ(same[1].geometry, first[0].geometry);
    EXPECT_EQ(same[2].geometry, first[2].geometry);
    edited.shapes[0].parent_from_object.m[3] += 1;               // moved
    edited.geometries[1] = GeometryDesc(*edited.geometries[1]);  // equal, but not known to be
    const std::vector<PlacedShape> other = place(edited, known);
    EXPECT_NE(other[0].geometry, first[1].geometry);
    EXPECT_EQ(other[1].geometry, first[0].geometry);
    EXPECT_NE(other[2].geometry, first[2].geometry);
    // Triangles where there was an exact surface.
    EXPECT_NE(place(scene, known, true)[0].geometry, first[0].geometry);
}

TEST(KnownGeometry, KeepsNoDescriptionAlive) {
    std::vector<PlacedShape> placed;
    std::weak_ptr<const GeometryDesc> description;
    {
        const SceneDescription scene = balls();
        description = scene.geometries[0].pointer();
        placed = place(scene, {});
    }
    EXPECT_TRUE(description.expired());
}

}  // namespace
}  // namespace etendue::test
