#include <etendue/scene_description.h>

#include <utility>

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {
namespace {

Matrix4 matrix_from_array(const DoubleArray& array) {
    if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4) {
        throw py::value_error("expected a matrix of shape (4, 4)");
    }
    Matrix4 matrix;
    std::copy_n(array.data(), matrix.m.size(), matrix.m.begin());
    return matrix;
}

/// A (4, 4) property that copies on reading and on writing.
template <typename Struct, typename Class>
void def_matrix(Class& cls, const char* name, Matrix4 Struct::* member) {
    cls.def_property(
        name,
        [member](const Struct& self) {
            py::array_t<double> array({4, 4});
            std::copy_n((self.*member).m.begin(), 16, array.mutable_data());
            return array;
        },
        [member](Struct& self, const DoubleArray& array) { self.*member = matrix_from_array(array); });
}

template <std::size_t N>
void def_tuples(py::class_<MeshDesc>& cls, const char* name, std::vector<std::array<float, N>> MeshDesc::* member) {
    cls.def_property(
        name, [member](const MeshDesc& self) { return array_from_tuples(self.*member); },
        [member](MeshDesc& self, const FloatArray& array) { self.*member = tuples_from_array<N>(array); });
}

void def_indices(py::class_<MeshDesc>& cls, const char* name, std::vector<std::int32_t> MeshDesc::* member) {
    cls.def_property(
        name, [member](const MeshDesc& self) { return array_from_indices(self.*member); },
        [member](MeshDesc& self, const py::array& array) { self.*member = indices_from_array(array); });
}

void bind_textures(py::module_& module) {
    py::enum_<TextureWrap>(module, "TextureWrap")
        .value("UseMetadata", TextureWrap::UseMetadata)
        .value("Black", TextureWrap::Black)
        .value("Clamp", TextureWrap::Clamp)
        .value("Repeat", TextureWrap::Repeat)
        .value("Mirror", TextureWrap::Mirror);
    py::enum_<TextureColorSpace>(module, "TextureColorSpace")
        .value("Auto", TextureColorSpace::Auto)
        .value("Raw", TextureColorSpace::Raw)
        .value("Srgb", TextureColorSpace::Srgb);

    py::class_<TextureDesc> texture(module, "TextureDesc");
    texture.def_readwrite("name", &TextureDesc::name)
        .def_readwrite("file", &TextureDesc::file)
        .def_readwrite("color_space", &TextureDesc::color_space)
        .def_readwrite("wrap_s", &TextureDesc::wrap_s)
        .def_readwrite("wrap_t", &TextureDesc::wrap_t)
        .def_readwrite("scale", &TextureDesc::scale)
        .def_readwrite("bias", &TextureDesc::bias)
        .def_readwrite("fallback", &TextureDesc::fallback)
        .def_readwrite("st_transform", &TextureDesc::st_transform);
    def_keyword_constructor<TextureDesc>(texture);

    py::class_<ColorInput> color(module, "ColorInput");
    color.def_readwrite("value", &ColorInput::value).def_readwrite("texture", &ColorInput::texture);
    def_keyword_constructor<ColorInput>(color);

    py::class_<FloatInput> number(module, "FloatInput");
    number.def_readwrite("value", &FloatInput::value)
        .def_readwrite("texture", &FloatInput::texture)
        .def_readwrite("channel", &FloatInput::channel);
    def_keyword_constructor<FloatInput>(number);
}

void bind_materials(py::module_& module) {
    py::class_<DiffuseMaterial> diffuse(module, "DiffuseMaterial");
    diffuse.def_readwrite("reflectance", &DiffuseMaterial::reflectance)
        .def_readwrite("roughness", &DiffuseMaterial::roughness);
    def_keyword_constructor<DiffuseMaterial>(diffuse);

    py::class_<ConductorMaterial> conductor(module, "ConductorMaterial");
    conductor.def_readwrite("reflectance", &ConductorMaterial::reflectance)
        .def_readwrite("roughness", &ConductorMaterial::roughness);
    def_keyword_constructor<ConductorMaterial>(conductor);

    py::class_<DielectricMaterial> dielectric(module, "DielectricMaterial");
    dielectric.def_readwrite("ior", &DielectricMaterial::ior)
        .def_readwrite("roughness", &DielectricMaterial::roughness)
        .def_readwrite("reflection_tint", &DielectricMaterial::reflection_tint)
        .def_readwrite("thin_walled", &DielectricMaterial::thin_walled)
        .def_readwrite("transmission_tint", &DielectricMaterial::transmission_tint)
        .def_readwrite("transmission_depth", &DielectricMaterial::transmission_depth);
    def_keyword_constructor<DielectricMaterial>(dielectric);

    py::enum_<PreviewOpacityMode>(module, "PreviewOpacityMode")
        .value("Transparent", PreviewOpacityMode::Transparent)
        .value("Presence", PreviewOpacityMode::Presence);
    py::class_<PreviewSurfaceMaterial> preview(module, "PreviewSurfaceMaterial");
    preview.def_readwrite("diffuse_color", &PreviewSurfaceMaterial::diffuse_color)
        .def_readwrite("use_specular_workflow", &PreviewSurfaceMaterial::use_specular_workflow)
        .def_readwrite("specular_color", &PreviewSurfaceMaterial::specular_color)
        .def_readwrite("metallic", &PreviewSurfaceMaterial::metallic)
        .def_readwrite("roughness", &PreviewSurfaceMaterial::roughness)
        .def_readwrite("clearcoat", &PreviewSurfaceMaterial::clearcoat)
        .def_readwrite("clearcoat_roughness", &PreviewSurfaceMaterial::clearcoat_roughness)
        .def_readwrite("opacity", &PreviewSurfaceMaterial::opacity)
        .def_readwrite("opacity_mode", &PreviewSurfaceMaterial::opacity_mode)
        .def_readwrite("opacity_threshold", &PreviewSurfaceMaterial::opacity_threshold)
        .def_readwrite("ior", &PreviewSurfaceMaterial::ior);
    def_keyword_constructor<PreviewSurfaceMaterial>(preview);

    py::class_<OpenPbrMaterial> open_pbr(module, "OpenPbrMaterial");
    open_pbr.def_readwrite("base_weight", &OpenPbrMaterial::base_weight)
        .def_readwrite("base_color", &OpenPbrMaterial::base_color)
        .def_readwrite("base_diffuse_roughness", &OpenPbrMaterial::base_diffuse_roughness)
        .def_readwrite("base_metalness", &OpenPbrMaterial::base_metalness)
        .def_readwrite("specular_weight", &OpenPbrMaterial::specular_weight)
        .def_readwrite("specular_color", &OpenPbrMaterial::specular_color)
        .def_readwrite("specular_roughness", &OpenPbrMaterial::specular_roughness)
        .def_readwrite("specular_ior", &OpenPbrMaterial::specular_ior)
        .def_readwrite("transmission_weight", &OpenPbrMaterial::transmission_weight)
        .def_readwrite("transmission_color", &OpenPbrMaterial::transmission_color)
        .def_readwrite("transmission_depth", &OpenPbrMaterial::transmission_depth)
        .def_readwrite("coat_weight", &OpenPbrMaterial::coat_weight)
        .def_readwrite("coat_roughness", &OpenPbrMaterial::coat_roughness)
        .def_readwrite("coat_ior", &OpenPbrMaterial::coat_ior)
        .def_readwrite("coat_darkening", &OpenPbrMaterial::coat_darkening)
        .def_readwrite("geometry_opacity", &OpenPbrMaterial::geometry_opacity)
        .def_readwrite("geometry_thin_walled", &OpenPbrMaterial::geometry_thin_walled);
    def_keyword_constructor<OpenPbrMaterial>(open_pbr);

    py::enum_<PhongForm>(module, "PhongForm")
        .value("Modified", PhongForm::Modified)
        .value("Classic", PhongForm::Classic);
    py::class_<PhongMaterial> phong(module, "PhongMaterial");
    phong.def_readwrite("reflectance", &PhongMaterial::reflectance)
        .def_readwrite("exponent", &PhongMaterial::exponent)
        .def_readwrite("form", &PhongMaterial::form);
    def_keyword_constructor<PhongMaterial>(phong);
    module.attr("MaterialModel") = diffuse | conductor | dielectric | preview | open_pbr | phong;

    py::class_<MaterialDesc> material(module, "MaterialDesc");
    material.def_readwrite("name", &MaterialDesc::name)
        .def_readwrite("model", &MaterialDesc::model)
        .def_readwrite("emission", &MaterialDesc::emission)
        .def_readwrite("normal_texture", &MaterialDesc::normal_texture);
    def_keyword_constructor<MaterialDesc>(material);
}

void bind_mesh(py::module_& module) {
    py::enum_<Interpolation>(module, "Interpolation")
        .value("Constant", Interpolation::Constant)
        .value("Uniform", Interpolation::Uniform)
        .value("Vertex", Interpolation::Vertex)
        .value("FaceVarying", Interpolation::FaceVarying);

    py::class_<MeshDesc> mesh(module, "MeshDesc");
    def_tuples(mesh, "points", &MeshDesc::points);
    def_indices(mesh, "face_vertex_counts", &MeshDesc::face_vertex_counts);
    def_indices(mesh, "face_vertex_indices", &MeshDesc::face_vertex_indices);
    def_tuples(mesh, "normals", &MeshDesc::normals);
    mesh.def_readwrite("normals_interpolation", &MeshDesc::normals_interpolation);
    def_tuples(mesh, "st", &MeshDesc::st);
    mesh.def_readwrite("st_interpolation", &MeshDesc::st_interpolation);
    def_indices(mesh, "face_materials", &MeshDesc::face_materials);
    mesh.def_readwrite("left_handed", &MeshDesc::left_handed);
    def_keyword_constructor<MeshDesc>(mesh);
}

template <typename Solid>
void bind_axial_solid(py::module_& module, const char* name) {
    py::class_<Solid> solid(module, name);
    solid.def_readwrite("radius", &Solid::radius)
        .def_readwrite("height", &Solid::height)
        .def_readwrite("axis", &Solid::axis);
    def_keyword_constructor<Solid>(solid);
}

void bind_implicits(py::module_& module) {
    py::enum_<Axis>(module, "Axis").value("X", Axis::X).value("Y", Axis::Y).value("Z", Axis::Z);

    py::class_<SphereDesc> sphere(module, "SphereDesc");
    sphere.def_readwrite("radius", &SphereDesc::radius);
    def_keyword_constructor<SphereDesc>(sphere);

    py::class_<CubeDesc> cube(module, "CubeDesc");
    cube.def_readwrite("size", &CubeDesc::size);
    def_keyword_constructor<CubeDesc>(cube);

    bind_axial_solid<CylinderDesc>(module, "CylinderDesc");
    bind_axial_solid<ConeDesc>(module, "ConeDesc");
    bind_axial_solid<CapsuleDesc>(module, "CapsuleDesc");

    py::class_<PlaneDesc> plane(module, "PlaneDesc");
    plane.def_readwrite("width", &PlaneDesc::width)
        .def_readwrite("length", &PlaneDesc::length)
        .def_readwrite("axis", &PlaneDesc::axis);
    def_keyword_constructor<PlaneDesc>(plane);
    const py::object mesh = module.attr("MeshDesc");
    const py::object cylinder = module.attr("CylinderDesc");
    const py::object cone = module.attr("ConeDesc");
    const py::object capsule = module.attr("CapsuleDesc");
    module.attr("GeometryDesc") = mesh | sphere | cube | cylinder | cone | capsule | plane;
}

void bind_shapes(py::module_& module) {
    py::class_<ShapeDesc> shape(module, "ShapeDesc");
    shape.def_readwrite("name", &ShapeDesc::name)
        .def_readwrite("geometry", &ShapeDesc::geometry)
        .def_readwrite("materials", &ShapeDesc::materials);
    def_matrix(shape, "parent_from_object", &ShapeDesc::parent_from_object);
    def_keyword_constructor<ShapeDesc>(shape);

    py::class_<GroupDesc> group(module, "GroupDesc");
    group.def_readwrite("name", &GroupDesc::name).def_readwrite("shapes", &GroupDesc::shapes);
    def_keyword_constructor<GroupDesc>(group);

    py::class_<InstanceDesc> instance(module, "InstanceDesc");
    instance.def_readwrite("name", &InstanceDesc::name).def_readwrite("group", &InstanceDesc::group);
    def_matrix(instance, "world_from_group", &InstanceDesc::world_from_group);
    def_keyword_constructor<InstanceDesc>(instance);
}

void bind_lights(py::module_& module) {
    py::enum_<LightKind>(module, "LightKind")
        .value("Rect", LightKind::Rect)
        .value("Disk", LightKind::Disk)
        .value("Sphere", LightKind::Sphere)
        .value("Cylinder", LightKind::Cylinder)
        .value("Distant", LightKind::Distant)
        .value("Dome", LightKind::Dome)
        .value("Mesh", LightKind::Mesh);

    py::class_<ShapingDesc> shaping(module, "ShapingDesc");
    shaping.def_readwrite("focus", &ShapingDesc::focus)
        .def_readwrite("focus_tint", &ShapingDesc::focus_tint)
        .def_readwrite("cone_angle", &ShapingDesc::cone_angle)
        .def_readwrite("cone_softness", &ShapingDesc::cone_softness);
    def_keyword_constructor<ShapingDesc>(shaping);

    py::class_<LightDesc> light(module, "LightDesc");
    light.def_readwrite("name", &LightDesc::name).def_readwrite("kind", &LightDesc::kind);
    def_matrix(light, "world_from_light", &LightDesc::world_from_light);
    light.def_readwrite("intensity", &LightDesc::intensity)
        .def_readwrite("exposure", &LightDesc::exposure)
        .def_readwrite("color", &LightDesc::color)
        .def_readwrite("color_temperature_rgb", &LightDesc::color_temperature_rgb)
        .def_readwrite("normalize", &LightDesc::normalize)
        .def_readwrite("width", &LightDesc::width)
        .def_readwrite("height", &LightDesc::height)
        .def_readwrite("length", &LightDesc::length)
        .def_readwrite("radius", &LightDesc::radius)
        .def_readwrite("treat_as_point", &LightDesc::treat_as_point)
        .def_readwrite("treat_as_line", &LightDesc::treat_as_line)
        .def_readwrite("angle", &LightDesc::angle)
        .def_readwrite("texture_file", &LightDesc::texture_file)
        .def_readwrite("texture_color_space", &LightDesc::texture_color_space)
        .def_readwrite("pole_axis", &LightDesc::pole_axis)
        .def_readwrite("shaping", &LightDesc::shaping)
        .def_readwrite("shape", &LightDesc::shape)
        .def_readwrite("tinted_by_material", &LightDesc::tinted_by_material);
    def_keyword_constructor<LightDesc>(light);
}

void bind_cameras(py::module_& module) {
    py::enum_<ApertureConform>(module, "ApertureConform")
        .value("ExpandAperture", ApertureConform::ExpandAperture)
        .value("CropAperture", ApertureConform::CropAperture)
        .value("AdjustApertureWidth", ApertureConform::AdjustApertureWidth)
        .value("AdjustApertureHeight", ApertureConform::AdjustApertureHeight)
        .value("AdjustPixelAspect", ApertureConform::AdjustPixelAspect);

    py::enum_<CameraProjection>(module, "CameraProjection")
        .value("Perspective", CameraProjection::Perspective)
        .value("Orthographic", CameraProjection::Orthographic);

    py::class_<CameraDesc> camera(module, "CameraDesc");
    camera.def_readwrite("name", &CameraDesc::name).def_readwrite("projection", &CameraDesc::projection);
    def_matrix(camera, "world_from_camera", &CameraDesc::world_from_camera);
    camera.def_readwrite("horizontal_aperture", &CameraDesc::horizontal_aperture)
        .def_readwrite("vertical_aperture", &CameraDesc::vertical_aperture)
        .def_readwrite("horizontal_aperture_offset", &CameraDesc::horizontal_aperture_offset)
        .def_readwrite("vertical_aperture_offset", &CameraDesc::vertical_aperture_offset)
        .def_readwrite("focal_length", &CameraDesc::focal_length)
        .def_readwrite("f_stop", &CameraDesc::f_stop)
        .def_readwrite("focus_distance", &CameraDesc::focus_distance)
        .def_readwrite("exposure_scale", &CameraDesc::exposure_scale);
    def_keyword_constructor<CameraDesc>(camera);
}

/// A list of the scene: read as a copy, replaced as a whole, or extended with add_<item>, which returns the index.
template <typename Item>
void def_items(py::class_<SceneDescription>& scene, const char* name, const char* add_name,
               std::vector<Item> SceneDescription::* member) {
    scene.def_readwrite(name, member);
    scene.def(
        add_name,
        [member](SceneDescription& self, Item item) {
            (self.*member).push_back(std::move(item));
            return static_cast<int>((self.*member).size()) - 1;
        },
        py::arg("item"));
}

std::vector<GeometryDesc> copy_geometries(const SceneDescription& scene) {
    std::vector<GeometryDesc> copies;
    for (const SharedGeometry& geometry : scene.geometries) copies.push_back(*geometry);
    return copies;
}

void set_geometries(SceneDescription& scene, std::vector<GeometryDesc> geometries) {
    scene.geometries.assign(std::move_iterator(geometries.begin()), std::move_iterator(geometries.end()));
}

void add_instances(SceneDescription& scene, const std::string& name, int group, const DoubleArray& matrices) {
    if (matrices.ndim() != 3 || matrices.shape(1) != 4 || matrices.shape(2) != 4) {
        throw py::value_error("expected matrices of shape (n, 4, 4)");
    }
    const auto count = static_cast<std::size_t>(matrices.shape(0));
    scene.instances.reserve(scene.instances.size() + count);
    for (std::size_t i = 0; i < count; ++i) {
        InstanceDesc instance;
        instance.name = name + "[" + std::to_string(i) + "]";
        instance.group = group;
        std::copy_n(matrices.data() + 16 * i, 16, instance.world_from_group.m.begin());
        scene.instances.push_back(std::move(instance));
    }
}

void bind_scene(py::module_& module) {
    py::class_<SceneDescription> scene(module, "SceneDescription");
    scene.def(py::init<>()).def_readwrite("source", &SceneDescription::source);
    def_items(scene, "textures", "add_texture", &SceneDescription::textures);
    def_items(scene, "materials", "add_material", &SceneDescription::materials);
    scene.def_property("geometries", &copy_geometries, &set_geometries);
    scene.def(
        "add_geometry",
        [](SceneDescription& self, GeometryDesc item) {
            self.geometries.emplace_back(std::move(item));
            return static_cast<int>(self.geometries.size()) - 1;
        },
        py::arg("item"));
    def_items(scene, "shapes", "add_shape", &SceneDescription::shapes);
    def_items(scene, "groups", "add_group", &SceneDescription::groups);
    def_items(scene, "instances", "add_instance", &SceneDescription::instances);
    def_items(scene, "lights", "add_light", &SceneDescription::lights);
    def_items(scene, "cameras", "add_camera", &SceneDescription::cameras);
    scene.def("add_instances", &add_instances, py::arg("name"), py::arg("group"), py::arg("world_from_group"));
    scene.def("copy", [](const SceneDescription& self) { return SceneDescription(self); });
}

}  // namespace

void bind_scene_description(py::module_& module) {
    bind_textures(module);
    bind_materials(module);
    bind_mesh(module);
    bind_implicits(module);
    bind_shapes(module);
    bind_lights(module);
    bind_cameras(module);
    bind_scene(module);
}

}  // namespace etendue::python
