#include "fuzz/run_trial.h"

#include <memory>
#include <string>

#include <etendue/error.h>
#include <etendue/render_session.h>

#include "fuzz/check_picture.h"
#include "fuzz/traps.h"

namespace etendue::test {
namespace {

using Session = std::unique_ptr<RenderSession>;

/// Null when the library refuses, which `outcome` then tells. Only its own exceptions are no finding, and those must
/// say whom they blame.
Session make_session(const Trial& trial, const RenderSession* before, Outcome& outcome) {
    try {
        return std::make_unique<RenderSession>(trial.scene, trial.settings, ProgressCallback{}, before);
    } catch (const SettingsError& error) {
        outcome = {false, error.what()};
    } catch (const Error& error) {
        outcome = {false, error.what()};
        if (outcome.refusal.find(kPrimPrefix) == std::string::npos) {
            throw Finding("an error that names no prim: " + outcome.refusal);
        }
    }
    return {};
}

void pick_somewhere(const Trial& trial, const RenderSession& session, Dice& dice) {
    const double x = dice.between(-1.0, 1.0 + trial.settings.width);
    const double y = dice.between(-1.0, 1.0 + trial.settings.height);
    const auto picked = session.pick(x, y);
    if (picked && (picked->shape >= static_cast<int>(trial.scene.shapes.size() + 99) || picked->triangle < 0)) {
        throw Finding("picked a shape that is not there");
    }
}

void disturb(RenderSession& session, Dice& dice) {
    const bool paused = dice.chance(0.5);
    if (paused) session.set_paused(true);
    (void)session.wait_for(dice.log_between(1e-5, 3e-3));
    (void)session.snapshot();
    if (paused && dice.chance(0.5)) session.set_paused(false);
    session.cancel();
}

void check_threads(const Trial& trial, const RenderedImage& image) {
    Trial other = trial;
    other.settings.threads = 3 - trial.settings.threads;
    Outcome outcome;
    const Session session = make_session(other, nullptr, outcome);
    if (!session) throw Finding("refused with another number of threads: " + outcome.refusal);
    session->start();
    session->wait();
    check_same(image, session->snapshot());
}

void take_over(const Trial& trial, const RenderSession& before, Dice& dice) {
    Trial edited = trial;
    edited.radiance.reset();
    edit(dice, edited.scene);
    Outcome outcome;
    const Session session = make_session(edited, &before, outcome);
    if (!session) return;
    session->start();
    session->wait();
    const RenderedImage image = session->snapshot();
    check_picture(image, edited);
    const Session fresh = make_session(edited, nullptr, outcome);
    fresh->start();
    fresh->wait();
    check_same(image, fresh->snapshot());
}

}  // namespace

Outcome run_trial(const Trial& trial, Dice& dice) {
    const InvalidTraps traps(!trial.hostile);
    Outcome outcome;
    const Session session = make_session(trial, nullptr, outcome);
    if (!session) return outcome;
    if (dice.chance(0.2)) pick_somewhere(trial, *session, dice);
    session->start();
    const bool disturbed = dice.chance(0.05);
    if (disturbed) disturb(*session, dice);
    const bool takes_over = dice.chance(0.1);
    if (takes_over && dice.chance(0.5)) take_over(trial, *session, dice);
    session->wait();
    const RenderedImage image = session->snapshot();
    check_picture(image, trial);
    if (takes_over) take_over(trial, *session, dice);
    if (!disturbed && dice.chance(0.15)) check_threads(trial, image);
    return outcome;
}

}  // namespace etendue::test
