#include <etendue/display.h>

#include <span>
#include <string>

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {
namespace {

/// A new array of display values in the shape of `rgb`.
py::array_t<float> apply(const ColorConfig& config, const FloatArray& rgb, const std::string& display,
                         const std::string& view) {
    if (rgb.ndim() < 1 || rgb.shape(rgb.ndim() - 1) != 3) {
        throw py::value_error("expected an array of shape (..., 3)");
    }
    py::array_t<float> result(std::vector<py::ssize_t>(rgb.shape(), rgb.shape() + rgb.ndim()));
    std::copy_n(rgb.data(), rgb.size(), result.mutable_data());
    const std::span<float> values(result.mutable_data(), static_cast<std::size_t>(result.size()));
    const py::gil_scoped_release release;
    config.apply(values, display, view);
    return result;
}

}  // namespace

void bind_display(py::module_& module) {
    py::class_<ColorConfig>(module, "ColorConfig")
        .def(py::init<const std::string&>(), py::arg("file") = "")
        .def_property_readonly("source", &ColorConfig::source)
        .def_property_readonly("displays", &ColorConfig::displays)
        .def("views", &ColorConfig::views, py::arg("display"))
        .def_property_readonly("default_display", &ColorConfig::default_display)
        .def("default_view", &ColorConfig::default_view, py::arg("display"))
        .def("apply", &apply, py::arg("rgb"), py::arg("display") = "", py::arg("view") = "");
}

}  // namespace etendue::python
