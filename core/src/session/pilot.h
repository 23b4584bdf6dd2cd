#pragma once

#include <atomic>
#include <deque>
#include <vector>

#include "integrator/render_context.h"
#include "session/method_choice.h"

namespace etendue {

/// For a pilot of that render: a small picture of the same view, made of other samples.
[[nodiscard]] RenderSettings pilot_settings(const RenderSettings& settings);

/// Tries methods, and measures what they cost. Work is counted, not timed, so that choices do not depend on the
/// machine's mood, and pilots' samples are thrown away: a picture that consisted of those by which its method was
/// chosen would be off to the side that looks good.
class Pilot {
public:
    /// Both have to live as long as it does; the settings are pilot_settings(). A pilot that `stop` ends says anything.
    /// `strategies`: of Requirements.
    Pilot(const Scene& scene, const Camera& camera, const RenderSettings& settings, const StrategySet& strategies,
          const std::atomic<bool>& stop);

    /// As MethodCost has it.
    [[nodiscard]] double cost(const ChosenMethod& method);
    /// A power of two of light paths with which a pass of so many pixels is no more work than that, in rays.
    [[nodiscard]] double most_light_paths(double pixels, double work);

private:
    /// A picture of a method, by pixel; values are means over channels.
    struct Trial {
        ChosenMethod method;
        std::vector<double> mean;
        std::vector<double> variance;  ///< of one pass
        double noise = 0;              ///< its mean over pixels
        double work = 0;               ///< of one pass
    };

    [[nodiscard]] const Trial& trial(const ChosenMethod& method);
    [[nodiscard]] Trial render(const ChosenMethod& method) const;
    [[nodiscard]] std::vector<double> brightness() const;
    [[nodiscard]] double relative_error(const std::vector<double>& variance, double left_out) const;
    [[nodiscard]] double rare_error();
    [[nodiscard]] RenderSettings settings_of(const ChosenMethod& method) const;
    [[nodiscard]] RenderContext context(const RenderSettings& settings) const;

    const Scene& scene_;
    const Camera& camera_;
    RenderSettings settings_;
    StrategySet strategies_;
    const std::atomic<bool>& stop_;
    std::deque<Trial> trials_;
};

/// What IntegratorKind::Auto renders the scene with. By a pilot, `camera` being that of pilot_settings(), where the
/// render is so long that its time does not count; this is told by the limits, not by the speed: the same settings do
/// the same on any machine. Else by what the scene holds alone.
[[nodiscard]] ChosenMethod choose_method(const RenderSettings& settings, const Scene& scene, const Camera& camera,
                                         const StrategySet& strategies, const std::atomic<bool>& stop);

}  // namespace etendue
