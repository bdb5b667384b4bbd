"""The stub and the module say the same."""

from __future__ import annotations

import ast
import inspect
from pathlib import Path

import proxygraph
import pytest

from tests.native.grounds import flat
from tests.native.touching import touch

STUB = Path(__file__).resolve().parents[2] / "native" / "proxygraph" / "proxygraph.pyi"
TREE = ast.parse(STUB.read_text("utf-8"))
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef)}
CONSTANTS = {
    node.target.id: node
    for node in TREE.body
    if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)
}


def is_property(node: ast.FunctionDef) -> bool:
    return any(isinstance(mark, ast.Name) and mark.id == "property" for mark in node.decorator_list)


def members(class_: ast.ClassDef) -> dict[str, ast.FunctionDef | ast.AnnAssign]:
    named: dict[str, ast.FunctionDef | ast.AnnAssign] = {}
    for node in class_.body:
        if isinstance(node, ast.FunctionDef):
            named[node.name] = node
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            named[node.target.id] = node
    return named


def stub_parameters(node: ast.FunctionDef) -> list[tuple[str, str, object]]:
    """Name, kind and default of each parameter; a default that is required is ``empty``."""
    places = [*node.args.posonlyargs, *node.args.args]
    is_static = any(isinstance(mark, ast.Name) and mark.id == "staticmethod" for mark in node.decorator_list)
    defaults = [inspect.Parameter.empty] * (len(places) - len(node.args.defaults)) + [
        ast.literal_eval(default) for default in node.args.defaults
    ]
    found: list[tuple[str, str, object]] = [
        (place.arg, "place", default) for place, default in zip(places, defaults, strict=True)
    ]
    for keyword, default in zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True):
        value = inspect.Parameter.empty if default is None else ast.literal_eval(default)
        found.append((keyword.arg, "keyword", value))
    return found if is_static else found[1:]


def module_parameters(callable_: object) -> list[tuple[str, str, object]]:
    signature = inspect.signature(callable_)  # type: ignore[arg-type]
    return [
        (name, "keyword" if parameter.kind is parameter.KEYWORD_ONLY else "place", parameter.default)
        for name, parameter in signature.parameters.items()
        if name != "self"
    ]


def test_both_have_the_same_public_names() -> None:
    assert set(proxygraph.__all__) == {*CLASSES, *FUNCTIONS, *CONSTANTS}  # type: ignore[attr-defined]
    assert proxygraph.__version__.count(".") == 2


@pytest.mark.parametrize("name", CLASSES)
def test_both_have_the_same_members(name: str) -> None:
    in_module = {member for member in vars(getattr(proxygraph, name)) if not member.startswith("_")}
    in_stub = {member for member in members(CLASSES[name]) if not member.startswith("_")}
    assert in_module == in_stub


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_have_the_same_parameters(name: str) -> None:
    places = [place.arg for place in FUNCTIONS[name].args.args]
    assert list(inspect.signature(getattr(proxygraph, name)).parameters) == places


def test_the_names_of_the_models_are_told() -> None:
    after = TREE.body[TREE.body.index(CONSTANTS["MODELS"]) + 1]
    assert isinstance(after, ast.Expr)
    assert isinstance(after.value, ast.Constant)
    assert isinstance(after.value.value, str)
    assert tuple(after.value.value.split("``")[1].split()) == proxygraph.MODELS


@pytest.mark.parametrize("name", CLASSES)
def test_both_have_the_same_parameters_and_defaults(name: str) -> None:
    class_ = getattr(proxygraph, name)
    for member, node in members(CLASSES[name]).items():
        if not isinstance(node, ast.FunctionDef) or member == "__len__":
            continue
        if is_property(node):
            assert inspect.isdatadescriptor(vars(class_)[member]), f"{name}.{member} is no property"
            continue
        called = class_ if member == "__init__" else getattr(class_, member)
        in_stub = stub_parameters(node)
        in_module = [
            # The signature of a compiled function shows a tuple as an ellipsis; its value is held below.
            stub if found == (*stub[:2], ...) and isinstance(stub[2], tuple) else found
            for found, stub in zip(module_parameters(called), in_stub, strict=True)
        ]
        assert in_module == in_stub, f"{name}.{member}"


@pytest.mark.parametrize(
    "device", [proxygraph.ScriptedDevice([(0.0, 0.0, 0.0, 0.0)]), proxygraph.SimulatedDevice()]
)
def test_defaults_that_are_tuples(device: proxygraph.ScriptedDevice | proxygraph.SimulatedDevice) -> None:
    name = type(device).__name__
    wanted = {
        key: default for key, _, default in stub_parameters(constructor(name)) if isinstance(default, tuple)
    }
    assert device.workspace == wanted["workspace"]
    session = touch(flat(), device)
    session.step(1)
    assert session.state().hand == wanted.get("target", (0.0, 0.0, 0.0))


def constructor(name: str) -> ast.FunctionDef:
    node = members(CLASSES[name])["__init__"]
    assert isinstance(node, ast.FunctionDef)
    return node


@pytest.mark.parametrize("name", CLASSES)
def test_both_have_the_same_bases(name: str) -> None:
    in_stub = [base.id for base in CLASSES[name].bases if isinstance(base, ast.Name)]
    in_module = [base.__name__ for base in getattr(proxygraph, name).__bases__ if base is not object]
    assert in_module == in_stub


@pytest.mark.parametrize("name", CLASSES)
def test_classes_without_a_constructor_cannot_be_made(name: str) -> None:
    class_ = getattr(proxygraph, name)
    if "__init__" not in members(CLASSES[name]) and not issubclass(class_, Exception):
        with pytest.raises(TypeError, match=r"No constructor|cannot create"):
            class_()


@pytest.mark.parametrize("name", CLASSES)
def test_final_classes_have_no_children(name: str) -> None:
    marks = [mark.id for mark in CLASSES[name].decorator_list if isinstance(mark, ast.Name)]
    if "final" in marks:
        with pytest.raises(TypeError, match="base type"):
            type("Child", (getattr(proxygraph, name),), {})


def test_len_counts_ticks() -> None:
    assert "__len__" in members(CLASSES["Ticks"])
    assert hasattr(proxygraph.Ticks, "__len__")
    documented = ast.get_docstring(CLASSES["Ticks"])
    assert documented
    told = next(
        node.value.value
        for node in CLASSES["Ticks"].body[1:]
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    )
    assert isinstance(told, str)
    assert tuple(told.split("``")[1].split()) == proxygraph.Ticks.columns
