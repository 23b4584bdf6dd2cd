#pragma once

/// A scene as plain data. Translators (the USD stage reader, the Hydra delegate, an embedding program) fill these
/// structs with authored values; what the values MEAN (UsdLux, UsdPreviewSurface, OpenPBR, UsdGeomCamera) is written
/// once, in core. Lengths are scene units, angles degrees, colours scene-linear in the rendering space (linear
/// Rec.709 unless the translator says otherwise), radiance in nits (luminance of white = 1).

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <etendue/export.h>

namespace etendue {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;
using Color = std::array<double, 3>;

/// Affine transform of column vectors, row-major: p' = M p (USD's matrices are the transpose of this).
struct Matrix4 {
    std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    [[nodiscard]] bool operator==(const Matrix4&) const = default;
};

/// Whether a matrix can place something: finite, affine and not singular.
[[nodiscard]] ETENDUE_EXPORT bool is_placement(const Matrix4& matrix);

// ---------------------------------------------------------------------------------------------------- textures

enum class TextureWrap { UseMetadata, Black, Clamp, Repeat, Mirror };

enum class TextureColorSpace { Auto, Raw, Srgb };

/// One UsdUVTexture with the UsdTransform2d before it. Value = texel * scale + bias.
struct TextureDesc {
    std::string name;  ///< prim path, for messages
    std::string file;
    TextureColorSpace color_space = TextureColorSpace::Auto;
    TextureWrap wrap_s = TextureWrap::UseMetadata;
    TextureWrap wrap_t = TextureWrap::UseMetadata;
    std::array<double, 4> scale{1, 1, 1, 1};
    std::array<double, 4> bias{0, 0, 0, 0};
    std::array<double, 4> fallback{0, 0, 0, 1};
    /// Rows of the affine map applied to st before the lookup: s' = m[0] s + m[1] t + m[2], t' = m[3] s + m[4] t +
    /// m[5].
    std::array<double, 6> st_transform{1, 0, 0, 0, 1, 0};

    [[nodiscard]] bool operator==(const TextureDesc&) const = default;
};

/// A constant, or the rgb of `textures[texture]` when texture >= 0.
struct ColorInput {
    Color value{0, 0, 0};
    int texture = -1;
};

/// A constant, or one channel (0..3 = r, g, b, a) of `textures[texture]` when texture >= 0.
struct FloatInput {
    double value = 0;
    int texture = -1;
    int channel = 0;
};

// --------------------------------------------------------------------------------------------------- materials

/// Lambert; with roughness (0 to 1) Oren-Nayar, energy-preserving ("EON", Portsmouth, Kutz and Hill 2024).
struct DiffuseMaterial {
    ColorInput reflectance{{0.5, 0.5, 0.5}};
    FloatInput roughness{0.0};
};

/// Metal by its normal reflectance (Schlick); roughness is perceptual, alpha = roughness^2; 0 is a mirror.
struct ConductorMaterial {
    ColorInput reflectance{{0.9, 0.9, 0.9}};
    FloatInput roughness{0.0};
};

/// Interface between the outside (index 1) and the inside (index ior) of a closed surface; inside is against the
/// geometric normal. Roughness is perceptual, alpha = roughness^2; 0 is smooth. transmission_tint colours every
/// crossing; with a transmission_depth (scene units) it is what the inside leaves of light over that depth instead, by
/// Beer's law. A textured tint cannot say what the inside is made of and always colours crossings.
struct DielectricMaterial {
    double ior = 1.5;
    FloatInput roughness{0.0};
    ColorInput reflection_tint{{1, 1, 1}};
    ColorInput transmission_tint{{1, 1, 1}};
    double transmission_depth = 0;
    bool thin_walled = false;  ///< a pane in air: all its internal reflections at once, straight through
};

enum class PreviewOpacityMode { Transparent, Presence };

/// UsdPreviewSurface 2.6. emissiveColor goes to MaterialDesc::emission, normal to MaterialDesc::normal_texture.
struct PreviewSurfaceMaterial {
    ColorInput diffuse_color{{0.18, 0.18, 0.18}};
    bool use_specular_workflow = false;
    ColorInput specular_color{{0, 0, 0}};
    FloatInput metallic{0.0};
    FloatInput roughness{0.5};
    FloatInput clearcoat{0.0};
    FloatInput clearcoat_roughness{0.01};
    FloatInput opacity{1.0};
    PreviewOpacityMode opacity_mode = PreviewOpacityMode::Transparent;
    double opacity_threshold = 0.0;
    double ior = 1.5;
};

/// The dielectric, metal, diffuse and coat parts of OpenPBR 1.1. Emission goes to MaterialDesc::emission.
struct OpenPbrMaterial {
    FloatInput base_weight{1.0};
    ColorInput base_color{{0.8, 0.8, 0.8}};
    FloatInput base_diffuse_roughness{0.0};
    FloatInput base_metalness{0.0};
    FloatInput specular_weight{1.0};
    ColorInput specular_color{{1, 1, 1}};
    FloatInput specular_roughness{0.3};
    double specular_ior = 1.5;
    FloatInput transmission_weight{0.0};
    ColorInput transmission_color{{1, 1, 1}};
    double transmission_depth = 0;  ///< scene units; as of DielectricMaterial
    FloatInput coat_weight{0.0};
    FloatInput coat_roughness{0.0};
    double coat_ior = 1.6;
    FloatInput coat_darkening{1.0};
    FloatInput geometry_opacity{1.0};
    bool geometry_thin_walled = false;  ///< of the transmission; as DielectricMaterial::thin_walled
};

/// Modified: symmetric. Classic: divided by the cosine of the direction that light comes from (theory.md §7).
enum class PhongForm { Modified, Classic };

/// Phong's highlight alone; `reflectance` is the albedo seen along the normal.
struct PhongMaterial {
    ColorInput reflectance{{0.5, 0.5, 0.5}};
    FloatInput exponent{20.0};
    PhongForm form = PhongForm::Modified;
};

using MaterialModel = std::variant<DiffuseMaterial, ConductorMaterial, DielectricMaterial, PreviewSurfaceMaterial,
                                   OpenPbrMaterial, PhongMaterial>;

struct MaterialDesc {
    std::string name;
    MaterialModel model;
    ColorInput emission;      ///< radiance leaving the front side (the side of the geometric normal), nits
    int normal_texture = -1;  ///< tangent-space normals; scale and bias of the texture map texels to [-1, 1]
};

// ---------------------------------------------------------------------------------------------------- geometry

enum class Interpolation { Constant, Uniform, Vertex, FaceVarying };

/// Polygon mesh; convex or concave faces of three or more corners. Without normals it is faceted, never smoothed.
struct MeshDesc {
    std::vector<Float3> points;
    std::vector<std::int32_t> face_vertex_counts;
    std::vector<std::int32_t> face_vertex_indices;
    std::vector<Float3> normals;
    Interpolation normals_interpolation = Interpolation::Vertex;
    std::vector<Float2> st;
    Interpolation st_interpolation = Interpolation::Vertex;
    std::vector<std::int32_t> face_materials;  ///< per face an index into ShapeDesc::materials; empty: all 0
    bool left_handed = false;                  ///< UsdGeom orientation

    [[nodiscard]] bool operator==(const MeshDesc&) const = default;
};

struct SphereDesc {
    double radius = 1;

    [[nodiscard]] bool operator==(const SphereDesc&) const = default;
};
struct CubeDesc {
    double size = 2;

    [[nodiscard]] bool operator==(const CubeDesc&) const = default;
};
enum class Axis { X, Y, Z };
struct CylinderDesc {
    double radius = 1;
    double height = 2;
    Axis axis = Axis::Z;

    [[nodiscard]] bool operator==(const CylinderDesc&) const = default;
};
struct ConeDesc {
    double radius = 1;
    double height = 2;
    Axis axis = Axis::Z;

    [[nodiscard]] bool operator==(const ConeDesc&) const = default;
};
struct CapsuleDesc {
    double radius = 0.5;
    double height = 1;
    Axis axis = Axis::Z;

    [[nodiscard]] bool operator==(const CapsuleDesc&) const = default;
};
struct PlaneDesc {
    double width = 2;
    double length = 2;
    Axis axis = Axis::Z;

    [[nodiscard]] bool operator==(const PlaneDesc&) const = default;
};

using GeometryDesc = std::variant<MeshDesc, SphereDesc, CubeDesc, CylinderDesc, ConeDesc, CapsuleDesc, PlaneDesc>;

/// A geometry that any number of descriptions may share. Copies are the same geometry: a render that follows another
/// one takes over what has been built of it.
class SharedGeometry {
public:
    template <typename Kind>
        requires(std::constructible_from<GeometryDesc, Kind> &&
                 !std::same_as<std::remove_cvref_t<Kind>, SharedGeometry>)
    SharedGeometry(Kind&& desc)  // NOLINT(google-explicit-constructor): it stands for its description
        : desc_(std::make_shared<const GeometryDesc>(std::forward<Kind>(desc))) {}

    [[nodiscard]] const GeometryDesc& operator*() const { return *desc_; }
    [[nodiscard]] const std::shared_ptr<const GeometryDesc>& pointer() const { return desc_; }

private:
    std::shared_ptr<const GeometryDesc> desc_;
};

struct ShapeDesc {
    std::string name;  ///< prim path
    int geometry = -1;
    std::vector<int> materials;  ///< usually one; several with MeshDesc::face_materials
    Matrix4 parent_from_object;  ///< world for top-level shapes, the group's space inside a group
};

/// What instances share: shapes in the group's own space.
struct GroupDesc {
    std::string name;
    std::vector<ShapeDesc> shapes;
};

struct InstanceDesc {
    std::string name;
    int group = -1;
    Matrix4 world_from_group;
};

// ------------------------------------------------------------------------------------------------------ lights

enum class LightKind { Rect, Disk, Sphere, Cylinder, Distant, Dome, Mesh };

/// UsdLux ShapingAPI.
struct ShapingDesc {
    double focus = 0;
    Color focus_tint{0, 0, 0};
    double cone_angle = 90;  ///< from the axis, degrees
    double cone_softness = 0;
};

/// A UsdLux light, attribute by attribute. Units and size factors: UsdLux 26.11 (area in scene units squared).
struct LightDesc {
    std::string name;
    LightKind kind = LightKind::Rect;
    Matrix4 world_from_light;
    double intensity = 1;  ///< the schema's fallback for DistantLight is 50000; translators pass what applies
    double exposure = 0;
    Color color{1, 1, 1};
    Color color_temperature_rgb{1, 1, 1};  ///< blackbody tint when enableColorTemperature, else white
    bool normalize = false;
    double width = 1;             ///< rect
    double height = 1;            ///< rect
    double length = 1;            ///< cylinder, along x
    double radius = 0.5;          ///< disk, sphere, cylinder
    bool treat_as_point = false;  ///< sphere
    bool treat_as_line = false;   ///< cylinder
    double angle = 0.53;          ///< distant: full angle, degrees; 0 is a delta light of `intensity` lux
    std::string texture_file;     ///< rect, and dome: latlong; empty: none
    TextureColorSpace texture_color_space = TextureColorSpace::Auto;
    Axis pole_axis = Axis::Y;  ///< dome: which axis of light space the top of the texture is about; Y or Z
    /// All but distant and dome: empty when not applied, which is no cone at all.
    std::optional<ShapingDesc> shaping;
    int shape = -1;                   ///< mesh: index into SceneDescription::shapes
    bool tinted_by_material = false;  ///< mesh: materialGlowTintsLight
};

// ----------------------------------------------------------------------------------------------------- cameras

enum class ApertureConform {
    ExpandAperture,
    CropAperture,
    AdjustApertureWidth,
    AdjustApertureHeight,
    AdjustPixelAspect
};

enum class CameraProjection { Perspective, Orthographic };

/// A UsdGeomCamera. Apertures and focal length are in tenths of a scene unit, distances in scene units. The camera
/// looks down its -Z with +Y up. Orthographic: the apertures are the width and height of what is seen, from the
/// camera's own plane on; focal length, f-stop and focus distance have no meaning. The body that holds the camera's
/// position, if any, is taken to hold all of that plane.
struct CameraDesc {
    std::string name;
    CameraProjection projection = CameraProjection::Perspective;
    Matrix4 world_from_camera;
    double horizontal_aperture = 20.955;
    double vertical_aperture = 15.2908;
    double horizontal_aperture_offset = 0;
    double vertical_aperture_offset = 0;
    double focal_length = 50;
    double f_stop = 0;  ///< 0: pinhole
    double focus_distance = 0;
    double exposure_scale = 1;  ///< UsdGeomCamera.ComputeLinearExposureScale(); multiplies the image
};

struct SceneDescription {
    std::string source;  ///< file the scene came from, for messages; may be empty
    std::vector<TextureDesc> textures;
    std::vector<MaterialDesc> materials;
    std::vector<SharedGeometry> geometries;
    std::vector<ShapeDesc> shapes;
    std::vector<GroupDesc> groups;
    std::vector<InstanceDesc> instances;
    std::vector<LightDesc> lights;
    std::vector<CameraDesc> cameras;
};

}  // namespace etendue
