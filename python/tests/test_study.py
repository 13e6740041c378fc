"""Random mechanisms: statistics, parts, copies, mistakes."""

import pickle

import linkage
import numpy as np
import pytest

COUNT = 20_000


@pytest.fixture(scope="module")
def study(m):
    return m.monte_carlo("path", 1.2, count=COUNT, seed=3)


def test_statistics_are_those_of_tolerances(m, study):
    assert study.done == COUNT and study.missing == 0
    assert study.quantities == ("tracer.x", "tracer.y")
    effects = m.tolerance("motion", 1.2)["to"]
    found = [study.statistics(name) for name in study.quantities]
    deviation = np.hypot(*(one.deviation.value for one in found))
    # Normal distributions have a third of the tolerance as standard deviation.
    assert np.isclose(deviation, effects.statistical / 3, rtol=0.03)
    tracer = m.path(1.2).tracer
    for one, value in zip(found, tracer):
        assert one.count == COUNT and one.least < value < one.largest
        assert one.mean.low < one.mean.value < one.mean.high
        assert abs(one.mean.value - value) < 5 * one.deviation.value / np.sqrt(COUNT)


def test_figures_belong_together(study):
    name = "tracer.x"
    found = study.statistics(name)
    least, largest = study.extremes(name)
    assert (least.value, largest.value) == (found.least, found.largest)
    # The mechanism of an extreme is that of its dimensions.
    m = study.assembly
    assert m.path([1.2], **{key.replace(".", "_"): one for key, one in largest.dimensions.items()}).tracer[0, 0] == (
        largest.value
    )
    median = study.percentile(name, 0.5)
    assert median.low < median.value < median.high
    inside = study.part_within(name, least.value, median.value)
    assert np.isclose(inside.value, 0.5, atol=0.01)
    counts, edges = study.histogram(name, 20)
    assert np.isclose(counts.sum(), COUNT) and len(edges) == 21 and edges[0] == least.value
    few, edges = study.histogram(name, 2, range=(median.value, median.value + 1))
    assert np.isclose(few.sum(), COUNT / 2, rtol=0.02) and len(edges) == 3
    assert str(study).splitlines()[0] == "20000 mechanisms, 0 do not close"
    assert len(str(study).splitlines()) == 4


def test_parts_are_the_whole_to_the_last_bit(m, study):
    for threads, of in ((1, 2), (2, 3)):
        linkage.set_threads(threads)
        parts = [m.monte_carlo("path", 1.2, count=COUNT, seed=3, part=(k, of)) for k in range(of)]
        first, *others = reversed(parts)
        assert sum(part.done for part in parts) == COUNT
        assert first.merge(*others).to_bytes() == study.to_bytes()
        with pytest.raises(linkage.AnalysisError):
            first.merge(first)
    other = m.monte_carlo("path", 1.2, count=COUNT, seed=4)
    assert other.to_bytes() != study.to_bytes()
    with pytest.raises(linkage.AnalysisError, match="another study"):
        study.merge(other)


def test_a_copy_has_all_results(study):
    again = pickle.loads(pickle.dumps(study))
    assert again.to_bytes() == study.to_bytes()
    assert again.statistics("tracer.y") == study.statistics("tracer.y")


def test_distributions_and_quantities(m):
    exact = m.mechanism.with_tolerances(coupler=0, rocker=0).assemble()
    for name, part in (("uniform", 3), ("triangular", 6), ("arcsine", 2), ("normal", 9)):
        found = exact.monte_carlo("motion", phi=1.2, quantities="psi", distribution=name)
        e, tolerance = exact.motion(1.2).e["crank"], exact.mechanism.parameters["crank"].tolerance
        deviation = found.statistics("psi").deviation.value
        assert np.isclose(deviation, abs(e) * tolerance / np.sqrt(part), rtol=0.02), name
        own = exact.monte_carlo("motion", 1.2, quantities="psi", distributions={"crank": name})
        assert own.statistics("psi") == found.statistics("psi")
    chosen = m.monte_carlo("motion", 1.2, quantities=["tracer.y", "psi"], count=100)
    assert chosen.quantities == ("tracer.y", "psi")


def test_mechanisms_that_do_not_close_are_counted(rocking):
    far = rocking.with_tolerances(crank=60.0).assemble()
    found = far.monte_carlo("motion", 0.9, quantities="psi", count=5000)
    assert 0 < found.missing < found.done == 5000
    assert found.statistics("psi").count == 5000 - found.missing


def test_ctrl_c_ends_a_study_and_progress_is_shown(m, interrupted):
    def call(progress):
        m.monte_carlo("path", 1.2, count=10**12, progress=progress)

    done, all = interrupted(call)
    assert 0 < done < all == 10**12


def test_a_study_without_tolerances_is_a_mistake(rocking):
    with pytest.raises(linkage.AnalysisError, match="no dimension of Rocking has a tolerance"):
        rocking.assemble().monte_carlo("motion", 0.9)


@pytest.mark.parametrize(
    ("call", "kind", "text"),
    [
        (lambda m: m.monte_carlo("pth", 1), KeyError, "no function `pth`"),
        (lambda m: m.monte_carlo("path"), TypeError, "needs the argument `phi`"),
        (lambda m: m.monte_carlo("path", 1, crank=50), TypeError, "those of the assembly"),
        (lambda m: m.monte_carlo("path", 1, count=0), linkage.AnalysisError, "no mechanisms"),
        (lambda m: m.monte_carlo("path", 1, count=1.5), ValueError, "whole number"),
        (lambda m: m.monte_carlo("path", 1, part=(2, 2)), linkage.AnalysisError, "part"),
        (lambda m: m.monte_carlo("path", 1, quantities="trcer"), TypeError, "`tracer` is similar"),
        (lambda m: m.monte_carlo("path", 1, quantities=[]), linkage.AnalysisError, "0 numbers"),
        (lambda m: m.monte_carlo("motion", 1, quantities=["tracer", "e"]), linkage.AnalysisError, "to 4"),
        (lambda m: m.monte_carlo("path", 1, distribution="even"), ValueError, "`triangular`"),
        (lambda m: m.monte_carlo("path", 1, distributions={"crnk": "normal"}), TypeError, "crank"),
        (lambda m: m.monte_carlo("path", 1, count=10).statistics("x"), KeyError, "no quantity"),
        (lambda m: m.monte_carlo("path", 1, count=10).histogram("tracer.x", 0), ValueError, "1"),
    ],
)
def test_each_mistake_has_a_clear_text(m, call, kind, text):
    with pytest.raises(kind, match=text):
        call(m)
