#include <etendue/requirements.h>

#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {

void bind_requirements(py::module_& module) {
    py::enum_<CoordinateUse>(module, "CoordinateUse")
        .value("Unused", CoordinateUse::Unused)
        .value("Lookup", CoordinateUse::Lookup)
        .value("Tangents", CoordinateUse::Tangents);

    py::class_<LobeSet>(module, "LobeSet")
        .def_readonly("diffuse", &LobeSet::diffuse)
        .def_readonly("smooth_reflection", &LobeSet::smooth_reflection)
        .def_readonly("rough_reflection", &LobeSet::rough_reflection)
        .def_readonly("smooth_transmission", &LobeSet::smooth_transmission)
        .def_readonly("rough_transmission", &LobeSet::rough_transmission)
        .def_readonly("cutout", &LobeSet::cutout);

    py::class_<LightSet>(module, "LightSet")
        .def_readonly("areas", &LightSet::areas)
        .def_readonly("emitting_surfaces", &LightSet::emitting_surfaces)
        .def_readonly("points", &LightSet::points)
        .def_readonly("suns", &LightSet::suns)
        .def_readonly("domes", &LightSet::domes);

    py::class_<Requirements>(module, "Requirements")
        .def_readonly("materials", &Requirements::materials)
        .def_readonly("textures", &Requirements::textures)
        .def_readonly("texture_coordinates", &Requirements::texture_coordinates)
        .def_readonly("lobes", &Requirements::lobes)
        .def_readonly("lights", &Requirements::lights)
        .def_readonly("strategies", &Requirements::strategies)
        .def_readonly("light_paths", &Requirements::light_paths)
        .def_readonly("thin_lens", &Requirements::thin_lens)
        .def_readonly("absorption", &Requirements::absorption)
        .def_readonly("instances", &Requirements::instances)
        .def_readonly("normals", &Requirements::normals)
        .def_readonly("normal_maps", &Requirements::normal_maps)
        .def_readonly("first_surface", &Requirements::first_surface)
        .def_readonly("replicates", &Requirements::replicates)
        .def_readonly("aovs", &Requirements::aovs);
    module.def("find_requirements", &find_requirements, py::arg("scene"), py::arg("settings"));

    py::class_<MemoryUse>(module, "MemoryUse")
        .def_readonly("vertices", &MemoryUse::vertices)
        .def_readonly("acceleration", &MemoryUse::acceleration)
        .def_readonly("lights", &MemoryUse::lights)
        .def_readonly("textures", &MemoryUse::textures)
        .def_readonly("textures_limit", &MemoryUse::textures_limit)
        .def_readonly("film", &MemoryUse::film);
}

}  // namespace etendue::python
