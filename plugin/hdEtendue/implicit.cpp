#include "implicit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include <pxr/imaging/hd/changeTracker.h>
#include <pxr/imaging/hd/dataSource.h>
#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/sceneDelegate.h>
#include <pxr/imaging/hd/sceneIndex.h>
#include <pxr/imaging/hd/tokens.h>

#include "convert.h"
#include "render_param.h"
#include "shape_sync.h"

namespace etendue::hydra {
namespace {

/// The attributes of one implicit surface.
class Attributes {
public:
    Attributes(HdSceneDelegate& delegate, Warnings& warnings, const SdfPath& path, const TfToken& type)
        : warnings_(warnings), path_(path) {
        const HdSceneIndexBaseRefPtr scene = delegate.GetRenderIndex().GetTerminalSceneIndex();
        const HdContainerDataSourceHandle prim = scene ? scene->GetPrim(path).dataSource : nullptr;
        if (prim) source_ = HdContainerDataSource::Cast(prim->Get(type));
    }

    [[nodiscard]] double number(const char* name, double fallback) const { return number_or(value(name), fallback); }

    [[nodiscard]] Axis axis() const {
        const std::string axis = text(value("axis"));
        if (axis == "X") return Axis::X;
        return axis == "Y" ? Axis::Y : Axis::Z;
    }

    /// The radius, or the mean of the two of a _1 schema when they differ.
    [[nodiscard]] double radius(double fallback) const {
        const double both = number("radius", fallback);
        const double top = number("radiusTop", both);
        const double bottom = number("radiusBottom", both);
        if (top != bottom) {
            warnings_.warn("tapered solid", path_, "a solid with two radii is not supported; their mean is used");
        }
        return (top + bottom) / 2;
    }

private:
    /// From the scene index: HdSceneDelegate::Get knows some of the types only.
    [[nodiscard]] VtValue value(const char* name) const {
        const auto sampled = source_ ? HdSampledDataSource::Cast(source_->Get(TfToken(name))) : nullptr;
        return sampled ? sampled->GetValue(0) : VtValue();
    }

    Warnings& warnings_;
    SdfPath path_;
    HdContainerDataSourceHandle source_;
};

GeometryDesc read_solid(const TfToken& type, const Attributes& from) {
    if (type == HdPrimTypeTokens->sphere) return SphereDesc{from.number("radius", SphereDesc().radius)};
    if (type == HdPrimTypeTokens->cube) return CubeDesc{from.number("size", CubeDesc().size)};
    if (type == HdPrimTypeTokens->plane) {
        return PlaneDesc{from.number("width", PlaneDesc().width), from.number("length", PlaneDesc().length),
                         from.axis()};
    }
    const auto upright = [&from]<class Desc>(Desc fallback) {
        return Desc{from.radius(fallback.radius), from.number("height", fallback.height), from.axis()};
    };
    if (type == HdPrimTypeTokens->cylinder) return upright(CylinderDesc());
    if (type == HdPrimTypeTokens->cone) return upright(ConeDesc());
    return upright(CapsuleDesc());
}

/// Why the solid cannot be rendered, empty when it can.
std::string complaint(const GeometryDesc& solid) {
    const auto bad = [](std::initializer_list<double> sizes) {
        return std::any_of(sizes.begin(), sizes.end(), [](double size) { return !(size > 0) || !std::isfinite(size); });
    };
    const bool unusable = std::visit(
        [&bad](const auto& desc) {
            using Desc = std::decay_t<decltype(desc)>;
            if constexpr (std::is_same_v<Desc, SphereDesc>)
                return bad({desc.radius});
            else if constexpr (std::is_same_v<Desc, CubeDesc>)
                return bad({desc.size});
            else if constexpr (std::is_same_v<Desc, PlaneDesc>)
                return bad({desc.width, desc.length});
            // A capsule of no height is a sphere.
            else if constexpr (std::is_same_v<Desc, CapsuleDesc>)
                return bad({desc.radius, desc.height + desc.radius}) || desc.height < 0;
            else if constexpr (std::is_same_v<Desc, MeshDesc>)
                return false;
            else
                return bad({desc.radius, desc.height});
        },
        solid);
    return unusable ? "its sizes are not positive" : "";
}

}  // namespace

const TfTokenVector& Implicit::types() {
    static const TfTokenVector all{HdPrimTypeTokens->sphere,   HdPrimTypeTokens->cube,    HdPrimTypeTokens->plane,
                                   HdPrimTypeTokens->cylinder, HdPrimTypeTokens->capsule, HdPrimTypeTokens->cone};
    return all;
}

HdDirtyBits Implicit::GetInitialDirtyBitsMask() const {
    return HdChangeTracker::InitRepr | HdChangeTracker::DirtyTransform | HdChangeTracker::DirtyVisibility |
           HdChangeTracker::DirtyMaterialId | HdChangeTracker::DirtyInstancer | HdChangeTracker::DirtyInstanceIndex |
           HdChangeTracker::DirtyRenderTag | HdChangeTracker::DirtyPrimvar;
}

const TfTokenVector& Implicit::GetBuiltinPrimvarNames() const {
    static const TfTokenVector none;
    return none;
}

std::shared_ptr<const Geometry> Implicit::read_geometry(HdSceneDelegate& delegate, Warnings& warnings) const {
    GeometryDesc solid = read_solid(type_, Attributes(delegate, warnings, GetId(), type_));
    const std::string reason = complaint(solid);
    if (reason.empty()) return std::make_shared<const Geometry>(std::move(solid));
    warnings.warn("unusable solid " + GetId().GetString(), GetId(), "it is left out: " + reason);
    return nullptr;
}

void Implicit::Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits, const TfToken& /*repr*/) {
    RenderParam& shared = ours(param);
    _UpdateVisibility(delegate, bits);
    _UpdateInstancer(delegate, bits);
    if (*bits & HdChangeTracker::DirtyPrimvar) {  // Hydra's bit for the attributes, too
        record_.geometry = Geometry::kept(record_.geometry, read_geometry(*delegate, shared.warnings()));
        sync_display(shared.warnings(), GetId(), read_primvars(*delegate, GetId()), record_);
    }
    sync_shape(*delegate, *this, *bits, record_);
    shared.store().set_shape(GetId(), record_);
    *bits &= ~HdChangeTracker::AllSceneDirtyBits;
}

/// Hydra does not sync prims whose tag nobody shows, but tells all of them their tags.
void Implicit::UpdateRenderTag(HdSceneDelegate* delegate, HdRenderParam* param) {
    HdRprim::UpdateRenderTag(delegate, param);
    record_.render_tag = GetRenderTag();
    ours(param).store().set_render_tag(GetId(), record_.render_tag);
}

void Implicit::Finalize(HdRenderParam* param) { ours(param).store().remove_shape(GetId()); }

}  // namespace etendue::hydra
