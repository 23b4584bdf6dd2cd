// What pixels show, asked for as hosts ask: through the render buffers of the identifiers. Python's engine does not
// give these out, so that picking.py loads this library into the host's process.

#include <cstdio>
#include <cstdlib>

#include <pxr/base/gf/vec2i.h>
#include <pxr/imaging/hd/renderBuffer.h>
#include <pxr/imaging/hd/tokens.h>
#include <pxr/usd/usd/prim.h>
#include <pxr/usd/usd/stage.h>
#include <pxr/usdImaging/usdImagingGL/engine.h>

PXR_NAMESPACE_USING_DIRECTIVE

namespace {

const TfToken kNames[] = {HdAovTokens->primId, HdAovTokens->instanceId, HdAovTokens->elementId};

/// Row 0 on top.
int value(const UsdImagingGLEngine& engine, const TfToken& name, int x, int y) {
    HdRenderBuffer* const buffer = engine.GetAovRenderBuffer(name);
    if (buffer == nullptr || buffer->GetFormat() != HdFormatInt32) {
        std::fprintf(stderr, "there is no buffer of %s\n", name.GetText());
        std::exit(1);
    }
    const auto* const values = static_cast<const int*>(buffer->Map());
    const auto row = buffer->GetHeight() - 1 - static_cast<unsigned int>(y);
    const int found = values[row * buffer->GetWidth() + static_cast<unsigned int>(x)];
    buffer->Unmap();
    return found;
}

}  // namespace

/// Renders a stage and prints, for each of `count` pixels (x, y; row 0 on top), the prim, the number of its instance
/// and its face; "nothing" where there is none.
extern "C" __attribute__((visibility("default"))) void print_picked(const char* file, const char* camera, int width,
                                                                    int height, const int* pixels, int count);

void print_picked(const char* file, const char* camera, int width, int height, const int* pixels, int count) {
    const UsdStageRefPtr stage = UsdStage::Open(file);
    UsdImagingGLEngine::Parameters parameters;
    parameters.gpuEnabled = false;
    parameters.rendererPluginId = TfToken("HdEtendueRendererPlugin");
    UsdImagingGLEngine engine(parameters);
    engine.SetRendererAovs({HdAovTokens->color, kNames[0], kNames[1], kNames[2]});
    engine.SetCameraPath(SdfPath(camera));
    engine.SetRenderBufferSize(GfVec2i(width, height));
    engine.SetFraming(CameraUtilFraming(GfRect2i(GfVec2i(0), width, height)));
    do {
        engine.Render(stage->GetPseudoRoot(), UsdImagingGLRenderParams());
    } while (!engine.IsConverged());
    for (int i = 0; i < count; ++i) {
        int ids[3];
        for (int k = 0; k < 3; ++k) ids[k] = value(engine, kNames[k], pixels[2 * i], pixels[2 * i + 1]);
        SdfPath path;
        int instance = -1;
        if (engine.DecodeIntersection(ids[0], ids[1], &path, nullptr, &instance)) {
            std::printf("%s %d %d\n", path.GetText(), instance, ids[2]);
        } else {
            std::printf("nothing %d %d\n", ids[1], ids[2]);
        }
    }
    std::fflush(stdout);
}
