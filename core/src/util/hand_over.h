#pragma once

#include <atomic>

namespace etendue {

/// What happens before give() has happened after take(). TBB sees to that by itself; this tells the thread sanitizer,
/// which cannot look into TBB's library, and is nothing in other builds.
class HandOver {
public:
#if defined(__SANITIZE_THREAD__)
    void give() { given_.fetch_add(1, std::memory_order_release); }
    void take() const { (void)given_.load(std::memory_order_acquire); }

private:
    std::atomic<int> given_{0};
#else
    void give() {}
    void take() const {}
#endif
};

}  // namespace etendue
