#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene_store.h"
#include "textures.h"
#include "translation.h"

namespace etendue::hydra {

/// An index into SceneDescription::materials and what geometry needs to know of it.
struct BoundMaterial {
    int index = 0;
    std::string st = kDefaultSt;
    bool emits = false;
};

/// Fills SceneDescription::materials, once per material that is used.
class MaterialTranslator {
public:
    MaterialTranslator(const Translation& translation, const std::map<SdfPath, HdMaterialNetwork2>& networks)
        : translation_(translation), networks_(networks) {}

    /// The material at `path`, or without a usable one the look of the shape's displayColor.
    [[nodiscard]] BoundMaterial bound(const SdfPath& path, const ShapeRecord& shape);
    /// A surface that reflects nothing.
    [[nodiscard]] BoundMaterial black();

private:
    [[nodiscard]] std::optional<BoundMaterial> translated(const SdfPath& path);
    [[nodiscard]] std::optional<BoundMaterial> translate(const SdfPath& path);
    [[nodiscard]] BoundMaterial display(const ShapeRecord& shape);
    [[nodiscard]] int add(MaterialDesc desc);

    using Look = std::pair<std::optional<Color>, double>;

    Translation translation_;
    const std::map<SdfPath, HdMaterialNetwork2>& networks_;
    std::map<SdfPath, std::optional<BoundMaterial>> translated_;
    std::map<Look, BoundMaterial> displays_;
    std::optional<BoundMaterial> black_;
};

}  // namespace etendue::hydra
