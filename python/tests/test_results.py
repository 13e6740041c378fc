"""Shapes and values of results."""

import copy
import os
import pickle
import subprocess
import sys
import threading

import linkage
import numpy as np
import pytest


def test_the_example_of_the_page(bar):
    m = bar.assemble(crank=51.0)
    r = m.motion(np.linspace(0, 2 * np.pi, 721))
    assert r.tracer.shape == (721, 2)
    assert r.v.shape == (721,)
    assert r.e["crank"].shape == (721,)
    assert r.to["crank"].shape == (721, 2)
    assert np.asarray(r.to).shape == (721, 2, 5)
    assert r.to.names == ("crank", "coupler", "rocker", "pivot.x", "pivot.y")
    assert m.dimensions["crank"] == 51.0


def test_a_number_gives_numbers(m):
    r = m.motion(1.2)
    assert r.shape == () and isinstance(r.psi, float)
    assert r.tracer.shape == (2,)
    # The coupler triangle, closed by hand.
    a = 50 * np.array([np.cos(1.2), np.sin(1.2)])
    b = np.array([140.0, 0.0]) + 100 * np.array([np.cos(r.psi), np.sin(r.psi)])
    assert abs(np.linalg.norm(b - a) - 120) < 1e-12
    assert np.allclose(r.tracer, a + 70 / 120 * (b - a), atol=1e-12)


def test_derivatives_are_those_of_differences(bar, m):
    r, step = m.motion(1.2), 1e-6
    for name in bar.parameters:
        value = bar.parameters[name].nominal
        high, low = (m.motion(1.2, **{name: value + s}) for s in (step, -step))
        assert abs((high.psi - low.psi) / (2 * step) - r.e[name]) < 1e-8
        assert np.allclose((high.tracer - low.tracer) / (2 * step), r.to[name], atol=1e-7)
    high, low = m.motion(1.2 + step), m.motion(1.2 - step)
    assert abs((high.psi - low.psi) / (2 * step) - r.v) < 1e-8
    assert abs((high.v - low.v) / (2 * step) - r.a) < 1e-8


def test_inputs_and_dimensions_are_broadcast(m):
    phi = np.linspace(0, 6, 7)[:, None]
    crank = np.array([49.0, 50.0, 51.0])
    r = m.motion(phi, crank=crank)
    assert r.shape == (7, 3) and r.tracer.shape == (7, 3, 2)
    for k, one in enumerate(crank):
        own = m.motion(phi[:, 0], crank=np.full(7, one))
        assert (own.psi == r.psi[:, k]).all()
    assert m.motion(1.2, crank=[[50.0]]).shape == (1, 1)
    assert m.motion(np.empty((0, 3))).tracer.shape == (0, 3, 2)
    assert m.motion([1, 2]).psi.shape == (2,)


def test_vectors_are_given_whole_or_by_components(bar, m):
    pivots = np.array([[140.0, 0.0], [141.0, 1.0]])
    r = m.motion(1.2, pivot=pivots)
    assert r.psi[1] == m.motion([1.2], pivot_x=141.0, pivot_y=1.0).psi[0]
    assert bar.assemble(pivot=(141, 1)).dimensions == bar.assemble(
        **{"pivot.x": 141, "pivot_y": 1}
    ).dimensions


def test_assemblies_of_other_dimensions_agree_with_sweeps_over_them(bar, m):
    phi = np.linspace(0, 6, 50)
    many = m.motion(phi, crank=np.full(50, 47.0))
    assert np.allclose(many.psi, bar.assemble(crank=47.0).motion(phi).psi, atol=1e-13)


def test_positions_that_do_not_close_are_nan_and_gaps_are_their_distance(rocking):
    m = rocking.assemble()
    phi = np.array([[0.85, 3.0], [0.9, 3.2]])
    psi, gaps = m.motion(phi).psi, m.gaps(phi)
    assert np.isfinite(psi[:, 0]).all() and np.isnan(psi[:, 1]).all()
    assert gaps.shape == (2, 2, 1)
    assert (gaps[:, 0] == 0).all()
    # Crank's pin to rocker's pivot, less coupler and rocker.
    distance = np.hypot(90 * np.cos(phi[:, 1]) - 100, 90 * np.sin(phi[:, 1]))
    assert np.allclose(gaps[:, 1, 0], distance - 120, atol=1e-9)
    assert rocking.warnings and not m.check_range()[0]


def test_out_is_filled_again(m):
    phi = np.linspace(0, 6, 1000)
    first = m.motion(phi)
    expected = m.motion(phi + 0.1).psi.copy()
    again = m.motion(phi + 0.1, out=first)
    assert again is first
    assert (again.psi == expected).all()
    # Arguments are those of the numbers.
    assert (again.arguments["phi"] == phi + 0.1).all()
    with pytest.raises(ValueError, match="`out` is a result of `motion` at"):
        m.motion(phi[:5], out=first)
    with pytest.raises(ValueError, match="a result of `path`"):
        m.path(phi, out=first)


def test_assemblies_and_circuits(bar, rocking):
    both = bar.assemblies(1.2, crank=51.0)
    assert len(both) == 2
    assert both[0].motion(1.2).psi != both[1].motion(1.2).psi
    assert {one.modes for one in both} == {(1,), (-1,)}
    found = rocking.circuits()
    assert {end.kind for branch in found for end in branch.ends} == {"turning point"}
    assert str(found).startswith("assembly")
    whole = bar.circuits()
    assert [branch.closed for branch in whole] == [True, True]
    assert whole[0].is_whole and whole[0].unknowns["theta"] < 1.0


def test_an_assembly_is_kept_for_other_dimensions(bar):
    other = bar.assemblies()[1]
    again = bar.assemble_from(other, crank=52.0)
    assert again.modes == other.modes
    assert again.dimensions["crank"] == 52.0 and again.dimensions["coupler"] == 120.0


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])
def test_copies_have_the_same_numbers(bar, copied):
    phi = np.linspace(0, 6, 20)
    tight = bar.with_tolerances(crank=0.001)
    assert copied(tight) == tight and copied(tight) != bar
    kept = bar.assemble_from(bar.assemblies()[1], crank=52.0)
    for m in [bar.assemble(crank=51.0), bar.assemblies(1.3)[1], kept, bar.circuits()[1].assembly]:
        again = copied(m)
        assert again == m and again.mechanism == bar
        assert (again.motion(phi).psi == m.motion(phi).psi).all()
        assert copied(m.motion)(1.0).psi == m.motion(1.0).psi
    r = copied(bar.assemble().motion(phi))
    assert r.tracer.shape == (20, 2) and r.units["tracer"] == "mm"


def test_threads_of_python_share_an_assembly(m):
    phi = np.linspace(0, 6, 50_000)
    expected = m.motion(phi).psi
    found = [None] * 8
    def work(k):
        found[k] = m.motion(phi).psi
    workers = [threading.Thread(target=work, args=(k,)) for k in range(8)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all((one == expected).all() for one in found)


FORKED = """
import multiprocessing, numpy as np, linkage
from conftest import FOUR_BAR
m = linkage.parse(FOUR_BAR).assemble()
phi = np.linspace(0, 6, 50_000)
linkage.set_threads(3)
expected = m.path(phi).tracer
with multiprocessing.get_context("fork").Pool(2) as pool:
    found = pool.map(m.path, [phi, phi])
assert all((one.tracer == expected).all() for one in found)
assert (m.path(phi).tracer == expected).all()
print("equal")
"""


def test_a_forked_process_computes_the_same():
    # A process of its own: what other tests have loaded may not be forked.
    paths = [os.path.dirname(__file__), *(path for path in sys.path if path)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
    command = [sys.executable, "-c", FORKED]
    done = subprocess.run(
        command, capture_output=True, text=True, env=environment, timeout=120, check=False
    )
    assert done.stdout.strip() == "equal", done.stderr


def test_tolerances(bar, m):
    phi = np.array([0.5, 1.2, 2.0])
    effects = m.tolerance("motion", phi)["e"]
    e = m.motion(phi).e
    tolerances = {name: one.tolerance for name, one in bar.parameters.items()}
    parts = np.array([abs(e[name]) * tolerance for name, tolerance in tolerances.items()])
    assert np.allclose(effects.worst, parts.sum(axis=0), rtol=1e-12)
    assert np.allclose(effects.statistical, np.sqrt((parts**2).sum(axis=0)), rtol=1e-12)
    assert np.allclose(effects.parts["crank"], parts[0], rtol=1e-12)
    half = bar.with_tolerances(**{name: t / 2 for name, t in tolerances.items()})
    assert np.allclose(half.assemble().tolerance("motion", phi)["e"].worst, effects.worst / 2)
    assert "root sum square" in effects.text


def test_the_summary_has_exact_limits(m):
    found = m.summary("motion", "psi", band=0.01)
    # Crank and coupler in line: triangles with the frame.
    for extreme, reach in [(found.position.lowest, 170.0), (found.position.highest, 70.0)]:
        cosine = (140**2 + 100**2 - reach**2) / (2 * 140 * 100)
        assert abs(abs(np.pi - extreme.value) - np.arccos(cosine)) < 1e-13
    assert abs(sum(found.strokes) - 2 * np.pi) < 1e-12
    assert found.velocity is not None and found.acceleration is None
    assert found.dwells and found.dwells[0].length > 0
    assert "stroke" in str(found)
    assert str(found).count("\ndwell ") == len(found.dwells) == 2


def test_the_summary_ends_at_dead_points(rocking):
    m = rocking.assemble()
    found = m.summary("motion", "psi", band=0.05)
    assert len(found.parts) == 2
    for start, end in found.parts:
        inside = np.linspace(start + 1e-6, end - 1e-6, 50)
        assert np.isfinite(m.motion(inside).psi).all()
    # The first part ends where crank and rod, then the frame's triangle, are in line.
    assert np.isnan(m.motion(found.parts[0][1] + 1e-6).psi)
    assert str(found).count("only from") == 2 and found.position.stroke > 0.0


def test_results_become_tables(m):
    pandas = pytest.importorskip("pandas")
    r = m.motion(np.linspace(0, 6, 4)[:, None], crank=np.array([49.0, 50.0]))
    table = r.to_pandas()
    assert list(table.columns[:4]) == ["phi", "crank", "tracer.x", "tracer.y"]
    assert len(table) == 8
    assert (table["tracer.y"].to_numpy() == r.tracer[..., 1].reshape(-1)).all()
    assert (table["crank"].to_numpy()[:2] == [49.0, 50.0]).all()
    assert isinstance(table, pandas.DataFrame)


def test_results_become_tables_of_polars(m):
    pytest.importorskip("polars")
    table = m.motion(np.linspace(0, 6, 4)).to_polars()
    assert table.columns[:3] == ["phi", "tracer.x", "tracer.y"] and table.height == 4


def test_results_become_data_sets(m):
    pytest.importorskip("xarray")
    r = m.motion(np.linspace(0, 6, 4)[:, None], crank=np.array([49.0, 50.0]))
    data = r.to_xarray()
    assert data.psi.dims == ("phi", "crank") and data.psi.attrs["units"] == "rad"
    assert data.tracer.dims == ("phi", "crank", "component2")
    assert float(data.to.sel(to_entry="crank", component2="y")[1, 1]) == r.to["crank"][1, 1, 1]


def test_names_help(bar, m):
    import inspect

    assert "motion" in dir(m) and "tracer" in dir(m.motion(1.0))
    assert list(inspect.signature(m.motion).parameters) == ["phi", "dimensions"]
    assert "tracer [mm]" in str(bar.functions["motion"])
    assert bar.parameters["crank"] == ("crank", "mm", 50.0, 0.012)
    assert bar.inputs["phi"].linspace(3)[-1] == pytest.approx(2 * np.pi)
    assert "crank=50" in repr(m) and "psi = " in repr(m.motion(1.0))
    assert bar.structure.startswith("mobility 1") and bar.mobility == 1
    assert bar.groups[0] == (("theta", "psi"), "RRR", "loop 1")


def test_files_and_pages(bar, m, tmp_path):
    (tmp_path / "bar.mech").write_text(bar.source, encoding="utf-8")
    loaded = linkage.load(tmp_path / "bar.mech")
    assert loaded.assemble().motion(1.0).psi == m.motion(1.0).psi
    texts = bar.to_c(tmp_path / "c")
    assert sorted(texts) == ["four_bar.c", "four_bar.h"]
    assert (tmp_path / "c" / "four_bar.h").read_text(encoding="utf-8") == texts["four_bar.h"]
    assert "FourBar" in bar.page(11) and bar._repr_html_().startswith("<iframe")


def test_frames_are_homogeneous_matrices():
    bar = linkage.parse(
        """struct Arm { unit mm; param r = 30mm; input phi = 20deg in 0deg..90deg;
        let body = frame(polar(r, phi), polar(1, phi)); }
        impl Arm { fn pose(phi) -> Pose { body } }"""
    )
    body = bar.assemble().pose(np.array([0.3, 0.5])).body
    assert body.shape == (2, 3, 3)
    c, s = np.cos(0.3), np.sin(0.3)
    assert np.allclose(body[0], [[c, -s, 30 * c], [s, c, 30 * s], [0, 0, 1]], atol=1e-13)
