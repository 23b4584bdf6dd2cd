#include "fuzz/trial.h"

#include <algorithm>
#include <utility>

#include "fuzz/cameras.h"
#include "fuzz/geometries.h"
#include "fuzz/lights.h"
#include "fuzz/materials.h"
#include "fuzz/placements.h"
#include "fuzz/settings.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

TextureDesc random_texture(Dice& dice, const std::string& file) {
    const auto wrap = [&] {
        return dice.one_of({TextureWrap::UseMetadata, TextureWrap::Black, TextureWrap::Clamp, TextureWrap::Repeat,
                            TextureWrap::Mirror});
    };
    TextureDesc texture;
    if (dice.chance(0.99)) texture.file = file;
    texture.color_space = dice.one_of({TextureColorSpace::Auto, TextureColorSpace::Raw, TextureColorSpace::Srgb});
    texture.wrap_s = wrap();
    texture.wrap_t = wrap();
    for (std::size_t i = 0; i < 4; ++i) {
        if (dice.chance(0.1)) texture.scale[i] = dice.number(dice.one_of({0.0, 2.0, -1.0, 1e-20, 1e20}));
        if (dice.chance(0.1)) texture.bias[i] = dice.number(dice.one_of({1.0, -1.0, 1e-20, 1e20}));
        if (dice.chance(0.1)) texture.fallback[i] = dice.fraction();
    }
    for (double& x : texture.st_transform) {
        if (dice.chance(0.1)) x = dice.number(dice.one_of({0.0, 1.0, -3.0, 1e-20, 1e20}));
    }
    return texture;
}

class SceneDice {
public:
    SceneDice(Dice& dice, const std::string& texture_file)
        : dice_(dice), file_(texture_file), world_(random_world(dice)) {}

    SceneDescription scene() {
        add_materials();
        add_groups();
        add_shapes();
        add_lights();
        scene_.cameras.push_back(random_camera(dice_, world_.scale));
        scene_.cameras.back().world_from_camera = placed(scene_.cameras.back().world_from_camera);
        name_all();
        return std::move(scene_);
    }

private:
    [[nodiscard]] Matrix4 placed(const Matrix4& studio_from_object) const {
        return product(world_.world_from_studio, studio_from_object);
    }

    void add_materials() {
        const int textures = dice_.chance(0.3) ? dice_.whole(1, 2) : 0;
        for (int i = 0; i < textures; ++i) scene_.textures.push_back(random_texture(dice_, file_));
        const int materials = dice_.whole(1, 4);
        for (int i = 0; i < materials; ++i) scene_.materials.push_back(random_material(dice_, textures, world_.scale));
    }

    int add_geometry(const GeometryDesc& geometry) {
        scene_.geometries.emplace_back(geometry);
        return static_cast<int>(scene_.geometries.size()) - 1;
    }

    int random_material_index() {
        if (dice_.chance(0.001)) return -1;
        return dice_.below(static_cast<int>(scene_.materials.size()));
    }

    ShapeDesc random_shape() {
        ShapeDesc shape;
        const bool shared = !scene_.geometries.empty() && dice_.chance(0.1);
        shape.geometry =
            shared ? dice_.below(static_cast<int>(scene_.geometries.size())) : add_geometry(random_geometry(dice_));
        if (dice_.chance(0.001)) shape.geometry = 99;
        shape.materials = {random_material_index()};
        shape.parent_from_object = random_placement(dice_);
        return shape;
    }

    void add_groups() {
        if (!dice_.chance(0.25)) return;
        const int groups = dice_.whole(1, 2);
        for (int i = 0; i < groups; ++i) {
            GroupDesc group;
            const int shapes = dice_.whole(dice_.chance(0.05) ? 0 : 1, 3);
            for (int k = 0; k < shapes; ++k) group.shapes.push_back(random_shape());
            scene_.groups.push_back(std::move(group));
        }
        const int instances = dice_.whole(1, 4);
        for (int i = 0; i < instances; ++i) {
            const int group = dice_.chance(0.002) ? 7 : dice_.below(groups);
            scene_.instances.push_back({"", group, placed(random_placement(dice_))});
        }
    }

    void add_shapes() {
        if (dice_.chance(0.4)) add_room();
        const int shapes = dice_.whole(dice_.chance(0.05) ? 0 : 1, 5);
        for (int i = 0; i < shapes; ++i) {
            ShapeDesc shape = random_shape();
            shape.parent_from_object = placed(shape.parent_from_object);
            // Shapes in one place, or one within the other.
            if (!scene_.shapes.empty() && dice_.chance(0.2)) {
                shape.parent_from_object = scene_.shapes.back().parent_from_object;
                if (dice_.chance(0.5)) shape.geometry = scene_.shapes.back().geometry;
                const double size = dice_.one_of({1.0, 0.5, 1 + 1e-6, 1 - 1e-6, 1 + 1e-9});
                shape.parent_from_object = product(shape.parent_from_object, scaling({size, size, size}));
            }
            scene_.shapes.push_back(std::move(shape));
        }
        for (ShapeDesc& shape : scene_.shapes) give_slots(shape);
    }

    /// A second material for a mesh's second face.
    void give_slots(ShapeDesc& shape) {
        if (!dice_.chance(0.1) || shape.geometry >= static_cast<int>(scene_.geometries.size())) return;
        const auto* mesh = std::get_if<MeshDesc>(&*scene_.geometries[static_cast<std::size_t>(shape.geometry)]);
        if (mesh == nullptr || mesh->face_vertex_counts.size() < 2) return;
        MeshDesc slotted = *mesh;
        slotted.face_materials.assign(slotted.face_vertex_counts.size(), 0);
        slotted.face_materials[1] = 1;
        shape.geometry = add_geometry(slotted);
        shape.materials.push_back(random_material_index());
    }

    /// The whole studio lies in a ball or a cube, or on a floor.
    void add_room() {
        ShapeDesc room;
        const double which = dice_.unit();
        const double size = dice_.between(1.0, 6.0);
        if (which < 0.3) {
            room.geometry = add_geometry(SphereDesc{size});
        } else if (which < 0.6) {
            room.geometry = add_geometry(CubeDesc{2 * size});
        } else {
            room.geometry = add_geometry(PlaneDesc{2 * size, 2 * size, Axis::Y});
        }
        room.materials = {random_material_index()};
        room.parent_from_object = world_.world_from_studio;
        scene_.shapes.push_back(std::move(room));
    }

    void add_lights() {
        const int lights = dice_.whole(dice_.chance(0.1) ? 0 : 1, dice_.chance(0.05) ? 40 : 3);
        for (int i = 0; i < lights; ++i) {
            LightDesc light = random_light(dice_, file_);
            light.world_from_light = placed(light.world_from_light);
            scene_.lights.push_back(std::move(light));
        }
        for (int i = 0; i < static_cast<int>(scene_.shapes.size()); ++i) {
            if (dice_.chance(0.04)) scene_.lights.push_back(random_mesh_light(dice_, i));
        }
    }

    void name_all() {
        int number = 0;
        const auto name = [&](auto& prim, const char* kind) {
            prim.name = std::string(kPrimPrefix) + kind + std::to_string(number++);
        };
        for (TextureDesc& x : scene_.textures) name(x, "texture_");
        for (MaterialDesc& x : scene_.materials) name(x, "material_");
        for (ShapeDesc& x : scene_.shapes) name(x, "shape_");
        for (GroupDesc& x : scene_.groups) {
            name(x, "group_");
            for (ShapeDesc& shape : x.shapes) name(shape, "part_");
        }
        for (InstanceDesc& x : scene_.instances) name(x, "instance_");
        for (LightDesc& x : scene_.lights) name(x, "light_");
        for (CameraDesc& x : scene_.cameras) name(x, "camera_");
    }

    Dice& dice_;
    const std::string& file_;
    World world_;
    SceneDescription scene_;
};

/// The inside of a closed glowing body of albedo 1: after depth bounces, radiance depth + 1 everywhere.
Trial furnace(Dice& dice) {
    const World world = random_world(dice);
    SceneBuilder b;
    MeshDesc wall = low_polygon_sphere(dice.whole(4, 12), dice.whole(3, 8), false);
    wall.left_handed = true;
    const int material = b.material(DiffuseMaterial{{{1, 1, 1}}}, {1, 1, 1});
    b.shape(wall, material, world.world_from_studio);
    b.camera(random_point(dice, 0.3), {0, 0, 0.5}, dice.between(20.0, 150.0));
    Trial trial;
    trial.scene = std::move(b.scene());
    CameraDesc& camera = trial.scene.cameras[0];
    camera.world_from_camera = product(world.world_from_studio, camera.world_from_camera);
    trial.settings = random_settings(dice);
    trial.settings.integrator = dice.one_of({IntegratorKind::Path, IntegratorKind::Bdpt});
    trial.settings.strategies = {true, false, false, false, false};
    trial.settings.single_strategy.reset();
    trial.settings.strategy_images = 0;
    trial.settings.light_paths_per_pixel.reset();
    trial.settings.max_depth = dice.whole(0, 30);
    trial.settings.roulette_depth = -1;
    trial.settings.aovs = {Aov::Color, Aov::Alpha};
    trial.radiance = trial.settings.max_depth + 1;
    return trial;
}

}  // namespace

Trial random_trial(Dice& dice, const std::string& texture_file) {
    if (dice.chance(0.02)) return furnace(dice);
    Trial trial;
    if (dice.chance(0.1)) dice.turn_hostile();
    trial.settings = random_settings(dice);
    trial.scene = SceneDice(dice, texture_file).scene();
    trial.hostile = dice.hostile();
    return trial;
}

void edit(Dice& dice, SceneDescription& scene) {
    if (!scene.materials.empty() && dice.chance(0.4)) scene.materials[0].model = DiffuseMaterial{};
    if (!scene.shapes.empty() && dice.chance(0.4)) {
        Matrix4& placement = scene.shapes.back().parent_from_object;
        placement = product(placement, scaling({0.5, 0.5, 0.5}));
    }
    if (!scene.instances.empty() && dice.chance(0.5)) scene.instances.pop_back();
    const bool mesh_light = !scene.lights.empty() && scene.lights.back().kind == LightKind::Mesh;
    if (!scene.shapes.empty() && !mesh_light && dice.chance(0.2)) scene.shapes.pop_back();
    if (!scene.lights.empty() && dice.chance(0.3)) scene.lights.pop_back();
    if (!scene.textures.empty() && dice.chance(0.3)) scene.textures[0].scale[0] = 0.5;
}

}  // namespace etendue::test
