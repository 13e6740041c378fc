"""Uncertain numbers as arguments and dimensions."""

import linkage
import numpy as np
import pytest

NEAR_DEAD_POINT = """
struct Slider { unit mm; param crank = 30mm; param rod = 50mm; input s = 79mm in 40mm..79.9mm;
unknown phi = 5deg; unknown theta = -5deg;
loop polar(crank, phi) + polar(rod, theta) = (s, 0); }
impl Slider { fn angle(s) -> Angle { phi } }
"""


def test_numbers_of_uncertainties(bar, m):
    uncertainties = pytest.importorskip("uncertainties")
    crank = uncertainties.ufloat(50.0, 0.01)
    rocker = uncertainties.ufloat(100.0, 0.02)
    r = m.motion(1.2, crank=crank, rocker=rocker)
    exact = m.motion(1.2)
    assert r.psi.nominal_value == pytest.approx(exact.psi, abs=1e-15)
    assert r.psi.derivatives[crank] == pytest.approx(exact.e["crank"], rel=1e-13)
    assert r.psi.derivatives[rocker] == pytest.approx(exact.e["rocker"], rel=1e-13)
    assert r.tracer.shape == (2,)
    assert r.tracer[1].derivatives[crank] == pytest.approx(exact.to["crank"][1], rel=1e-13)
    # Correlations are kept: what the crank does twice cancels.
    assert (r.psi - exact.e["crank"] * crank).derivatives[crank] == pytest.approx(0, abs=1e-15)
    turned = m.motion(uncertainties.ufloat(1.2, 0.001))
    assert turned.psi.std_dev == pytest.approx(0.001 * abs(exact.v), rel=1e-12)
    assert turned.v.std_dev == pytest.approx(0.001 * abs(exact.a), rel=1e-12)


def test_beyond_a_dead_point_nothing_is_certain():
    uncertainties = pytest.importorskip("uncertainties")
    bar = linkage.parse(NEAR_DEAD_POINT)
    m = bar.assemble()
    s = uncertainties.ufloat(79.0, 0.001)
    found = m.angle(s).phi
    step = 1e-6
    slope = (m.angle(79.0 + step).phi - m.angle(79.0 - step).phi) / (2 * step)
    assert found.std_dev == pytest.approx(0.001 * abs(slope), rel=1e-6)
    assert np.isnan(m.angle(uncertainties.ufloat(85.0, 0.001)).phi.nominal_value)


def test_numbers_of_gtc(m):
    gtc = pytest.importorskip("GTC")
    crank, phi = gtc.ureal(50.0, 0.01), gtc.ureal(1.2, 0.001)
    r = m.motion(phi, crank=crank)
    exact = m.motion(1.2)
    assert gtc.component(r.psi, crank) == pytest.approx(0.01 * abs(exact.e["crank"]), rel=1e-12)
    assert gtc.component(r.psi, phi) == pytest.approx(0.001 * abs(exact.v), rel=1e-12)


def test_mistakes(m):
    uncertainties = pytest.importorskip("uncertainties")
    crank = uncertainties.ufloat(50.0, 0.01)
    with pytest.raises(ValueError, match="do not go together"):
        m.motion([1.0, 2.0], crank=crank)
    with pytest.raises(TypeError, match="no argument or dimension `crnk`"):
        m.motion(1.0, crnk=crank)
