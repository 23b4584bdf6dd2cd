// A session that takes over what an earlier one has built makes the same picture as one that takes over nothing.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <etendue/error.h>
#include <etendue/render_session.h>

#include "core/io/temporary_directory.h"
#include "math/rgb.h"
#include "support/hdr_file.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

std::vector<float> picture(RenderSession& session) {
    session.start();
    session.wait();
    return session.snapshot().find(Aov::Color)->data;
}

RenderSettings settings() { return small_settings(IntegratorKind::Bdpt, 12, 2); }

struct Edit {
    const char* name;
    std::function<void(SceneDescription&)> apply;
    bool seen = true;  ///< whether the picture changes
};

const std::vector<Edit>& edits() {
    static const std::vector<Edit> all{
        {"nothing", [](SceneDescription&) {}, false},
        {"camera", [](SceneDescription& s) { s.cameras[0].world_from_camera.m[3] += 0.1; }},
        {"material", [](SceneDescription& s) { s.materials[0].model = DiffuseMaterial{{{0.9, 0.2, 0.2}}}; }},
        {"light's power", [](SceneDescription& s) { s.lights[0].intensity *= 2; }},
        {"light's size", [](SceneDescription& s) { s.lights[0].width *= 2; }},
        {"light removed", [](SceneDescription& s) { s.lights.clear(); }},
        {"shape moved", [](SceneDescription& s) { s.shapes[0].parent_from_object.m[7] += 0.2; }},
        {"shape removed", [](SceneDescription& s) { s.shapes.erase(s.shapes.begin()); }},
        {"shapes in another order", [](SceneDescription& s) { std::swap(s.shapes[0], s.shapes[1]); }, false},
        {"shape in two places",
         [](SceneDescription& s) {
             s.shapes.push_back(s.shapes[0]);
             s.shapes.back().parent_from_object.m[7] += 0.3;
         }},
        {"another geometry", [](SceneDescription& s) { s.geometries[0] = SphereDesc{0.5}; }},
        {"an equal geometry", [](SceneDescription& s) { s.geometries[0] = GeometryDesc(*s.geometries[0]); }, false},
        {"a shape that glows",
         [](SceneDescription& s) {
             s.materials.push_back({"/Glow", DiffuseMaterial{}, {{3, 2, 1}}});
             s.shapes[0].materials = {static_cast<int>(s.materials.size()) - 1};
         }},
        {"instance moved", [](SceneDescription& s) { s.instances[0].world_from_group.m[3] += 0.3; }},
        {"instance removed", [](SceneDescription& s) { s.instances.pop_back(); }},
        {"shape of a group moved", [](SceneDescription& s) { s.groups[0].shapes[0].parent_from_object.m[7] += 0.1; }},
    };
    return all;
}

TEST(Takeover, MakesThePictureOfTheEditedScene) {
    const SceneDescription scene = instanced_box();
    const auto first = std::make_unique<RenderSession>(scene, settings());
    const std::vector<float> before = picture(*first);
    for (const Edit& edit : edits()) {
        SCOPED_TRACE(edit.name);
        SceneDescription edited = scene;
        edit.apply(edited);
        RenderSession taking(edited, settings(), {}, first.get());
        RenderSession fresh(edited, settings());
        const std::vector<float> expected = picture(fresh);
        EXPECT_EQ(picture(taking), expected);
        EXPECT_EQ(expected != before, edit.seen);
    }
}

/// What was taken over stays although its first owner has gone, through any number of edits.
TEST(Takeover, OutlivesWhatItTookOver) {
    SceneDescription scene = instanced_box();
    auto session = std::make_unique<RenderSession>(scene, settings());
    session->start();
    for (const Edit& edit : edits()) {
        if (scene.lights.empty() || scene.instances.empty()) break;
        edit.apply(scene);
        session = std::make_unique<RenderSession>(scene, settings(), ProgressCallback{}, session.get());
        session->start();
    }
    RenderSession last(scene, settings(), {}, session.get());
    session.reset();
    RenderSession fresh(scene, settings());
    EXPECT_EQ(picture(last), picture(fresh));
}

/// The file has gone when the second session is made.
TEST(Takeover, ReadsNoTextureAgain) {
    const TemporaryDirectory directory;
    const std::string file = directory.file("sky.hdr");
    write_hdr(file, 4, 2, [](int x, int) { return Rgb(x == 1 ? 4 : 0.5); });
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.diffuse(0.5));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.texture_file = file;
    b.light(dome);
    b.camera({0, 0, 5}, {0, 0, 0}, 40);
    RenderSession first(b.scene(), settings());
    const std::vector<float> expected = picture(first);
    std::filesystem::remove(file);
    RenderSession taking(b.scene(), settings(), {}, &first);
    EXPECT_EQ(picture(taking), expected);
    EXPECT_THROW(RenderSession(b.scene(), settings()), FileError);
    b.scene().lights[0].texture_color_space = TextureColorSpace::Raw;
    EXPECT_THROW(RenderSession(b.scene(), settings(), {}, &first), FileError);
}

}  // namespace
}  // namespace etendue::test
