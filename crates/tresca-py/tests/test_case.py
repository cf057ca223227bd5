"""Case files through Python."""

import json
import pickle

import numpy as np
import pytest
import tresca

PRESSED = """
title = "A column on a column"

[[body]]
name = "upper"
mesh = { brick = { min = [0.0, 0.0, 1.0], max = [1.0, 1.0, 2.0], nodes = [4, 4, 4] } }
material = { young = 100.0, poisson = 0.0 }

[[body]]
name = "lower"
mesh = { brick = { min = [0.0, 0.0, 0.0], max = [1.0, 1.0, 1.0], nodes = [4, 4, 4] } }
material = { young = 100.0, poisson = 0.0 }

[[clamp]]
on = ["lower.z-"]

[[traction]]
on = ["upper.z+"]
value = [0.0, 0.0, -2.0]

[[contact]]
pair = ["upper.z-", "lower.z+"]
friction = { law = "tresca", bound = 0.5 }
"""


def test_a_column_is_shortened_as_hooke_says(tmp_path):
    case = tresca.Case.parse(PRESSED)
    assert case.title == "A column on a column" and case.settings["method"] == "grssn"
    seen = []
    result = case.solve(tolerance=1e-10, callback=seen.append)
    assert result.converged and len(result.steps) == 1
    step = result.last
    assert len(step.history) == len(seen)
    assert step.certificate.worst < 1e-7 and "moment_balance" in step.certificate
    # 2 MPa over 2 m at 100 MPa.
    top = result.bodies["upper"][:, 2] == 2.0
    np.testing.assert_allclose(step.displacements["upper"][top, 2], -0.04, rtol=1e-6)
    (contact,) = step.contacts
    assert (contact.slave, contact.master) == ("upper.z-", "lower.z+")
    np.testing.assert_allclose(contact.pressure, 2.0, rtol=1e-6)
    np.testing.assert_allclose(contact.areas.sum(), 1.0)
    np.testing.assert_allclose(contact.normals, [[0, 0, -1]] * 16)
    assert contact.closed.all() and contact.stick.all()

    result.write(tmp_path / "out", "column")
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["steps"][0]["dual_objective"] == step.dual_objective
    assert (tmp_path / "out" / "column.pvd").exists() and (tmp_path / "out" / "contact.vtu").exists()
    (tmp_path / "file").write_text("")
    with pytest.raises(tresca.OutputError, match="is a file|cannot"):
        result.write(tmp_path / "file")
    for thing in (case, result, step, contact):
        assert "tresca." in repr(thing)


def test_an_unconverged_case_warns():
    with pytest.warns(tresca.ConvergenceWarning, match="iteration_limit"):
        result = tresca.Case.parse(PRESSED).solve(max_iterations=0)
    assert result.status == "iteration_limit" and not result.converged


def test_errors_show_the_place(tmp_path):
    with pytest.raises(tresca.CaseError) as caught:
        tresca.Case.parse(PRESSED.replace("upper.z-", "uper.z-"), name="column.toml")
    assert "uper" in str(caught.value) and "column.toml" in str(caught.value)
    assert isinstance(caught.value, tresca.ProblemError)
    with pytest.raises(tresca.CaseError, match="cannot read the case file"):
        tresca.Case.load(tmp_path / "missing.toml")
    path = tmp_path / "case.toml"
    path.write_text(PRESSED)
    assert tresca.Case.load(str(path)).title == tresca.Case.load(path).title
    with pytest.raises(TypeError, match="no option"):
        tresca.Case.load(path).solve(tolerence=1.0)


def test_errors_survive_a_process_boundary():
    error = pickle.loads(pickle.dumps(tresca.ProblemError("text")))
    assert isinstance(error, tresca.ProblemError) and str(error) == "text"
