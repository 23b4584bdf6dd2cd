"""What was found, in words that the page, the files and the terminal share."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf, isfinite, sqrt

from etendue import _core
from etendue.interval import interval_text
from etendue.numbers import counted, percent, short
from etendue.tradeoff.candidates import DEFAULT
from etendue.tradeoff.results import CandidateResult, Choice, TradeoffResult, is_known

#: Part of a candidate's own error from which on the reference's noise is too much to subtract.
_TOO_NOISY = 0.5

_DEFAULTS = _core.RenderSettings()


def efficiency_text(found: CandidateResult) -> str:
    """Over that of the best."""
    relative = found.relative_efficiency
    if not isfinite(relative.value):
        return "unknown"
    if relative.low > 1 - 1e-4 and relative.high < 1 + 1e-4:
        return "1, the best"
    return "below 0.01" if relative.value < 0.01 else interval_text(relative)


def error_percent(rel_mse: float) -> str:
    """The root of it: the error as a share of the brightness."""
    if not rel_mse > 0:
        return "none seen"
    return percent(sqrt(rel_mse)) if rel_mse < 100 else "over 1,000 %"


def seconds_text(seconds: float) -> str:
    """'0.3 s', '10 s', '2.7 min', '2.7 h'."""
    if seconds < 120:
        return f"{seconds:.3g} s"
    value, unit = (seconds / 60, "min") if seconds < 2 * 3600 else (seconds / 3600, "h")
    return f"{value:.1f}".removesuffix(".0") + f" {unit}"


def verdict_sentence(found: CandidateResult) -> str:
    """Whether it gets there, and what is missing where it does not."""
    if found.verdict == "floor":
        return f"{_floor(found)} {_brightness(found)}{found.candidate.if_short}"
    if found.verdict == "converges" and not found.hidden_floor > 0:
        return "Converges to the reference: not any difference is seen."
    if found.verdict == "converges":
        return (
            "Converges to the reference as far as can be told: what no time would remove is less "
            f"than {error_percent(found.hidden_floor)}."
        )
    if found.fireflies:
        return (
            "Cannot be told: bright specks are most of its error. They are light that its paths "
            "hardly ever find, and most pixels have not met it yet. Until they have, which may "
            f"take for ever, they are too dark. {found.candidate.if_short}"
        )
    if isfinite(found.floor_p_value):
        hidden = error_percent(found.hidden_floor)
        return f"Cannot be told: noise would hide an error of {hidden} that no time removes."
    return "Whether it converges cannot be told: how noisy the reference is is not known."


def _floor(found: CandidateResult) -> str:
    floor = found.floor
    ends = f"{error_percent(max(floor.low, 0.0))} to {error_percent(floor.high)}"
    return (
        f"Does not converge to the reference: {error_percent(floor.value)} of error ({ends}) stays "
        "however long it renders."
    )


def _brightness(found: CandidateResult) -> str:
    brightness = found.brightness
    if not is_known(brightness) or brightness.low <= 1 <= brightness.high:
        return ""
    return f"Its picture has {percent(brightness.value)} of the reference's light. "


def slope_sentence(found: CandidateResult) -> str:
    """What the line does."""
    slope = found.slope
    if not found.error_seen:
        return "There is no line: what it is off by is not seen."
    if found.verdict == "floor":
        return f"Bends towards flat: at its end the slope is {found.end_slope:.2f}."
    if not is_known(slope) or slope.high - slope.low > 0.5:
        return "Too noisy to tell its slope."
    if slope.low > -0.95:
        return "Flatter than noise alone makes it: more time helps less than it should."
    if slope.high < -1.05:
        return "Steeper than independent samples make it: they are spread evenly."
    return "As straight as noise makes it: twice the time, half the squared error."


def choice_sentence(result: TradeoffResult, choice: Choice) -> str:
    """Why that one."""
    best = result[choice.best]
    parts = [f"{best.candidate.what}."]
    if not choice.rel_mse.value > 0:
        parts.append("Its error is not seen, so nothing tells it from others.")
    if choice.best == DEFAULT:
        parts.append("This is the default.")
    elif DEFAULT in choice.as_good:
        parts.append("The default is as good, as far as can be told.")
    elif longer := default_sentence(result, choice):
        parts.append(longer)
    if best.verdict == "floor":
        left = error_percent(best.floor.value)
        parts.append(f"Of the error, {left} would stay for ever; noise is still more than that.")
    sooner = _doubted(result, choice)
    if sooner is not None:
        parts.append(
            f"{sooner.name} has less noise, but need not find all light: it may lack "
            f"{error_percent(sooner.hidden_floor)} for ever, as far as was measured."
        )
    told = (DEFAULT, sooner.name if sooner is not None else "")
    others = [name for name in choice.as_good if name not in told]
    if others:
        parts.append(f"As good, as far as can be told: {', '.join(others)}.")
    return " ".join(parts)


def default_sentence(result: TradeoffResult, choice: Choice) -> str:
    """How much longer the default takes for what the choice gives, or why it was not chosen; empty
    where it was not measured, never gets there, or is not slower."""
    if DEFAULT not in {found.name for found in result.candidates}:
        return ""
    if result[DEFAULT].fireflies:
        return "The default's figures rest on a few bright pixels, and are not compared."
    curve = result[DEFAULT].curve
    noise = choice.rel_mse.value - curve.floor
    if not noise > 0:
        return ""
    times = curve.noise.value / noise / choice.seconds
    if not 1 < times < inf:
        return ""
    return f"The default takes {times:.2g} times as long for the same error."


def _doubted(result: TradeoffResult, choice: Choice) -> CandidateResult | None:
    """What would be best, if it were sure to converge."""
    best = result[choice.best]
    quieter = [
        found
        for found in result.candidates
        if found.verdict == "converges"
        and not found.candidate.complete
        and found.curve.noise.value < best.curve.noise.value
    ]
    return min(quieter, key=lambda found: found.curve.noise.value, default=None)


def headline(result: TradeoffResult) -> str:
    """One line: what to render with."""
    told = _best(result)
    if not result.interrupted:
        return told
    left = len(result.not_run)
    lost = f", {counted(left, 'candidate')} not measured" if left else ""
    return f"{told}; interrupted after {counted(result.seeds, 'round')}{lost}"


def _best(result: TradeoffResult) -> str:
    choice = longest_choice(result)
    if choice is None:
        return "Nothing finishes a picture in the times looked at"
    if not choice.rel_mse.value > 0:
        return f"No error is seen of {choice.best}: nothing here tells how good it is"
    name = f"the default, {DEFAULT}" if choice.best == DEFAULT else choice.best
    error = error_percent(choice.rel_mse.value)
    return f"Best here is {name}: {error} of error after {seconds_text(choice.seconds)}"


def longest_choice(result: TradeoffResult) -> Choice | None:
    """Of those that were measured, else the shortest; None where there is none."""
    measured = [choice for choice in result.choices if not choice.extrapolated]
    return measured[-1] if measured else next(iter(result.choices), None)


def size_factor(result: TradeoffResult) -> float:
    """Pixels that the stage asks for, over those measured; 1 where it is about as many."""
    (w, h), (width, height) = result.resolution, result.full_resolution
    times = width * height / (w * h)
    return 1 if abs(times - 1) < 0.01 else times


def size_sentence(result: TradeoffResult) -> str:
    """What the times mean for a picture of full size."""
    (w, h), (width, height) = result.resolution, result.full_resolution
    times = size_factor(result)
    told = f"Times are for a picture of {w} × {h} pixels on {_cores(result)}"
    if times == 1:
        return f"{told}, as large as the stage asks for."
    return (
        f"{told}; the {width} × {height} that the stage asks for take {short(times)} times as long "
        "for the same error."
    )


def _cores(result: TradeoffResult) -> str:
    return counted(int(result.environment.get("cores", "1")), "core")


def cannot_be_concluded(result: TradeoffResult) -> Iterator[str]:
    """Whatever a reader might take from the figures, and should not."""
    reference = result.reference
    if reference.rel_mse is None:
        yield (
            f"The reference, {reference.described}, does not say how noisy it is: what looks like "
            "a floor may be its noise. No candidate is said to have one, or to have none."
        )
    else:
        noisy = [
            found.name
            for found in result.candidates
            if reference.rel_mse > _TOO_NOISY * found.rungs[-1].rel_mse.value
        ]
        if noisy:
            yield (
                f"The reference is too noisy ({error_percent(reference.rel_mse)}) to judge "
                f"{', '.join(noisy)} well: more --time, or a --reference, would tell."
            )
    unsure = [found.name for found in result.candidates if found.fireflies]
    if unsure:
        yield (
            f"Rare bright pixels are most of the error of {', '.join(unsure)}: {result.seeds} "
            "renders are too few, and no interval knows of what none of them saw."
        )
    if any(choice.extrapolated for choice in result.choices):
        yield (
            "Times marked “by its curve” are longer than all renders of that candidate together, "
            "whose mean is as good as one render so long: such errors are not measured, and a "
            "floor too low to be seen yet may end the fall before."
        )
    yield (
        "The reference is by bdpt, which all candidates share parts with: light that none of them "
        "can find is missing in it, too, and in no figure here."
        if reference.seconds is not None
        else "What is wrong in the reference counts as right here."
    )
    yield (
        "Who is best here was chosen by the same renders that tell how good it is: among equals, "
        "the luckiest. Where intervals overlap, prefer what is simpler."
    )


def what_default_is() -> str:
    """In the terms that candidates differ in."""
    return (
        f"The default follows light for {_DEFAULTS.max_depth} bounces, may end dim paths from the "
        f"{_DEFAULTS.roulette_depth}th on, and starts 4 paths at the lamps for each from the "
        "camera where something gathers light into caustics, else one for every second."
    )


def run_sentence(result: TradeoffResult) -> str:
    included = "" if result.reference.seconds is None else ", the reference included"
    return (
        f"{counted(len(result.candidates), 'candidate')}, {result.seeds} renders each, in "
        f"{seconds_text(result.seconds)}{included}."
    )
