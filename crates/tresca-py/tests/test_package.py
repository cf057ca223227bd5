"""The package as such: documentation, types, options."""

import inspect
import subprocess
import sys
from typing import get_args, get_type_hints

import pytest
import tresca


def test_options_are_typed_as_they_are_declared():
    options = tresca.options()
    assert set(tresca.Options.__annotations__) == {option.name for option in options}
    assert all(option.doc and option.default and option.allowed for option in options)
    hints = get_type_hints(tresca.Options)
    for option in options:
        choices = [choice for part in get_args(hints[option.name]) for choice in get_args(part)]
        if option.default.startswith('"'):
            assert choices == option.allowed.split(" | "), option.name
    defaults = {option.name: option.default for option in options}
    assert defaults["method"] == '"grssn"' and float(defaults["tolerance"]) == 1e-8


def test_everything_public_is_documented():
    for name in tresca.__all__:
        thing = getattr(tresca, name)
        if not isinstance(thing, str):
            assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and thing.__module__.startswith("tresca"):
            for method, member in vars(thing).items():
                if not method.startswith("_") and (callable(member) or isinstance(member, (property, classmethod))):
                    assert inspect.getdoc(member), f"{name}.{method}"


def test_parameters_are_documented():
    for function in (tresca.solve, tresca.solve_dual):
        doc = inspect.getdoc(function)
        for parameter in inspect.signature(function).parameters:
            assert parameter in doc, f"{function.__name__}: {parameter}"


@pytest.mark.parametrize(
    "command", [["mypy", "--strict", "-p", "tresca"], ["mypy.stubtest", "tresca._tresca"]], ids=["mypy", "stubtest"]
)
def test_types(command, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_figures_of_the_certificate_are_documented():
    figures = tresca.solve([[1.0]], [1.0], [[1.0]]).certificate
    for name in [*figures, "force_balance", "moment_balance"]:
        assert f"``{name}``" in tresca.Certificate.__doc__


def test_iterations_have_the_columns_of_the_history():
    seen = []
    history = tresca.solve([[1.0]], [1.0], [[1.0]], callback=seen.append).history
    for name in history.dtype.names:
        assert inspect.getdoc(getattr(tresca.Iteration, name)), name
        assert [getattr(iteration, name) for iteration in seen] == history[name].tolist(), name
