// Renders through the installed façade alone, two pictures whose values are known beforehand.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <etendue/error.h>
#include <etendue/render_session.h>
#include <etendue/version.h>

namespace {

constexpr double kRadiance = 0.75;
constexpr double kReflectance = 0.4;

void expect(bool holds, std::string_view claim) {
    if (!holds) {
        std::fprintf(stderr, "stranger: not so: %.*s\n", static_cast<int>(claim.size()), claim.data());
        std::exit(EXIT_FAILURE);
    }
}

etendue::LightDesc dome() {
    etendue::LightDesc light;
    light.name = "/sky";
    light.kind = etendue::LightKind::Dome;
    light.intensity = kRadiance;
    return light;
}

/// At the origin, looking down -Z.
etendue::CameraDesc camera() {
    etendue::CameraDesc desc;
    desc.name = "/camera";
    return desc;
}

/// A diffuse plane behind the camera's window, facing the camera and larger than its view.
void add_wall(etendue::SceneDescription& scene) {
    etendue::MaterialDesc material;
    material.name = "/grey";
    material.model = etendue::DiffuseMaterial{{{kReflectance, kReflectance, kReflectance}}};
    scene.materials.push_back(material);
    scene.geometries.emplace_back(etendue::PlaneDesc{.width = 20, .length = 20});
    etendue::ShapeDesc wall;
    wall.name = "/wall";
    wall.geometry = 0;
    wall.materials = {0};
    wall.parent_from_object.m[11] = -5;
    scene.shapes.push_back(wall);
}

/// Mean of the colour's three channels over the film.
double mean_color(const etendue::SceneDescription& scene, int samples) {
    etendue::RenderSettings settings;
    settings.integrator = etendue::IntegratorKind::Path;
    settings.width = 16;
    settings.height = 12;
    settings.samples_per_pixel = samples;
    settings.max_depth = 3;
    etendue::RenderSession session(scene, settings);
    session.start();
    session.wait();
    const etendue::RenderedImage image = session.snapshot();
    const etendue::AovImage* color = image.find(etendue::Aov::Color);
    expect(color != nullptr, "the film has the colour that was asked for");
    expect(color->data.size() == 16U * 12U * 3U, "the film has as many values as pixels and channels");
    double sum = 0;
    for (const float value : color->data) sum += value;
    return sum / static_cast<double>(color->data.size());
}

}  // namespace

int main() {
    etendue::SceneDescription scene;
    scene.lights.push_back(dome());
    scene.cameras.push_back(camera());
    const double sky = mean_color(scene, 1);
    expect(std::abs(sky - kRadiance) < 1e-6, "a uniform dome seen directly shows its radiance");

    // A plane sees half of the dome, and each direction brings the same: E = pi L, so it shows its reflectance times L.
    add_wall(scene);
    const double wall = mean_color(scene, 64);
    expect(std::abs(wall - kReflectance * kRadiance) < 0.02 * kReflectance * kRadiance,
           "a diffuse plane under a uniform dome shows its reflectance times the radiance");

    scene.cameras.clear();
    try {
        mean_color(scene, 1);
        expect(false, "a scene without a camera is refused");
    } catch (const etendue::Error& error) {
        expect(std::string_view(error.what()).size() > 0, "the refusal says why");
    }

    std::printf("Etendue %s: sky %.6f, wall %.6f\n", ETENDUE_VERSION, sky, wall);
    return EXIT_SUCCESS;
}
