"""results.json. What is in it is described in results.schema.json, beside this file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from etendue.json_text import finite, json_text
from etendue.tradeoff.report.words import cannot_be_concluded, verdict_sentence
from etendue.tradeoff.results import CandidateResult, Choice, Rung, TradeoffResult
from etendue.validation.report.json_file import estimate_document

#: Goes up when a reader of the file must change; fields that are only added leave it.
SCHEMA_VERSION = 1
SCHEMA = Path(__file__).with_name("results.schema.json")


def as_json(result: TradeoffResult) -> str:
    return json_text(_document(result))


def _document(result: TradeoffResult) -> dict[str, Any]:
    reference = result.reference
    return {
        "schema_version": SCHEMA_VERSION,
        "stage": result.stage,
        "camera": result.camera,
        "resolution": list(result.resolution),
        "full_resolution": list(result.full_resolution),
        "seeds": int(result.seeds),
        "seed": int(result.seed),
        "level": float(result.level),
        "false_alarm_rate": float(result.false_alarm_rate),
        "seconds": float(result.seconds),
        "environment": dict(result.environment),
        "interrupted": bool(result.interrupted),
        "not_run": list(result.not_run),
        "cannot_be_concluded": list(cannot_be_concluded(result)),
        "reference": {
            "described": reference.described,
            "rel_mse": None if reference.rel_mse is None else finite(reference.rel_mse),
            "seconds": None if reference.seconds is None else finite(reference.seconds),
        },
        "choices": [_choice(choice) for choice in result.choices],
        "front": [
            {"best": span.best, "begin": finite(span.begin), "end": finite(span.end)}
            for span in result.front
        ],
        "candidates": [_candidate(found) for found in result.candidates],
    }


def _choice(choice: Choice) -> dict[str, Any]:
    return {
        "seconds": finite(choice.seconds),
        "best": choice.best,
        "rel_mse": estimate_document(choice.rel_mse),
        "as_good": list(choice.as_good),
        "extrapolated": bool(choice.extrapolated),
    }


def _candidate(found: CandidateResult) -> dict[str, Any]:
    return {
        "name": found.name,
        "turned": found.candidate.turned,
        "what": found.candidate.what,
        "asked_for": found.candidate.asked_for,
        "verdict": found.verdict,
        "told": verdict_sentence(found),
        "rungs": [_rung(rung) for rung in found.rungs],
        "pooled": _rung(found.pooled),
        "slope": estimate_document(found.slope),
        "end_slope": finite(found.end_slope),
        "floor": estimate_document(found.floor),
        "floor_p_value": finite(found.floor_p_value),
        "curve": {
            "noise": estimate_document(found.curve.noise),
            "floor": finite(found.curve.floor),
        },
        "efficiency": estimate_document(found.efficiency),
        "relative_efficiency": estimate_document(found.relative_efficiency),
        "brightness": estimate_document(found.brightness),
        "outliers": finite(found.outliers),
    }


def _rung(rung: Rung) -> dict[str, Any]:
    return {
        "passes": int(rung.passes),
        "seconds": finite(rung.seconds),
        "rel_mse": estimate_document(rung.rel_mse),
    }
