"""Which error in the renderer would make all of this."""

from __future__ import annotations

from collections.abc import Sequence

from etendue.validation.claims import FALSE_ALARM, Claim
from etendue.validation.errors import Error


def diagnose(claims: Sequence[Claim]) -> tuple[str, ...]:
    """The errors that explain a failed check and contradict no check that could see them.

    More than one where the claims cannot tell them apart; none when nothing failed.
    """
    return tuple(str(error) for error in _known(claims) if _explains(error, claims))


def _known(claims: Sequence[Claim]) -> list[Error]:
    return list(dict.fromkeys(error for claim in claims for error in claim.under))


def _explains(error: Error, claims: Sequence[Claim]) -> bool:
    seeing = [claim for claim in claims if error in claim.under]
    possible = all(claim.evidence.p_value(claim.under[error]) >= FALSE_ALARM for claim in seeing)
    return possible and any(
        claim.evidence.p_value(claim.predicted) < FALSE_ALARM for claim in seeing
    )
