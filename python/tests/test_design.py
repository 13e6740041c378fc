"""Searches for dimensions: results of Rust, mistakes, copies."""

import copy
import pickle

import linkage
import numpy as np
import pytest
from conftest import FOUR_BAR, ROOT

LENGTHS = ("frame", "crank", "coupler", "rocker")
POINTS = [[3.0, 3.0], [2.759, 3.363], [2.372, 3.663], [1.89, 3.862], [1.355, 3.943]]


@pytest.fixture(scope="module")
def path_bar():
    return linkage.load(ROOT / "mechanisms" / "four_bar_paths.rs")


def problem(**changed):
    """Five points with their angles: a problem of the literature."""
    given = {
        "vary": {**dict.fromkeys(LENGTHS, (1e-3, 50.0)), "arm": (-50.0, 50.0)},
        "want": linkage.Target("path", "tracer", POINTS, at=np.radians([30, 45, 60, 75, 90])),
        "hold": [linkage.crank_turns(*LENGTHS)],
        "starts": 64,
    }
    return {**given, **changed}


@pytest.fixture(scope="module")
def found(path_bar):
    return path_bar.design(**problem())


def test_the_known_optimum_is_found(found):
    best = found.best
    # The value of `mechanisms/four_bar_paths.rs` in Rust, whose search has the same starts.
    assert abs(best.sum / 7.41575130678e-7 - 1) < 1e-9
    assert best is found[0] and best.is_converged and best.hits >= 1
    assert [one.sum for one in found] == sorted(one.sum for one in found)
    residuals = best.residuals[0]
    assert residuals.shape == (5, 2)
    path = best.assembly.path(best.inputs[0]).tracer
    assert np.allclose(path - POINTS, residuals, atol=1e-12)
    assert np.isclose((residuals**2).sum(), best.sum, rtol=1e-12)
    assert list(best.dimensions) == list(best.assembly.mechanism.parameters)
    assert best.dimensions == best.assembly.dimensions
    # What may not change is nominal.
    assert best.dimensions["base.x"] == 0.0
    assert found.figures.residuals == 10 and found.figures.variables == 6
    assert found.figures.starts == 64
    assert "10 residuals, 6 variables" in str(found)
    assert "sum of squares 7.415751e-7" in str(best)


def test_results_do_not_depend_on_threads(path_bar, found):
    linkage.set_threads(1)
    again = path_bar.design(**problem())
    assert [one.dimensions for one in again] == [one.dimensions for one in found]
    assert [one.sum for one in again] == [one.sum for one in found]
    other = path_bar.design(**problem(seed=1))
    assert other.figures.evaluations != found.figures.evaluations


def test_free_inputs_come_in_order(path_bar):
    points = [[20.0, 20.0], [20.0, 30.0], [20.0, 45.0]]
    vary = {**dict.fromkeys(LENGTHS, (5.0, 60.0)), "arm": (-60.0, 60.0)}
    vary.update(base=(-60.0, 60.0), tilt=(0.0, 2 * np.pi))
    hold = linkage.crank_turns(*LENGTHS)
    for order, sign in (("in order", 1), ("backwards", -1)):
        want = linkage.Target("path", "tracer", points, order=order)
        best = path_bar.design(vary, want, hold=hold, starts=64).best
        assert best.sum < 1e-20
        assert (sign * np.diff(best.inputs[0]) >= 0).all()
    evenly = linkage.Target("path", "tracer", points, step=0.25)
    inputs = path_bar.design(vary, evenly, hold=hold, starts=64).best.inputs[0]
    assert np.allclose(np.diff(inputs), 0.25)


def test_all_kinds_of_ranges_and_relations():
    text = FOUR_BAR.replace("pub fn path(phi) -> Path { tracer }", "")
    bar = linkage.parse(text)
    m = bar.assemble(crank=48.0, rocker=104.0)
    phi = np.linspace(0, 5, 8)
    want = linkage.Target("motion", "psi", m.motion(phi).psi, at=phi, weights=[100.0])
    found = bar.design(
        {"crank": 0.2, "rocker": [96.0, 100.0, 104.0], "coupler": (110.0, 130.0)},
        want,
        hold=[
            linkage.exactly({"coupler": 1.0}, 120.0),
            linkage.at_least({"rocker": 1.0, "crank": -1.0}, 10.0),
            linkage.at_most({"crank": 1.0}, 55.0),
        ],
        starts=32,
    )
    best = found.best
    assert np.isclose(best.dimensions["crank"], 48.0) and best.dimensions["rocker"] == 104.0
    assert best.residuals[0].shape == (8, 1)
    # A bound in the way, and the dimensions of an assembly instead of nominal ones.
    start = bar.assemble(rocker=104.0)
    held = bar.design({"crank": (49.0, 60.0)}, want, start=start, starts=8).best
    assert held.dimensions["rocker"] == 104.0
    assert held.bounds["crank"].bound == 49.0 and held.bounds["crank"].gain > 0.0


def test_copies_are_equal(found):
    best = pickle.loads(pickle.dumps(found.best))
    assert best.dimensions == found.best.dimensions
    assert best.assembly == found.best.assembly
    phi = np.linspace(0, 6, 50)
    assert (best.assembly.path(phi).tracer == found.best.assembly.path(phi).tracer).all()
    assert copy.copy(found.best.assembly) is found.best.assembly


@pytest.mark.parametrize(
    ("changed", "kind", "text"),
    [
        ({"vary": {"crnk": (1, 2)}}, linkage.DesignError, "crnk"),
        ({"vary": {}}, linkage.DesignError, "no parameter may vary"),
        ({"vary": {"crank": (2, 1)}}, linkage.DesignError, "crank"),
        ({"vary": {"crank": (1, 2, 3)}}, ValueError, "3 bounds"),
        ({"vary": {"crank": "long"}}, TypeError, "real numbers"),
        ({"want": []}, linkage.DesignError, "nothing is wanted"),
        ({"want": linkage.Target("poor", "tracer", POINTS)}, linkage.DesignError, "velocity"),
        ({"want": linkage.Target("pth", "tracer", POINTS)}, TypeError, "`path` is similar"),
        ({"want": linkage.Target("path", "trcer", POINTS)}, linkage.DesignError, "trcer"),
        ({"want": linkage.Target("path", "tracer", [1.0, 2.0])}, linkage.DesignError, "number"),
        ({"hold": [linkage.at_most({"crnk": 1}, 2)]}, linkage.DesignError, "crnk"),
        ({"hold": [linkage.at_most({"crank": 1}, -2)]}, linkage.DesignError, "crank"),
        ({"time_limit": -1.0}, ValueError, "negative"),
    ],
)
def test_each_mistake_has_a_clear_text(path_bar, changed, kind, text):
    with pytest.raises(kind, match=text):
        path_bar.design(**problem(**changed))


def test_mistakes_of_targets():
    with pytest.raises(ValueError, match="rows are positions"):
        linkage.Target("path", "tracer", np.zeros((2, 2, 2)))
    with pytest.raises(ValueError, match="no order `random`"):
        linkage.Target("path", "tracer", POINTS, order="random")
    with pytest.raises(ValueError, match="`at`, or by `step`"):
        linkage.Target("path", "tracer", POINTS, at=[1, 2, 3, 4, 5], step=1.0)


def test_ctrl_c_ends_a_search_and_progress_is_shown(path_bar, interrupted):
    def call(progress):
        path_bar.design(**problem(starts=100_000_000, progress=progress))

    done, all, least = interrupted(call)
    assert 0 < done < all == 100_000_000 and least > 0.0
    with pytest.raises(ZeroDivisionError):
        path_bar.design(**problem(starts=100_000_000, progress=lambda *_: 1 / 0))
