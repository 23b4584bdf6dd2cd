#pragma once

#include <mutex>
#include <set>

#include "renderer.h"

namespace etendue::hydra {

/// The renderers of all render passes, for what a host asks of the delegate as a whole.
class Renderers {
public:
    void add(Renderer& renderer) {
        const std::lock_guard lock(mutex_);
        all_.insert(&renderer);
    }
    void remove(Renderer& renderer) {
        const std::lock_guard lock(mutex_);
        all_.erase(&renderer);
    }
    template <class Function>
    void for_each(const Function& function) {
        const std::lock_guard lock(mutex_);
        for (Renderer* const renderer : all_) function(*renderer);
    }

private:
    std::mutex mutex_;
    std::set<Renderer*> all_;
};

}  // namespace etendue::hydra
