#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace etendue {

/// The inside of a material; 0 is the outside of everything.
using MediumId = std::uint16_t;

/// The bodies that a point lies in, the innermost first. Bodies may lie in one another, four deep; of more the
/// outermost are forgotten. They need to be closed, or closed off by what lets no light through.
class Media {
public:
    [[nodiscard]] MediumId innermost() const { return ids_[0]; }

    void enter(MediumId id) {
        std::shift_right(ids_.begin(), ids_.end(), 1);
        ids_[0] = id;
    }
    /// Does nothing when the point does not lie in such a body.
    void leave(MediumId id) {
        const auto found = std::find(ids_.begin(), ids_.end(), id);
        if (found == ids_.end()) return;
        std::shift_left(found, ids_.end(), 1);
        ids_.back() = 0;
    }

    bool operator==(const Media&) const = default;

private:
    std::array<MediumId, 4> ids_{};
};

}  // namespace etendue
