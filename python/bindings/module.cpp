#include "bindings.h"

PYBIND11_MODULE(_core, module) {
    namespace bindings = etendue::python;
    module.doc() = "The renderer's core: scene description, settings, sessions, images.";
    bindings::bind_version(module);
    bindings::bind_error(module);
    bindings::bind_scene_description(module);
    bindings::bind_render_settings(module);
    bindings::bind_requirements(module);
    bindings::bind_film_view(module);
    bindings::bind_render_session(module);
    bindings::bind_display(module);
    bindings::bind_image_io(module);
}
