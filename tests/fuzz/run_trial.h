#pragma once

#include "fuzz/outcome.h"
#include "fuzz/trial.h"

namespace etendue::test {

/// Renders the trial, and at times cancels, holds, picks, takes over with an edited scene, or renders again with
/// another number of threads. Throws a Finding when something does not hold.
Outcome run_trial(const Trial& trial, Dice& dice);

}  // namespace etendue::test
