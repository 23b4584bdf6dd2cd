/// Renders a plain diffuse scene by path tracing, in one thread, and prints what it took as JSON.

#include <fstream>
#include <iostream>
#include <string>

#include <etendue/render_session.h>

#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// A box with a lamp and a faceted ball in it.
SceneDescription plain_scene() {
    SceneBuilder b;
    const int white = b.diffuse(0.7);
    b.open_box(white);
    b.shape(low_polygon_sphere(256, 128, false), b.diffuse(0.4));
    for (std::size_t diagonal : {0, 5, 10}) b.scene().shapes.back().parent_from_object.m.at(diagonal) = 0.5;
    b.rect_light({0, 0.95, 0}, {0, -1, 0}, 0.5, 0.5, 10);
    b.camera({0, 0, 4}, {0, 0, 0}, 40);
    return b.scene();
}

RenderSettings plain_settings(int samples) {
    RenderSettings settings;
    settings.integrator = IntegratorKind::Path;
    settings.width = settings.height = 64;
    settings.samples_per_pixel = samples;
    settings.max_depth = 8;
    settings.threads = 1;
    return settings;
}

/// KiB. (getrusage's figure may be that of whoever started the process.)
long peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        long kib = 0;
        if (word == "VmHWM:" && status >> kib) return kib;
    }
    return 0;
}

void run(int samples) {
    const long libraries = peak_memory();
    RenderSession session(plain_scene(), plain_settings(samples));
    session.start();
    session.wait();
    const RenderedImage image = session.snapshot();
    double sum = 0;
    for (float value : image.find(Aov::Color)->data) sum += double{value};
    std::cout << "{\"paths\": " << image.statistics.camera_paths << ", \"rays\": " << image.statistics.rays
              << ", \"sum\": " << sum << ", \"libraries\": " << libraries << ", \"peak\": " << peak_memory() << "}\n";
}

}  // namespace
}  // namespace etendue::test

int main(int argc, char** argv) { etendue::test::run(argc > 1 ? std::stoi(argv[1]) : 4); }
