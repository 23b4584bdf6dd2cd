#include "delegate_library.h"

#include <dlfcn.h>

namespace etendue::hydra {
namespace {

constexpr const char* kFile = "hdEtendueDelegate.so";  ///< beside the library that this is in

/// Empty when the system does not know.
std::string own_directory() {
    Dl_info info{};
    if (::dladdr(reinterpret_cast<const void*>(&delegate_library), &info) == 0 || info.dli_fname == nullptr) return {};
    const std::string file = info.dli_fname;
    return file.substr(0, file.rfind('/') + 1);
}

int open_flags() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return RTLD_NOW | RTLD_LOCAL;  // sanitizers refuse the other flag, which would hide their allocator
#else
    return RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND;
#endif
}

template <class Function>
void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
}

DelegateLibrary open() {
    DelegateLibrary out;
    void* const library = ::dlopen((own_directory() + kFile).c_str(), open_flags());
    if (library != nullptr) {
        find(library, "etendue_hydra_create", out.create);
        find(library, "etendue_hydra_delete", out.destroy);
    }
    if (out.create == nullptr || out.destroy == nullptr) {
        const char* const reason = ::dlerror();
        out.complaint = std::string("the render delegate cannot be loaded: ") + (reason ? reason : "unknown reason");
    }
    return out;
}

}  // namespace

const DelegateLibrary& delegate_library() {
    static const DelegateLibrary library = open();
    return library;
}

}  // namespace etendue::hydra
