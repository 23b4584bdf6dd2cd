#include <etendue/error.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {

void bind_error(py::module_& module) {
    // Translators are tried in reverse order of registration, so the base comes first.
    const auto error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
    error.doc() = "Base of everything Etendue raises on purpose; the message names the file or prim at fault.";
    py::register_exception<SceneError>(module, "SceneError", error).doc() =
        "The scene cannot be rendered as described.";
    py::register_exception<SettingsError>(module, "SettingsError", error).doc() =
        "The render settings contradict themselves or the scene.";
    py::register_exception<FileError>(module, "FileError", error).doc() = "A file could not be read or written.";
    for (const char* name : {"Error", "SceneError", "SettingsError", "FileError"}) {
        module.attr(name).attr("__module__") = "etendue";
    }
}

}  // namespace etendue::python
