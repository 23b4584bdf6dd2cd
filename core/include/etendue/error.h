#pragma once

#include <stdexcept>
#include <string>

#include <etendue/export.h>

namespace etendue {

/// Base of everything the library throws on purpose. The message names the file or prim at fault.
class ETENDUE_EXPORT Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~Error() override;
};

/// The scene cannot be rendered as described (bad indices, no camera, non-finite points, ...).
class ETENDUE_EXPORT SceneError : public Error {
public:
    using Error::Error;
    ~SceneError() override;
};

/// The render settings contradict themselves or the scene.
class ETENDUE_EXPORT SettingsError : public Error {
public:
    using Error::Error;
    ~SettingsError() override;
};

/// A file could not be read or written (texture, image, OCIO config).
class ETENDUE_EXPORT FileError : public Error {
public:
    using Error::Error;
    ~FileError() override;
};

}  // namespace etendue
