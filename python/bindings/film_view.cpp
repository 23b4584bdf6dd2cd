#include <etendue/film_view.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {
namespace {

/// A new array (h, w, channels), or (h, w) for one channel; it owns its memory.
py::array_t<float> new_array(const RenderedImage& image, int channels, const std::vector<float>& data) {
    std::vector<py::ssize_t> shape{image.height, image.width};
    if (channels != 1) shape.push_back(channels);
    py::array_t<float> array(shape);
    if (array.size() != static_cast<py::ssize_t>(data.size())) {
        throw std::logic_error("the AOV's size does not match the image's");
    }
    std::copy(data.begin(), data.end(), array.mutable_data());
    return array;
}

/// KeyError when the AOV is absent.
py::array_t<float> aov_array(const RenderedImage& image, Aov aov) {
    const AovImage* found = image.find(aov);
    if (!found) throw py::key_error(std::string(aov_name(aov)));
    return new_array(image, found->channels, found->data);
}

/// KeyError when there is none of that name.
py::array_t<float> strategy_array(const RenderedImage& image, const std::string& name) {
    for (const StrategyImage& strategy : image.strategy_images) {
        if (strategy_image_name(strategy) == name) return new_array(image, 3, strategy.data);
    }
    throw py::key_error(name);
}

std::vector<std::string> strategy_images_of(const RenderedImage& image) {
    std::vector<std::string> names;
    for (const StrategyImage& strategy : image.strategy_images) names.push_back(strategy_image_name(strategy));
    return names;
}

std::vector<Aov> aovs_of(const RenderedImage& image) {
    std::vector<Aov> aovs;
    for (const AovImage& aov : image.aovs) aovs.push_back(aov.aov);
    return aovs;
}

}  // namespace

void bind_film_view(py::module_& module) {
    module.def("aov_name", &aov_name, py::arg("aov"));
    module.def("aov_channels", &aov_channels, py::arg("aov"));
    module.attr("DARKEST_PART") = kDarkestPart;

    py::class_<RenderStatistics>(module, "RenderStatistics")
        .def_readonly("passes", &RenderStatistics::passes)
        .def_readonly("seconds", &RenderStatistics::seconds)
        .def_readonly("error", &RenderStatistics::error)
        .def_readonly("chosen", &RenderStatistics::chosen)
        .def_readonly("camera_paths", &RenderStatistics::camera_paths)
        .def_readonly("light_paths", &RenderStatistics::light_paths)
        .def_readonly("rays", &RenderStatistics::rays)
        .def_property_readonly("invalid", [](const RenderStatistics& self) {
            py::dict counts;
            counts["nan"] = self.invalid[static_cast<std::size_t>(InvalidKind::NotANumber)];
            counts["infinite"] = self.invalid[static_cast<std::size_t>(InvalidKind::Infinite)];
            counts["negative"] = self.invalid[static_cast<std::size_t>(InvalidKind::Negative)];
            return counts;
        });

    py::class_<RenderedImage>(module, "RenderedImage")
        .def_readonly("width", &RenderedImage::width)
        .def_readonly("height", &RenderedImage::height)
        .def_readonly("window", &RenderedImage::window)
        .def_readonly("full_width", &RenderedImage::full_width)
        .def_readonly("full_height", &RenderedImage::full_height)
        .def_readonly("statistics", &RenderedImage::statistics)
        .def_property_readonly("aovs", &aovs_of)
        .def("array", &aov_array, py::arg("aov"))
        .def_property_readonly("strategy_images", &strategy_images_of)
        .def("strategy_array", &strategy_array, py::arg("name"));
}

}  // namespace etendue::python
