"""_core.pyi says what the extension module has, no more and no less."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import etendue
from etendue import _core

STUB = Path(etendue.__file__).parent / "_core.pyi"

HEADERS = Path(__file__).parents[2] / "core" / "include" / "etendue"
# They reach Python as NumPy arrays.
NOT_BOUND = {"Matrix4", "AovImage", "StrategyImage"}

# What every pybind11 class or enumeration has besides its own.
_GIVEN = {"name", "value"}


def names(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    """Public names that a module or class body defines."""
    found: dict[str, ast.stmt] = {}
    for statement in body:
        match statement:
            case ast.ClassDef(name=name) | ast.FunctionDef(name=name):
                found[name] = statement
            case ast.AnnAssign(target=ast.Name(id=name)):
                found[name] = statement
            case ast.Assign(targets=[ast.Name(id=name)]):
                found[name] = statement
    return {name: node for name, node in found.items() if not name.startswith("_")}


def public(value: object) -> set[str]:
    return {name for name in vars(value) if not name.startswith("_")}


def test_module() -> None:
    stub = names(ast.parse(STUB.read_text()).body)
    assert set(stub) == public(_core)


def test_classes() -> None:
    for name, node in names(ast.parse(STUB.read_text()).body).items():
        if isinstance(node, ast.ClassDef) and not issubclass(getattr(_core, name), Exception):
            stub = set(names(node.body)) - _GIVEN
            assert stub == public(getattr(_core, name)) - _GIVEN, name


def test_constructors_take_every_attribute() -> None:
    for name, node in names(ast.parse(STUB.read_text()).body).items():
        if not isinstance(node, ast.ClassDef):
            continue
        for method in node.body:
            if isinstance(method, ast.FunctionDef) and method.name == "__init__":
                keywords = {argument.arg for argument in method.args.kwonlyargs}
                if keywords:
                    assert keywords == set(names(node.body)), name


def header_structs() -> dict[str, set[str]]:
    """Members of the façade's plain structs, by struct."""
    structs = {}
    for header in HEADERS.glob("*.h"):
        text = re.sub(r"//.*", "", header.read_text())
        for name, body in re.findall(r"\nstruct (\w+) \{\n(.*?)\n\};", text, re.DOTALL):
            plain = body.split("[[nodiscard]]")[0]
            while "{" in plain:
                plain = re.sub(r"\{[^{}]*\}", "", plain)
            structs[name] = set(re.findall(r"(\w+)\s*(?:=[^;]*)?;", plain))
    return structs


def test_structs_are_the_headers() -> None:
    structs = header_structs()
    assert len(structs) > 30
    for name in structs.keys() - NOT_BOUND:
        bound = {member for member in public(getattr(_core, name)) if not member.startswith("add_")}
        assert structs[name] == bound - {"array", "strategy_array", "copy"}, name


def test_typed_marker() -> None:
    assert (STUB.parent / "py.typed").exists()
