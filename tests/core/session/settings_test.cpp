// Settings that mean nothing are refused with a word that says which.

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>
#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

template <typename Exception>
std::string error_of(const SceneDescription& scene, const RenderSettings& settings) {
    try {
        const RenderSession session(scene, settings);
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

struct BadSettings {
    std::function<void(RenderSettings&)> spoil;
    const char* complaint;
};

TEST(Settings, AreCheckedOneByOne) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<BadSettings> cases{
        {[](auto& s) { s.camera = 1; }, "camera index 1"},
        {[](auto& s) { s.camera = -1; }, "camera index -1"},
        {[](auto& s) { s.width = 0; }, "one pixel"},
        {[](auto& s) { s.height = -3; }, "one pixel"},
        {[](auto& s) { s.crop = {0, 0, 9, 8}; }, "beyond the image"},
        {[](auto& s) { s.crop = {0, -1, 8, 8}; }, "beyond the image"},
        {[](auto& s) { s.crop = {3, 3, 3, 4}; }, "crop is empty"},
        {[](auto& s) { s.crop = {3, 5, 4, 4}; }, "crop is empty"},
        {[](auto& s) { s.samples_per_pixel = -1; }, "samples per pixel"},
        {[](auto& s) { s.samples_per_pixel = 0; }, "or an error target"},
        {[](auto& s) { s.time_limit = -1; }, "time limit"},
        {[=](auto& s) { s.time_limit = nan; }, "time limit"},
        {[=](auto& s) { s.time_limit = inf; }, "time limit"},
        {[](auto& s) { s.error_target = -0.1; }, "error target"},
        {[=](auto& s) { s.error_target = nan; }, "error target"},
        {[=](auto& s) { s.error_target = inf; }, "error target"},
        {[](auto& s) { s.max_depth = -1; }, "maximum depth"},
        {[](auto& s) { s.threads = -1; }, "threads"},
        {[](auto& s) {
             s.integrator = IntegratorKind::Auto;
             s.light_paths_per_pixel = 1;
         },
         "auto integrator"},
        {[](auto& s) {
             s.integrator = IntegratorKind::Auto;
             s.light_paths_per_pixel.reset();
             s.strategies.connection = false;
         },
         "auto integrator"},
        {[](auto& s) {
             s.integrator = IntegratorKind::Auto;
             s.light_paths_per_pixel.reset();
             s.strategy_images = 3;
         },
         "strategy images"},
        {[](auto& s) { s.light_paths_per_pixel = -0.5; }, "light paths"},
        {[=](auto& s) { s.light_paths_per_pixel = nan; }, "light paths"},
        {[=](auto& s) { s.light_paths_per_pixel = inf; }, "light paths"},
        {[](auto& s) { s.light_paths_per_pixel = 1e300; }, "light paths"},
        {[](auto& s) { s.filter.radius = 0; }, "filter radius"},
        {[=](auto& s) { s.filter.radius = nan; }, "filter radius"},
        {[](auto& s) {
             s.integrator = IntegratorKind::Path;
             s.single_strategy = {1, 2};
         },
         "bdpt"},
        {[](auto& s) { s.single_strategy = {-1, 4}; }, "strategy"},
        {[](auto& s) { s.strategy_images = -1; }, "strategy images"},
        {[](auto& s) { s.strategy_images = 1000; }, "strategy images"},
        {[](auto& s) {
             s.integrator = IntegratorKind::Path;
             s.strategy_images = 3;
         },
         "bdpt"},
        {[](auto& s) {
             s.single_strategy = {1, 2};
             s.strategy_images = 3;
         },
         "single"},
        {[](auto& s) { s.single_strategy = {0, 1}; }, "strategy"},
    };
    const RenderSettings good = small_settings(IntegratorKind::Bdpt, 8, 1);
    ASSERT_EQ(error_of<Error>(diffuse_box(), good), "");
    for (const BadSettings& bad : cases) {
        RenderSettings settings = good;
        bad.spoil(settings);
        const std::string message = error_of<SettingsError>(diffuse_box(), settings);
        EXPECT_NE(message.find(bad.complaint), std::string::npos) << bad.complaint << " said: " << message;
    }
}

TEST(Settings, NameTheFileWithoutCamera) {
    SceneDescription scene = diffuse_box();
    scene.cameras.clear();
    scene.source = "box.usda";
    const std::string message = error_of<SceneError>(scene, small_settings(IntegratorKind::Path, 8, 1));
    EXPECT_EQ(message, "box.usda: the scene has no camera");
}

TEST(Settings, MissingTexturesAreFileErrors) {
    SceneDescription scene = diffuse_box();
    TextureDesc texture;
    texture.name = "/Looks/wood";
    texture.file = "no/such/file.png";
    scene.textures.push_back(texture);
    std::get<DiffuseMaterial>(scene.materials[static_cast<std::size_t>(scene.shapes[0].materials[0])].model)
        .reflectance.texture = 0;
    const std::string message = error_of<FileError>(scene, small_settings(IntegratorKind::Path, 8, 1));
    EXPECT_NE(message.find("/Looks/wood"), std::string::npos) << message;
    EXPECT_NE(message.find("no/such/file.png"), std::string::npos) << message;
}

TEST(Settings, EdgesAreAllowed) {
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, 8, 1);
    settings.max_depth = 0;
    settings.light_paths_per_pixel = 0;
    settings.crop = {7, 7, 8, 8};
    settings.aovs = {};
    const RenderedImage image = render(diffuse_box(), settings);
    EXPECT_EQ(image.width, 1);
    EXPECT_TRUE(image.aovs.empty());
}

TEST(Settings, LightPathsAreAsManyAsTheSceneHasUseFor) {
    const auto paths_of = [](const SceneDescription& scene, IntegratorKind integrator) {
        RenderSettings settings = small_settings(integrator, 10, 1);
        settings.light_paths_per_pixel.reset();
        return render(scene, settings).statistics.light_paths;
    };
    EXPECT_EQ(paths_of(diffuse_box(), IntegratorKind::Bdpt), 50U);
    EXPECT_EQ(paths_of(glass_box(), IntegratorKind::Bdpt), 400U);
    EXPECT_EQ(paths_of(diffuse_box(), IntegratorKind::Light), 100U);
    EXPECT_EQ(paths_of(glass_box(), IntegratorKind::Light), 100U);
    EXPECT_EQ(paths_of(glass_box(), IntegratorKind::Path), 0U);
}

}  // namespace
}  // namespace etendue::test
