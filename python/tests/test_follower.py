"""Followers go where tables end, and stay on their assembly."""

import linkage
import numpy as np
import pytest
from conftest import ROOT


def test_a_platform_is_followed_beyond_its_table():
    bar = linkage.load(ROOT / "mechanisms" / "five_link_axle.rs")
    m = bar.assemble()
    name = next(iter(bar.functions))
    inputs = {one: value.reference for one, value in bar.inputs.items()}
    follower = m.follow()
    assert follower.inputs == inputs
    moved = next(iter(bar.inputs.values()))
    reach = np.linspace(moved.low, moved.high, 9)[1:-1]
    for value in reach:
        follower.go(**{moved.name: value})
        assert follower.inputs[moved.name] == value
        found, expected = follower[name](), m[name](**follower_arguments(bar, name, follower))
        assert np.allclose(found._numbers, expected._numbers, rtol=1e-9, atol=1e-9)
    with pytest.raises(linkage.AssemblyError, match="cannot be followed beyond"):
        follower.go(**{moved.name: moved.high + 1e4 * (moved.high - moved.low)})
    # It stays where it was.
    assert follower.inputs[moved.name] == reach[-1]


def follower_arguments(bar, name, follower):
    names = {one.name for one in bar.functions[name].arguments}
    return {one: value for one, value in follower.inputs.items() if one in names}


def test_closed_forms_go_anywhere(m):
    follower = m.follow(1.0)
    assert follower.motion().psi == m.motion(1.0).psi
    assert follower.go(2.0).motion().psi == m.motion(2.0).psi
    assert "motion" in dir(follower) and "phi=2" in repr(follower)
    with pytest.raises(TypeError, match="`phi` is that of the follower"):
        follower.motion(phi=1.0)
    with pytest.raises(AttributeError, match="help: `motion` is similar"):
        follower.moton()
