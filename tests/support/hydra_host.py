"""A program that hosts the render delegate: a Python whose USD has imaging (the package bpy).

It runs as a process of its own, because ours has another USD.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

HOST = "ETENDUE_HYDRA_HOST"  # a Python interpreter
PLUGIN = "ETENDUE_HYDRA_PLUGIN"  # the directory of plugInfo.json
LIBRARY = "ETENDUE_HYDRA_PICKING"  # built of plugin/host/*.cpp
_TESTS = Path(__file__).resolve().parent.parent
# UsdImaging has two ways to fill Hydra; only the newer one hands over implicit surfaces as such.
SCENE_INDEX = {"USDIMAGINGGL_ENGINE_ENABLE_SCENE_INDEX": "1"}


@dataclass(frozen=True)
class HydraHost:
    """Runs the scripts of tests/plugin/host."""

    python: Path
    plugin: Path

    def run(
        self,
        script: str,
        *arguments: object,
        timeout: float = 300.0,
        environment: Mapping[str, str] | None = None,
    ) -> str:
        """What the script prints. Fails the test when it does not end well."""
        done = self.complete(script, *arguments, timeout=timeout, environment=environment)
        return done.stdout

    def complete(
        self,
        script: str,
        *arguments: object,
        timeout: float = 300.0,
        environment: Mapping[str, str] | None = None,
    ) -> subprocess.CompletedProcess[str]:
        """As run(), for what the script says elsewhere, too."""
        command = [str(self.python), "-m", "plugin.host", script, *map(str, arguments)]
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
            env={
                **os.environ,
                "PYTHONPATH": str(_TESTS),
                PLUGIN: str(self.plugin),
                **(environment or {}),
            },
        )
        if done.returncode != 0:
            command_line = " ".join(command)
            pytest.fail(f"{command_line}: {done.returncode}\n{done.stdout}\n{done.stderr}")
        return done


def hydra_host() -> HydraHost:
    """The host that the environment names. Skips the test when it names none."""
    python, plugin = os.environ.get(HOST), os.environ.get(PLUGIN)
    if not python or not plugin:
        pytest.skip(f"no host for the Hydra plugin: {HOST} and {PLUGIN} are not set")
    return HydraHost(Path(python), Path(plugin))


def skip_without_library() -> None:
    """For scripts that need what Python's modules of USD do not have."""
    if not os.environ.get(LIBRARY):
        pytest.skip(f"{LIBRARY} is not set")
