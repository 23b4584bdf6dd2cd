#include "light/light_sampler.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "math/constants.h"
#include "math/sampling.h"

namespace etendue {
namespace {

std::vector<double> half_even(const std::vector<double>& powers) {
    double sum = 0;
    double lit = 0;
    for (double power : powers) {
        sum += power;
        if (power > 0) lit += 1;
    }
    std::vector<double> weights;
    weights.reserve(powers.size());
    for (double power : powers) weights.push_back(power > 0 ? power / sum + 1 / lit : 0);
    return weights;
}

double pmf(const Distribution& distribution, int index) {
    return distribution.total() > 0 ? distribution.pmf(static_cast<std::size_t>(index)) : 0;
}

/// However many lights there are.
constexpr double kLeastBlindShare = 0.125;

/// u of [0, share), again in [0, 1).
double stretched(double u, double share) { return std::min(u / share, kOneMinusEpsilon); }

}  // namespace

LightSampler::LightSampler(const std::vector<std::unique_ptr<Light>>& lights, const SceneBounds& bounds)
    : boundless_slot_(lights.size(), -1) {
    std::vector<double> powers;
    powers.reserve(lights.size());
    for (const auto& light : lights) powers.push_back(total(light->power()));
    emission_ = Distribution(powers);
    blind_ = Distribution(half_even(powers));

    const double disk_area = kPi * bounds.radius * bounds.radius;
    std::vector<LightTree::Item> items;
    std::vector<double> irradiances;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!(powers[i] > 0)) continue;
        const int index = static_cast<int>(i);
        if (const auto light_bounds = lights[i]->bounds()) {
            items.push_back({index, *light_bounds, powers[i]});
            continue;
        }
        boundless_slot_[i] = static_cast<int>(boundless_.size());
        boundless_.push_back(index);
        irradiances.push_back(powers[i] / disk_area);
    }
    const std::size_t lit = items.size() + boundless_.size();
    if (lit > 1) blind_share_ = std::max(kLeastBlindShare, 1 / static_cast<double>(lit));
    by_irradiance_ = Distribution(irradiances);
    tree_ = LightTree(std::move(items));
}

std::optional<LightChoice> LightSampler::sample_emission(double u) const {
    if (!(emission_.total() > 0)) return {};
    const std::size_t i = emission_.sample(u).index;
    return LightChoice{static_cast<int>(i), emission_.pmf(i)};
}

double LightSampler::pmf_emission(int light) const { return pmf(emission_, light); }

double LightSampler::mixed(double aware, int light) const {
    return blind_share_ * pmf(blind_, light) + (1 - blind_share_) * aware;
}

std::optional<LightChoice> LightSampler::sample_direct(const Vec3& receiver, double u) const {
    if (!(blind_.total() > 0)) return {};
    if (u < blind_share_) {
        const int light = static_cast<int>(blind_.sample(stretched(u, blind_share_)).index);
        return LightChoice{light, pmf_direct(receiver, light)};
    }
    const auto choice = sample_aware(receiver, stretched(u - blind_share_, 1 - blind_share_));
    if (!choice) return {};
    return LightChoice{choice->light, mixed(choice->pmf, choice->light)};
}

double LightSampler::pmf_direct(const Vec3& receiver, int light) const {
    if (blind_share_ == 1) return pmf(blind_, light);
    return mixed(pmf_aware(receiver, light), light);
}

double LightSampler::tree_share(const Vec3& receiver) const {
    if (tree_.empty()) return 0;
    if (boundless_.empty()) return 1;
    // Half evenly: the tree's middle may be far away while one of its lights is near.
    const double share = tree_.share_against(by_irradiance_.total(), receiver);
    return share > 0 ? 0.5 * (share + 1 / static_cast<double>(boundless_.size() + 1)) : 0;
}

std::optional<LightChoice> LightSampler::sample_aware(const Vec3& receiver, double u) const {
    const double share = tree_share(receiver);
    if (u < share) {
        auto choice = tree_.sample(receiver, stretched(u, share));
        if (choice) choice->pmf *= share;
        return choice;
    }
    const std::size_t slot = by_irradiance_.sample(stretched(u - share, 1 - share)).index;
    return LightChoice{boundless_[slot], (1 - share) * by_irradiance_.pmf(slot)};
}

double LightSampler::pmf_aware(const Vec3& receiver, int light) const {
    if (pmf(blind_, light) == 0) return 0;
    const double share = tree_share(receiver);
    const int slot = boundless_slot_[static_cast<std::size_t>(light)];
    return slot < 0 ? tree_.pmf(receiver, light) * share : (1 - share) * pmf(by_irradiance_, slot);
}

}  // namespace etendue
