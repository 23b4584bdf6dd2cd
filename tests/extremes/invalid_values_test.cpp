// NaN, infinities and numbers out of range where one is authored: an error that names the prim, or a picture without an
// invalid sample.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <etendue/error.h>

#include "core/io/temporary_directory.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "support/hdr_file.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// A place for a number, in a scene in which it counts.
struct Place {
    std::string name;
    std::string prim;  ///< what an error must name
    std::function<void(SceneDescription&, double)> set;
    SceneDescription scene;
};

/// Box, lamp and camera, with names of their own.
SceneBuilder plain_room() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    b.rect_light({0, 0.9, 0}, {0, -1, 0}, 0.5, 0.5, 4);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b;
}

void add(std::vector<Place>& places, const std::string& name, const std::string& prim, const SceneDescription& scene,
         std::function<void(SceneDescription&, double)> set) {
    places.push_back({name, prim, std::move(set), scene});
}

void add_camera_places(std::vector<Place>& places) {
    SceneBuilder b = plain_room();
    b.lens(0.1, 3);
    SceneDescription orthographic = b.scene();
    orthographic.cameras[0].projection = CameraProjection::Orthographic;
    const auto camera = [&](const char* name, double CameraDesc::* member) {
        for (const SceneDescription& scene : {b.scene(), orthographic}) {
            add(places, std::string("camera ") + name, "/camera_0", scene,
                [member](SceneDescription& s, double x) { s.cameras[0].*member = x; });
        }
    };
    camera("horizontal aperture", &CameraDesc::horizontal_aperture);
    camera("vertical aperture", &CameraDesc::vertical_aperture);
    camera("horizontal offset", &CameraDesc::horizontal_aperture_offset);
    camera("vertical offset", &CameraDesc::vertical_aperture_offset);
    camera("focal length", &CameraDesc::focal_length);
    camera("f-stop", &CameraDesc::f_stop);
    camera("focus distance", &CameraDesc::focus_distance);
    camera("exposure scale", &CameraDesc::exposure_scale);
    for (std::size_t i = 0; i < 16; ++i) {
        add(places, "camera matrix", "/camera_0", b.scene(),
            [i](SceneDescription& s, double x) { s.cameras[0].world_from_camera.m[i] = x; });
    }
}

void add_light_places(std::vector<Place>& places) {
    for (const LightKind kind : {LightKind::Rect, LightKind::Disk, LightKind::Sphere, LightKind::Cylinder,
                                 LightKind::Distant, LightKind::Dome, LightKind::Mesh}) {
        SceneBuilder b = plain_room();
        LightDesc desc;
        desc.name = "/lamp";
        desc.kind = kind;
        desc.shaping = ShapingDesc{};
        if (kind == LightKind::Mesh) desc.shape = b.quad({-0.5, 0, 0}, {0, 0, 1}, {1, 0, 0}, b.diffuse(0.5));
        b.light(desc);
        const std::string of = "light kind " + std::to_string(static_cast<int>(kind)) + " ";
        const auto lamp = [&](const char* name, double LightDesc::* member) {
            add(places, of + name, "/lamp", b.scene(),
                [member](SceneDescription& s, double x) { s.lights[1].*member = x; });
        };
        lamp("intensity", &LightDesc::intensity);
        lamp("exposure", &LightDesc::exposure);
        lamp("width", &LightDesc::width);
        lamp("height", &LightDesc::height);
        lamp("length", &LightDesc::length);
        lamp("radius", &LightDesc::radius);
        lamp("angle", &LightDesc::angle);
        const auto other = [&](const char* name, auto set) { add(places, of + name, "/lamp", b.scene(), set); };
        other("color", [](SceneDescription& s, double x) { s.lights[1].color[1] = x; });
        other("temperature", [](SceneDescription& s, double x) { s.lights[1].color_temperature_rgb[2] = x; });
        other("focus", [](SceneDescription& s, double x) { s.lights[1].shaping->focus = x; });
        other("focus tint", [](SceneDescription& s, double x) {
            s.lights[1].shaping->focus = 2;
            s.lights[1].shaping->focus_tint[0] = x;
        });
        other("cone angle", [](SceneDescription& s, double x) { s.lights[1].shaping->cone_angle = x; });
        other("cone softness", [](SceneDescription& s, double x) { s.lights[1].shaping->cone_softness = x; });
        for (std::size_t i = 0; i < 16; ++i) {
            other("matrix", [i](SceneDescription& s, double x) { s.lights[1].world_from_light.m[i] = x; });
        }
    }
}

/// The first material is that of the box.
template <typename Model>
class Models {
public:
    explicit Models(std::vector<Place>& places, const char* model) : places_(places), model_(model) {
        room.scene().materials[0].model = Model{};
    }
    void number(const char* name, double Model::* member) {
        set(name, [member](Model& m, double x) { m.*member = x; });
    }
    void number(const char* name, FloatInput Model::* member) {
        set(name, [member](Model& m, double x) { (m.*member).value = x; });
    }
    void color(const char* name, ColorInput Model::* member) {
        set(name, [member](Model& m, double x) { (m.*member).value[1] = x; });
    }

    SceneBuilder room = plain_room();

private:
    template <typename Set>
    void set(const char* name, Set set) {
        add(places_, std::string(model_) + ' ' + name, "/material_0", room.scene(),
            [set](SceneDescription& s, double x) { set(std::get<Model>(s.materials[0].model), x); });
    }

    std::vector<Place>& places_;
    const char* model_;
};

void add_simple_material_places(std::vector<Place>& places) {
    Models<DiffuseMaterial> diffuse(places, "diffuse");
    diffuse.color("reflectance", &DiffuseMaterial::reflectance);
    diffuse.number("roughness", &DiffuseMaterial::roughness);
    Models<ConductorMaterial> metal(places, "metal");
    metal.color("reflectance", &ConductorMaterial::reflectance);
    metal.number("roughness", &ConductorMaterial::roughness);
    Models<PhongMaterial> phong(places, "phong");
    phong.color("reflectance", &PhongMaterial::reflectance);
    phong.number("exponent", &PhongMaterial::exponent);
    for (const bool thin : {false, true}) {
        Models<DielectricMaterial> glass(places, "glass");
        auto& model = std::get<DielectricMaterial>(glass.room.scene().materials[0].model);
        model.thin_walled = thin;
        model.transmission_tint.value = {0.5, 0.6, 0.7};
        glass.number("ior", &DielectricMaterial::ior);
        glass.number("roughness", &DielectricMaterial::roughness);
        glass.color("reflection tint", &DielectricMaterial::reflection_tint);
        glass.color("transmission tint", &DielectricMaterial::transmission_tint);
        glass.number("transmission depth", &DielectricMaterial::transmission_depth);
        model.transmission_depth = 1;
        glass.color("transmission tint at a depth", &DielectricMaterial::transmission_tint);
    }
}

void add_layered_material_places(std::vector<Place>& places) {
    using Preview = PreviewSurfaceMaterial;
    Models<Preview> preview(places, "preview");
    auto& model = std::get<Preview>(preview.room.scene().materials[0].model);
    model.clearcoat.value = 0.5;
    model.opacity.value = 0.7;
    preview.color("diffuse color", &Preview::diffuse_color);
    preview.number("metallic", &Preview::metallic);
    preview.number("roughness", &Preview::roughness);
    preview.number("clearcoat", &Preview::clearcoat);
    preview.number("clearcoat roughness", &Preview::clearcoat_roughness);
    preview.number("opacity", &Preview::opacity);
    preview.number("opacity threshold", &Preview::opacity_threshold);
    preview.number("ior", &Preview::ior);
    model.use_specular_workflow = true;
    preview.color("specular color", &Preview::specular_color);

    using Pbr = OpenPbrMaterial;
    Models<Pbr> pbr(places, "OpenPBR");
    auto& all = std::get<Pbr>(pbr.room.scene().materials[0].model);
    all.coat_weight.value = all.transmission_weight.value = all.base_metalness.value = 0.5;
    all.transmission_color.value = {0.5, 0.6, 0.7};
    pbr.number("base weight", &Pbr::base_weight);
    pbr.color("base color", &Pbr::base_color);
    pbr.number("diffuse roughness", &Pbr::base_diffuse_roughness);
    pbr.number("metalness", &Pbr::base_metalness);
    pbr.number("specular weight", &Pbr::specular_weight);
    pbr.color("specular color", &Pbr::specular_color);
    pbr.number("specular roughness", &Pbr::specular_roughness);
    pbr.number("specular ior", &Pbr::specular_ior);
    pbr.number("transmission weight", &Pbr::transmission_weight);
    pbr.color("transmission color", &Pbr::transmission_color);
    pbr.number("transmission depth", &Pbr::transmission_depth);
    pbr.number("coat weight", &Pbr::coat_weight);
    pbr.number("coat roughness", &Pbr::coat_roughness);
    pbr.number("coat ior", &Pbr::coat_ior);
    pbr.number("coat darkening", &Pbr::coat_darkening);
    pbr.number("opacity", &Pbr::geometry_opacity);
}

void add_emission_places(std::vector<Place>& places) {
    SceneBuilder b = plain_room();
    b.quad({-0.5, 0, 0}, {0, 0, 1}, {1, 0, 0}, b.material(DiffuseMaterial{}, {1, 1, 1}));
    add(places, "emission", "/material_1", b.scene(),
        [](SceneDescription& s, double x) { s.materials[1].emission.value[1] = x; });
}

void add_texture_places(std::vector<Place>& places) {
    static const TemporaryDirectory directory;
    const std::string file = directory.file("grey.hdr");
    write_hdr(file, 4, 4, [](int, int) { return Rgb(0.5, 0.5, 1); });
    SceneBuilder b = plain_room();
    TextureDesc texture;
    texture.name = "/texture";
    texture.file = file;
    b.scene().textures = {texture};
    b.scene().materials[0].model = DiffuseMaterial{{{}, 0}};
    SceneDescription bumpy = plain_room().scene();
    bumpy.textures = {texture};
    bumpy.materials[0].normal_texture = 0;
    SceneDescription glowing = plain_room().scene();
    glowing.textures = {texture};
    glowing.materials[0].emission = {{1, 1, 1}, 0};
    for (const SceneDescription& scene : {b.scene(), bumpy, glowing}) {
        for (std::size_t i = 0; i < 4; ++i) {
            add(places, "texture scale", "/texture", scene,
                [i](SceneDescription& s, double x) { s.textures[0].scale[i] = x; });
            add(places, "texture bias", "/texture", scene,
                [i](SceneDescription& s, double x) { s.textures[0].bias[i] = x; });
            add(places, "texture fallback", "/texture", scene, [i](SceneDescription& s, double x) {
                s.textures[0].fallback[i] = x;
                s.textures[0].file.clear();
            });
        }
        for (std::size_t i = 0; i < 6; ++i) {
            add(places, "texture transform", "/texture", scene,
                [i](SceneDescription& s, double x) { s.textures[0].st_transform[i] = x; });
        }
    }
}

void add_shape_places(std::vector<Place>& places) {
    SceneBuilder b = plain_room();
    const int grey = b.diffuse(0.5);
    MeshDesc mesh = low_polygon_sphere(6, 4, true);
    mesh.st.assign(mesh.points.size(), {0.5F, 0.5F});
    const int shape = b.shape(mesh, grey);
    b.scene().groups = {{"/group", {{"/group/shape", shape, {grey}, {}}}}};
    b.scene().instances = {{"/instance", 0, translation({0.5, 0, 0})}};
    const auto index = static_cast<std::size_t>(shape);
    const std::string prim = b.scene().shapes[index].name;
    const auto mesh_place = [&](const char* name, auto set) {
        add(places, std::string("mesh ") + name, prim, b.scene(), [index, set](SceneDescription& s, double x) {
            MeshDesc changed = std::get<MeshDesc>(*s.geometries[index]);
            set(changed, static_cast<float>(x));
            s.geometries[index] = changed;
        });
    };
    mesh_place("points", [](MeshDesc& m, float x) { m.points[3][1] = x; });
    mesh_place("normals", [](MeshDesc& m, float x) { m.normals[3][1] = x; });
    mesh_place("st", [](MeshDesc& m, float x) { m.st[3][1] = x; });
    for (std::size_t i = 0; i < 16; ++i) {
        add(places, "shape matrix", prim, b.scene(),
            [index, i](SceneDescription& s, double x) { s.shapes[index].parent_from_object.m[i] = x; });
        add(places, "instance matrix", "/instance", b.scene(),
            [i](SceneDescription& s, double x) { s.instances[0].world_from_group.m[i] = x; });
        add(places, "matrix in a group", "/group/shape", b.scene(),
            [i](SceneDescription& s, double x) { s.groups[0].shapes[0].parent_from_object.m[i] = x; });
    }
    const auto body = [&](const char* name, auto make) {
        add(places, name, prim, b.scene(),
            [index, make](SceneDescription& s, double x) { s.geometries[index] = make(x); });
    };
    body("sphere radius", [](double x) { return SphereDesc{x}; });
    body("cube size", [](double x) { return CubeDesc{x}; });
    body("cylinder radius", [](double x) { return CylinderDesc{x, 1}; });
    body("cylinder height", [](double x) { return CylinderDesc{1, x}; });
    body("cone radius", [](double x) { return ConeDesc{x, 1}; });
    body("cone height", [](double x) { return ConeDesc{1, x}; });
    body("capsule radius", [](double x) { return CapsuleDesc{x, 1}; });
    body("capsule height", [](double x) { return CapsuleDesc{1, x}; });
    body("plane width", [](double x) { return PlaneDesc{x, 1}; });
    body("plane length", [](double x) { return PlaneDesc{1, x}; });
}

enum class Outcome { Refused, Rendered, Wrong };

/// `complaint` says what was wrong.
Outcome try_value(const Place& place, double value, std::string& complaint) {
    SceneDescription scene = place.scene;
    place.set(scene, value);
    try {
        for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
            RenderSettings settings = quick_settings(integrator);
            settings.width = settings.height = 6;
            settings.max_depth = 6;
            const Picture seen = picture(scene, settings);
            if (seen.invalid == 0) continue;
            complaint = std::to_string(seen.invalid) + " invalid samples";
            return Outcome::Wrong;
        }
        return Outcome::Rendered;
    } catch (const Error& error) {
        complaint = error.what();
        return complaint.find(place.prim) == std::string::npos ? Outcome::Wrong : Outcome::Refused;
    }
}

void expect_sense(const std::string& what, const std::vector<double>& values, void (*add_places)(std::vector<Place>&)) {
    std::vector<Place> places;
    add_places(places);
    int refused = 0;
    int rendered = 0;
    int wrong = 0;
    for (const Place& place : places) {
        for (const double value : values) {
            std::string complaint;
            const Outcome outcome = try_value(place, value, complaint);
            refused += outcome == Outcome::Refused ? 1 : 0;
            rendered += outcome == Outcome::Rendered ? 1 : 0;
            wrong += outcome == Outcome::Wrong ? 1 : 0;
            EXPECT_NE(outcome, Outcome::Wrong) << place.name << " = " << value << ": " << complaint;
        }
    }
    EXPECT_TRUE(
        at_most({"authored values",
                 what + ": " + std::to_string(refused) + " refused, " + std::to_string(rendered) + " have a meaning",
                 "neither: places where samples are invalid, or the error names no prim"},
                wrong, 0));
}

/// What is no number, and numbers of which Embree, or double once squared, knows nothing.
const std::vector<double> kNoNumbers{kNan, kInf, -kInf};
const std::vector<double> kOutOfRange{1e19, -1e19, 1e30, 1e300, -1e300, 1e-30, 1e-300};

struct Kind {
    const char* what;
    void (*add_places)(std::vector<Place>&);
};

TEST(InvalidValues, HaveAMeaningOrAreRefused) {
    for (const auto& [what, add_places] :
         {Kind{"cameras", add_camera_places}, Kind{"lights", add_light_places},
          Kind{"simple materials", add_simple_material_places}, Kind{"layered materials", add_layered_material_places},
          Kind{"emission", add_emission_places}, Kind{"textures", add_texture_places},
          Kind{"shapes", add_shape_places}}) {
        expect_sense(std::string("NaN and infinities in ") + what, kNoNumbers, add_places);
        expect_sense(std::string("1e19, 1e30, 1e300, 1e-30 and 1e-300 in ") + what, kOutOfRange, add_places);
    }
}

}  // namespace
}  // namespace etendue::test
