#include "fuzz/materials.h"

namespace etendue::test {
namespace {

class MaterialDice {
public:
    MaterialDice(Dice& dice, int textures, double scale) : dice_(dice), textures_(textures), scale_(scale) {}

    MaterialModel model() {
        switch (dice_.below(7)) {
            case 0:
                return DiffuseMaterial{color(), fraction()};
            case 1:
                return ConductorMaterial{color(), fraction()};
            case 2:
            case 3:
                return dielectric();
            case 4:
                return preview();
            case 5:
                return open_pbr();
            default:
                return phong();
        }
    }

    ColorInput emission() {
        if (!dice_.chance(0.12)) return {};
        ColorInput out = color();
        const double power = dice_.power(1);
        for (double& channel : out.value) channel *= power;
        return out;
    }

    /// Index of a texture, -1 for none; rarely out of range.
    int texture() {
        if (dice_.chance(0.001)) return textures_ + 3;
        return textures_ > 0 && dice_.chance(0.15) ? dice_.below(textures_) : -1;
    }

private:
    ColorInput color() { return {random_color(dice_), texture()}; }
    FloatInput fraction() { return {dice_.fraction(), texture(), dice_.below(4)}; }
    /// Mostly not there.
    FloatInput weight() {
        if (dice_.chance(0.5)) return {};
        return fraction();
    }
    double ior() {
        if (dice_.chance(0.3)) return dice_.number(1.5);
        return dice_.number(dice_.one_of(
            {1.0,   1 + 1e-15, 1 - 1e-15, 1 + 1e-9, 1 - 1e-9, 1 + 1e-6, 1 - 1e-6, 1.00001, 1.00002, 1.0001, 0.9999,
             1.333, 2.4,       4.0,       1 / 1.5,  0.1,      10.0,     1e3,      1e-3,    0.0,     1e-20,  1e20}));
    }
    double depth() {
        if (dice_.chance(0.5)) return 0;
        return dice_.number(scale_ * (dice_.chance(0.7) ? dice_.between(0.1, 2) : dice_.log_between(1e-20, 1e20)));
    }

    DielectricMaterial dielectric() {
        DielectricMaterial m;
        m.ior = ior();
        if (dice_.chance(0.6)) m.roughness = fraction();
        if (dice_.chance(0.2)) m.reflection_tint = color();
        if (dice_.chance(0.4)) m.transmission_tint = color();
        m.transmission_depth = depth();
        m.thin_walled = dice_.chance(0.2);
        return m;
    }

    PreviewSurfaceMaterial preview() {
        PreviewSurfaceMaterial m;
        m.diffuse_color = color();
        m.use_specular_workflow = dice_.chance(0.4);
        m.specular_color = color();
        m.metallic = weight();
        m.roughness = fraction();
        m.clearcoat = weight();
        m.clearcoat_roughness = fraction();
        if (dice_.chance(0.5)) m.opacity = fraction();
        if (dice_.chance(0.3)) m.opacity_mode = PreviewOpacityMode::Presence;
        if (dice_.chance(0.2)) m.opacity_threshold = dice_.fraction();
        m.ior = ior();
        return m;
    }

    OpenPbrMaterial open_pbr() {
        OpenPbrMaterial m;
        m.base_weight = fraction();
        m.base_color = color();
        m.base_diffuse_roughness = weight();
        m.base_metalness = weight();
        m.specular_weight = fraction();
        m.specular_color = color();
        m.specular_roughness = fraction();
        m.specular_ior = ior();
        m.transmission_weight = weight();
        m.transmission_color = color();
        m.transmission_depth = depth();
        m.coat_weight = weight();
        m.coat_roughness = fraction();
        m.coat_ior = ior();
        m.coat_darkening = fraction();
        if (dice_.chance(0.3)) m.geometry_opacity = fraction();
        m.geometry_thin_walled = dice_.chance(0.2);
        return m;
    }

    PhongMaterial phong() {
        PhongMaterial m;
        m.reflectance = color();
        m.exponent = {
            dice_.number(dice_.chance(0.5) ? dice_.log_between(1, 1000) : dice_.one_of({0.0, 1e-20, 1e8, 1e20})),
            texture(), dice_.below(4)};
        m.form = dice_.one_of({PhongForm::Modified, PhongForm::Classic});
        return m;
    }

    Dice& dice_;
    int textures_;
    double scale_;
};

}  // namespace

Color random_color(Dice& dice) {
    if (dice.chance(0.3)) {
        const double grey = dice.fraction();
        return {grey, grey, grey};
    }
    const double r = dice.fraction();
    const double g = dice.fraction();
    return {r, g, dice.fraction()};
}

MaterialDesc random_material(Dice& dice, int textures, double scale) {
    MaterialDice of(dice, textures, scale);
    MaterialDesc material;
    material.model = of.model();
    material.emission = of.emission();
    material.normal_texture = of.texture();
    return material;
}

}  // namespace etendue::test
