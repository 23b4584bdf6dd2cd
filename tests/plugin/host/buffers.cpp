// Colour in every format that hosts ask for. usdImagingGL asks for the delegate's default alone; this is a host of its
// own, in the same library as picking.cpp.

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include <pxr/base/gf/rect2i.h>
#include <pxr/base/gf/vec2i.h>
#include <pxr/imaging/hd/engine.h>
#include <pxr/imaging/hd/pluginRenderDelegateUniqueHandle.h>
#include <pxr/imaging/hd/renderBuffer.h>
#include <pxr/imaging/hd/renderIndex.h>
#include <pxr/imaging/hd/rendererPluginRegistry.h>
#include <pxr/imaging/hd/tokens.h>
#include <pxr/imaging/hdx/taskController.h>
#include <pxr/usd/usd/prim.h>
#include <pxr/usd/usd/stage.h>
#include <pxr/usdImaging/usdImaging/delegate.h>

PXR_NAMESPACE_USING_DIRECTIVE

namespace {

const SdfPath kScene("/scene");
const SdfPath kTasks("/tasks");

/// By the names that the file of each gets.
const std::map<std::string, HdFormat> kFormats{
    {"UNorm8", HdFormatUNorm8},           {"UNorm8Vec3", HdFormatUNorm8Vec3},   {"UNorm8Vec4", HdFormatUNorm8Vec4},
    {"SNorm8Vec4", HdFormatSNorm8Vec4},   {"Float16", HdFormatFloat16},         {"Float16Vec3", HdFormatFloat16Vec3},
    {"Float16Vec4", HdFormatFloat16Vec4}, {"Float32", HdFormatFloat32},         {"Float32Vec2", HdFormatFloat32Vec2},
    {"Float32Vec3", HdFormatFloat32Vec3}, {"Float32Vec4", HdFormatFloat32Vec4}, {"Int32", HdFormatInt32}};

void write_pixels(HdRenderBuffer* buffer, HdFormat format, const std::string& file) {
    if (buffer == nullptr || buffer->GetFormat() != format) {
        std::fprintf(stderr, "there is no buffer for %s\n", file.c_str());
        std::exit(1);
    }
    const std::size_t size = HdDataSizeOfFormat(format) * buffer->GetWidth() * buffer->GetHeight();
    std::ofstream(file, std::ios::binary)
        .write(static_cast<const char*>(buffer->Map()), static_cast<std::streamsize>(size));
    buffer->Unmap();
}

void render(const UsdStageRefPtr& stage, const char* camera, const GfVec2i& size, HdFormat format,
            const std::string& file) {
    const HdPluginRenderDelegateUniqueHandle delegate =
        HdRendererPluginRegistry::GetInstance().CreateRenderDelegate(TfToken("HdEtendueRendererPlugin"));
    const std::unique_ptr<HdRenderIndex> index(HdRenderIndex::New(delegate.Get(), {}));
    UsdImagingDelegate scene(index.get(), kScene);
    scene.Populate(stage->GetPseudoRoot());
    HdxTaskController tasks(index.get(), kTasks, false);
    tasks.SetRenderOutputs({HdAovTokens->color});
    tasks.SetRenderOutputSettings(HdAovTokens->color, HdAovDescriptor(format, false, VtValue(GfVec4f(0))));
    tasks.SetCameraPath(kScene.AppendPath(SdfPath(camera).MakeRelativePath(SdfPath::AbsoluteRootPath())));
    tasks.SetRenderBufferSize(size);
    tasks.SetFraming(CameraUtilFraming(GfRect2i(GfVec2i(0), size[0], size[1])));
    HdEngine engine;
    do {
        HdTaskSharedPtrVector all = tasks.GetRenderingTasks();
        engine.Execute(index.get(), &all);
    } while (!tasks.IsConverged());
    write_pixels(tasks.GetRenderOutput(HdAovTokens->color), format, file);
}

}  // namespace

/// Renders a stage once for each of kFormats and writes what the host sees, as it lies in memory (row 0 at the bottom),
/// to the directory, files <format>.raw.
extern "C" __attribute__((visibility("default"))) void write_buffers(const char* file, const char* camera, int width,
                                                                     int height, const char* directory);

void write_buffers(const char* file, const char* camera, int width, int height, const char* directory) {
    const UsdStageRefPtr stage = UsdStage::Open(file);
    for (const auto& [name, format] : kFormats) {
        render(stage, camera, GfVec2i(width, height), format, std::string(directory) + "/" + name + ".raw");
    }
}
