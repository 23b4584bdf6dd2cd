#pragma once

#include <atomic>
#include <mutex>
#include <set>

#include "renderer.h"

namespace etendue::hydra {

/// The renderers of all render passes, for what a host asks of the delegate as a whole.
class Renderers {
public:
    void add(Renderer& renderer) {
        const std::lock_guard lock(mutex_);
        renderer.set_paused(paused_);
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

    /// Holds them all, those that come later, too, or lets them go on.
    void set_paused(bool paused) {
        const std::lock_guard lock(mutex_);
        paused_ = paused;
        for (Renderer* const renderer : all_) renderer->set_paused(paused);
    }
    [[nodiscard]] bool is_paused() const { return paused_; }

private:
    std::mutex mutex_;
    std::atomic<bool> paused_{false};
    std::set<Renderer*> all_;
};

}  // namespace etendue::hydra
