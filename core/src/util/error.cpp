#include <etendue/error.h>

namespace etendue {

// Out of line, so that each class has one type_info: exceptions are caught by type across library boundaries.
Error::~Error() = default;
SceneError::~SceneError() = default;
SettingsError::~SettingsError() = default;
FileError::~FileError() = default;

}  // namespace etendue
