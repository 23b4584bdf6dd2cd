#pragma once

#include <etendue/render_settings.h>

namespace etendue {

/// x^beta of the balance (1) or power (2) heuristic (theory.md §3; Veach 9.2).
class Heuristic {
public:
    explicit Heuristic(MisHeuristic kind) : squares_(kind == MisHeuristic::Power) {}
    [[nodiscard]] double operator()(double x) const { return squares_ ? x * x : x; }

private:
    bool squares_;
};

}  // namespace etendue
