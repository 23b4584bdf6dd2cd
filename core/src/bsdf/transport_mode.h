#pragma once

namespace etendue {

/// What a subpath carries. Camera subpaths gather Radiance: wo is where light goes, wi is sampled towards where it
/// comes from. Light subpaths carry particles (Importance): wo is where they come from, wi is sampled (theory.md §4).
enum class TransportMode { Radiance, Importance };

constexpr TransportMode opposite(TransportMode mode) {
    return mode == TransportMode::Radiance ? TransportMode::Importance : TransportMode::Radiance;
}

}  // namespace etendue
