#pragma once

/// The extension module etendue._core: the façade, header by header. Each bind_* fills the module with one header.

#include <pybind11/pybind11.h>

namespace etendue::python {

void bind_error(pybind11::module_& module);
void bind_version(pybind11::module_& module);
void bind_scene_description(pybind11::module_& module);
void bind_render_settings(pybind11::module_& module);
void bind_requirements(pybind11::module_& module);
void bind_film_view(pybind11::module_& module);
void bind_render_session(pybind11::module_& module);
void bind_display(pybind11::module_& module);
void bind_image_io(pybind11::module_& module);

/// A constructor that takes any of the struct's attributes as keywords and leaves the others at their defaults. An
/// unknown keyword is a TypeError, as for a Python function.
template <typename Struct, typename Class>
void def_keyword_constructor(Class& cls) {
    cls.def(pybind11::init([](const pybind11::kwargs& attributes) {
        Struct value;
        const pybind11::object view = pybind11::cast(&value, pybind11::return_value_policy::reference);
        for (const auto& [name, attribute] : attributes) {
            if (!pybind11::hasattr(view, name)) {
                throw pybind11::type_error("unexpected keyword argument '" + pybind11::cast<std::string>(name) + "'");
            }
            pybind11::setattr(view, name, attribute);
        }
        return value;
    }));
}

}  // namespace etendue::python
