"""results.json. What is in it is described in results.schema.json, beside this file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from etendue.arrays import FloatArray
from etendue.json_text import all_finite, finite, json_text
from etendue.validation.results import (
    CaseResult,
    Check,
    Cost,
    Estimate,
    PicturePair,
    Plot,
    Pyramid,
    Series,
    Strategy,
    ValidationResult,
)

#: Goes up when a reader of the file must change; fields that are only added leave it.
SCHEMA_VERSION = 1
SCHEMA = Path(__file__).with_name("results.schema.json")


def as_json(result: ValidationResult) -> str:
    return json_text(_document(result))


def _document(result: ValidationResult) -> dict[str, Any]:
    return {
        "schema_version": SCHEMA_VERSION,
        "passed": bool(result.passed),
        "effort": result.effort,
        "seed": int(result.seed),
        "false_alarm_rate": float(result.false_alarm_rate),
        "level": float(result.level),
        "seconds": float(result.seconds),
        "environment": dict(result.environment),
        "not_run": list(result.not_run),
        "diagnoses": list(result.diagnoses),
        "cases": [_case(case) for case in result.cases],
    }


def _case(case: CaseResult) -> dict[str, Any]:
    figures = case.figures
    return {
        "name": case.name,
        "title": case.title,
        "headline": case.headline,
        "lesson": list(case.lesson),
        "passed": bool(case.passed),
        "seconds": float(case.seconds),
        "renders": int(case.renders),
        "paths": int(case.paths),
        "checks": [_check(check) for check in case.checks],
        "pictures": [_pair(figure) for figure in figures if isinstance(figure, PicturePair)],
        "plots": [_plot(figure) for figure in figures if isinstance(figure, Plot)],
        "pyramids": [_pyramid(figure) for figure in figures if isinstance(figure, Pyramid)],
        "costs": [_cost(cost) for cost in case.costs],
    }


def _check(check: Check) -> dict[str, Any]:
    return {
        "name": check.name,
        "quantity": check.quantity,
        "stage": check.stage,
        "camera": check.camera,
        "integrator": check.integrator,
        "corrections_off": list(check.corrections_off),
        "formula": check.formula,
        "predicted": finite(check.predicted),
        "measured": estimate_document(check.measured),
        "p_value": finite(check.p_value),
        "passed": bool(check.passed),
        "explanations": list(check.explanations),
    }


def estimate_document(estimate: Estimate) -> dict[str, Any]:
    return {
        "value": finite(estimate.value),
        "low": finite(estimate.low),
        "high": finite(estimate.high),
        "level": float(estimate.level),
    }


def _pair(pair: PicturePair) -> dict[str, Any]:
    return {
        "title": pair.title,
        "caption": pair.caption,
        "full_scale": float(pair.full_scale),
        "mean_right": _mean(pair.right),
        "mean_wrong": _mean(pair.wrong),
    }


def _plot(plot: Plot) -> dict[str, Any]:
    return {
        "title": plot.title,
        "caption": plot.caption,
        "x_label": plot.x_label,
        "y_label": plot.y_label,
        "log_y": bool(plot.log_y),
        "predicted": [_series(series) for series in plot.predicted],
        "measured": [_series(series) for series in plot.measured],
    }


def _series(series: Series) -> dict[str, Any]:
    return {
        "label": series.label,
        "x": all_finite(series.x),
        "y": all_finite(series.y),
        "low": all_finite(series.low),
        "high": all_finite(series.high),
    }


def _pyramid(pyramid: Pyramid) -> dict[str, Any]:
    return {
        "title": pyramid.title,
        "caption": pyramid.caption,
        "weighted_right": _means(pyramid.weighted_right),
        "weighted_wrong": _means(pyramid.weighted_wrong),
        "unweighted_right": _means(pyramid.unweighted_right),
        "unweighted_wrong": _means(pyramid.unweighted_wrong),
    }


def _means(images: Mapping[Strategy, FloatArray]) -> list[dict[str, Any]]:
    return [{"s": int(s), "t": int(t), "mean": _mean(images[s, t])} for s, t in sorted(images)]


def _mean(picture: FloatArray) -> list[float | None]:
    return all_finite(picture.mean(axis=(0, 1)))


def _cost(cost: Cost) -> dict[str, Any]:
    return {
        "stage": cost.stage,
        "integrator": cost.integrator,
        "ratio": estimate_document(cost.ratio),
        "pairs": int(cost.pairs),
    }
