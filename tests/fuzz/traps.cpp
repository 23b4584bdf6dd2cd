#include "fuzz/traps.h"

#include <cfenv>

namespace etendue::test {

InvalidTraps::InvalidTraps(bool on) : before_(fegetexcept()) {
    // What was raised unseen would be delivered at once.
    feclearexcept(FE_ALL_EXCEPT);
    if (on) {
        feenableexcept(FE_INVALID);
    } else {
        fedisableexcept(FE_INVALID);
    }
}

InvalidTraps::~InvalidTraps() {
    feclearexcept(FE_ALL_EXCEPT);
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
}

}  // namespace etendue::test
