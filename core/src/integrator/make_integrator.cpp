#include "integrator/bdpt/bdpt_integrator.h"
#include "integrator/integrator.h"
#include "integrator/path/path_integrator.h"

namespace etendue {

std::unique_ptr<Integrator> make_integrator(const RenderContext& context) {
    if (context.settings.integrator == IntegratorKind::Path) return std::make_unique<PathIntegrator>(context);
    return std::make_unique<BdptIntegrator>(context);
}

}  // namespace etendue
