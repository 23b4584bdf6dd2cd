#include <etendue/image_io.h>

#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {

void bind_image_io(py::module_& module) {
    using Unlocked = py::call_guard<py::gil_scoped_release>;
    py::enum_<ImageFileKind>(module, "ImageFileKind")
        .value("SceneLinear", ImageFileKind::SceneLinear)
        .value("Display", ImageFileKind::Display);
    module.def("image_file_kind", &image_file_kind, py::arg("file"));
    module.def("check_writable", &check_writable, py::arg("file"), Unlocked());
    module.def("write_exr", &write_exr, py::arg("file"), py::arg("image"), py::arg("metadata"), Unlocked());
    module.def("write_display_image", &write_display_image, py::arg("file"), py::arg("image"), py::arg("config"),
               py::arg("display") = "", py::arg("view") = "", py::arg("bits") = 8, Unlocked());
}

}  // namespace etendue::python
