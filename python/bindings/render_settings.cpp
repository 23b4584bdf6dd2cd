#include <etendue/render_settings.h>

#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {
namespace {

void bind_enums(py::module_& module) {
    py::enum_<IntegratorKind>(module, "IntegratorKind")
        .value("Path", IntegratorKind::Path)
        .value("Light", IntegratorKind::Light)
        .value("Bdpt", IntegratorKind::Bdpt)
        .value("Auto", IntegratorKind::Auto);
    py::enum_<MisHeuristic>(module, "MisHeuristic")
        .value("Balance", MisHeuristic::Balance)
        .value("Power", MisHeuristic::Power);
    py::enum_<Aov>(module, "Aov")
        .value("Color", Aov::Color)
        .value("Alpha", Aov::Alpha)
        .value("Depth", Aov::Depth)
        .value("Normal", Aov::Normal)
        .value("Albedo", Aov::Albedo)
        .value("SampleCount", Aov::SampleCount)
        .value("Variance", Aov::Variance);
    py::enum_<FilterKind>(module, "FilterKind")
        .value("Box", FilterKind::Box)
        .value("Triangle", FilterKind::Triangle)
        .value("Gaussian", FilterKind::Gaussian);
}

void bind_parts(py::module_& module) {
    py::class_<AdjointPolicy> adjoint(module, "AdjointPolicy");
    adjoint.def_readwrite("refraction", &AdjointPolicy::refraction)
        .def_readwrite("shading_normal", &AdjointPolicy::shading_normal)
        .def_readwrite("phong", &AdjointPolicy::phong);
    def_keyword_constructor<AdjointPolicy>(adjoint);

    py::class_<StrategySet> strategies(module, "StrategySet");
    strategies.def_readwrite("emission_hit", &StrategySet::emission_hit)
        .def_readwrite("direct_light", &StrategySet::direct_light)
        .def_readwrite("connection", &StrategySet::connection)
        .def_readwrite("light_image", &StrategySet::light_image)
        .def_readwrite("lens_hit", &StrategySet::lens_hit);
    def_keyword_constructor<StrategySet>(strategies);

    py::class_<ChosenMethod>(module, "ChosenMethod")
        .def_readonly("integrator", &ChosenMethod::integrator)
        .def_readonly("light_paths_per_pixel", &ChosenMethod::light_paths_per_pixel);

    py::class_<Strategy> strategy(module, "Strategy");
    strategy.def_readwrite("s", &Strategy::s).def_readwrite("t", &Strategy::t);
    def_keyword_constructor<Strategy>(strategy);

    py::class_<PixelFilter> filter(module, "PixelFilter");
    filter.def_readwrite("kind", &PixelFilter::kind).def_readwrite("radius", &PixelFilter::radius);
    def_keyword_constructor<PixelFilter>(filter);

    py::class_<PixelWindow> window(module, "PixelWindow");
    window.def_readwrite("x0", &PixelWindow::x0)
        .def_readwrite("y0", &PixelWindow::y0)
        .def_readwrite("x1", &PixelWindow::x1)
        .def_readwrite("y1", &PixelWindow::y1);
    def_keyword_constructor<PixelWindow>(window);
}

}  // namespace

void bind_render_settings(py::module_& module) {
    bind_enums(module);
    bind_parts(module);

    py::class_<RenderSettings> settings(module, "RenderSettings");
    settings.def_readwrite("camera", &RenderSettings::camera)
        .def_readwrite("width", &RenderSettings::width)
        .def_readwrite("height", &RenderSettings::height)
        .def_readwrite("crop", &RenderSettings::crop)
        .def_readwrite("conform", &RenderSettings::conform)
        .def_readwrite("integrator", &RenderSettings::integrator)
        .def_readwrite("samples_per_pixel", &RenderSettings::samples_per_pixel)
        .def_readwrite("time_limit", &RenderSettings::time_limit)
        .def_readwrite("error_target", &RenderSettings::error_target)
        .def_readwrite("adaptive", &RenderSettings::adaptive)
        .def_readwrite("max_depth", &RenderSettings::max_depth)
        .def_readwrite("seed", &RenderSettings::seed)
        .def_readwrite("threads", &RenderSettings::threads)
        .def_readwrite("texture_memory", &RenderSettings::texture_memory)
        .def_readwrite("filter", &RenderSettings::filter)
        .def_readwrite("heuristic", &RenderSettings::heuristic)
        .def_readwrite("strategies", &RenderSettings::strategies)
        .def_readwrite("single_strategy", &RenderSettings::single_strategy)
        .def_readwrite("light_paths_per_pixel", &RenderSettings::light_paths_per_pixel)
        .def_readwrite("roulette_depth", &RenderSettings::roulette_depth)
        .def_readwrite("adjoint", &RenderSettings::adjoint)
        .def_readwrite("aovs", &RenderSettings::aovs)
        .def_readwrite("strategy_images", &RenderSettings::strategy_images);
    def_keyword_constructor<RenderSettings>(settings);
}

}  // namespace etendue::python
