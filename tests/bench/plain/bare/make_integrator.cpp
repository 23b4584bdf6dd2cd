#include "integrator/integrator.h"
#include "integrator/path/path_integrator.h"

namespace etendue {

std::unique_ptr<Integrator> make_integrator(const RenderContext& context) {
    return std::make_unique<PathIntegrator>(context);
}

}  // namespace etendue
