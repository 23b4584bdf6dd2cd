#include <etendue/version.h>

#include "bindings.h"

namespace etendue::python {

void bind_version(pybind11::module_& module) { module.attr("__version__") = ETENDUE_VERSION; }

}  // namespace etendue::python
