#include "integrator/bdpt/bdpt_integrator.h"
#include "integrator/integrator.h"
#include "integrator/path/path_integrator.h"

namespace etendue {
namespace {

/// Particle tracing alone: every light vertex is joined to the lens.
constexpr StrategySet kLightImageOnly{
    .emission_hit = false, .direct_light = false, .connection = false, .light_image = true, .lens_hit = false};

}  // namespace

bool traces_light_paths(const RenderSettings& settings) {
    return settings.integrator != IntegratorKind::Path && settings.light_paths_per_pixel != 0.0;
}

std::unique_ptr<Integrator> make_integrator(const RenderContext& context) {
    switch (context.settings.integrator) {
        case IntegratorKind::Path:
            return std::make_unique<PathIntegrator>(context);
        case IntegratorKind::Light:
            return std::make_unique<BdptIntegrator>(context, kLightImageOnly);
        case IntegratorKind::Bdpt:
        case IntegratorKind::Auto:  // before it has chosen
            break;
    }
    return std::make_unique<BdptIntegrator>(context, context.settings.strategies);
}

}  // namespace etendue
