#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace etendue::test {

/// What became of a scene.
struct Outcome {
    bool rendered = true;
    std::string refusal;  ///< what the library said, if it was not
};

/// Something does not hold.
class Finding : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace etendue::test
