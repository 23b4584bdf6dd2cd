#include "materials.h"

#include <algorithm>
#include <utility>

#include <pxr/imaging/hd/tokens.h>

#include "surface_shaders.h"

namespace etendue::hydra {
namespace {

using Reader = MaterialDesc (*)(ShaderInputs&);

Reader reader_of(const std::string& type) {
    if (type == "UsdPreviewSurface" || type == "ND_UsdPreviewSurface_surfaceshader") return read_preview_surface;
    if (type == "ND_open_pbr_surface_surfaceshader") return read_open_pbr;
    if (type == "EtenduePhong") return read_phong;
    return nullptr;
}

/// The surface shader of a network; without a node when there is none.
NodeRef surface_of(const HdMaterialNetwork2& network) {
    const auto terminal = network.terminals.find(HdMaterialTerminalTokens->surface);
    if (terminal == network.terminals.end()) return {};
    const auto node = network.nodes.find(terminal->second.upstreamNode);
    if (node == network.nodes.end()) return {};
    return {&network, node->first, &node->second};
}

bool emits(const MaterialDesc& desc) {
    const Color& value = desc.emission.value;
    return desc.emission.texture >= 0 || std::any_of(value.begin(), value.end(), [](double v) { return v > 0; });
}

void warn_of_coordinates(const ShaderInputs& inputs, const SdfPath& path) {
    if (inputs.st_names().size() < 2) return;
    inputs.warn("several texture coordinates " + path.GetString(),
                "one set of texture coordinates per material: '" + inputs.st_names().front() + "' is used for all");
}

}  // namespace

BoundMaterial MaterialTranslator::bound(const SdfPath& path, const ShapeRecord& shape) {
    if (path.IsEmpty()) return display(shape);
    const std::optional<BoundMaterial> material = translated(path);
    return material ? *material : display(shape);
}

BoundMaterial MaterialTranslator::black() {
    if (!black_) {
        DiffuseMaterial model;
        model.reflectance = {};
        MaterialDesc desc;
        desc.name = "no material response";
        desc.model = std::move(model);
        black_ = BoundMaterial{add(std::move(desc))};
    }
    return *black_;
}

std::optional<BoundMaterial> MaterialTranslator::translated(const SdfPath& path) {
    const auto known = translated_.find(path);
    if (known != translated_.end()) return known->second;
    return translated_[path] = translate(path);
}

std::optional<BoundMaterial> MaterialTranslator::translate(const SdfPath& path) {
    const auto network = networks_.find(path);
    const NodeRef surface = network == networks_.end() ? NodeRef{} : surface_of(network->second);
    if (surface.node == nullptr) {
        translation_.warnings.warn("material " + path.GetString(), path,
                                   "the material has no surface shader; displayColor is rendered instead");
        return std::nullopt;
    }
    const Reader reader = reader_of(surface.type());
    if (reader == nullptr) {
        translation_.warnings.warn(
            "material " + path.GetString(), path,
            "surface node '" + surface.type() + "' is not supported; displayColor is rendered instead");
        return std::nullopt;
    }
    ShaderInputs inputs(translation_, surface);
    MaterialDesc desc = reader(inputs);
    desc.name = path.GetString();
    warn_of_coordinates(inputs, path);
    BoundMaterial material;
    material.emits = emits(desc);
    material.index = add(std::move(desc));
    if (!inputs.st_names().empty()) material.st = inputs.st_names().front();
    return material;
}

/// Diffuse, with core's default reflectance where no colour is authored.
BoundMaterial MaterialTranslator::display(const ShapeRecord& shape) {
    const Look look{shape.display_color, shape.display_opacity};
    const auto known = displays_.find(look);
    if (known != displays_.end()) return known->second;
    MaterialDesc desc;
    desc.name = "displayColor";
    ColorInput reflectance = DiffuseMaterial().reflectance;
    if (shape.display_color) reflectance.value = *shape.display_color;
    if (shape.display_opacity >= 1) {
        DiffuseMaterial model;
        model.reflectance = reflectance;
        desc.model = std::move(model);
    } else {
        OpenPbrMaterial model;
        model.base_color = reflectance;
        model.specular_weight = {0.0};
        model.geometry_opacity = {shape.display_opacity};
        desc.model = std::move(model);
    }
    return displays_[look] = BoundMaterial{add(std::move(desc))};
}

int MaterialTranslator::add(MaterialDesc desc) {
    auto& materials = translation_.scene.materials;
    materials.push_back(std::move(desc));
    return static_cast<int>(materials.size()) - 1;
}

}  // namespace etendue::hydra
