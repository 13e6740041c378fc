"""Machine code of the system's C compiler: equal to the interpreter to the last bit."""

import os
import pickle

import linkage
import numpy as np
import pytest
from conftest import ROOT, required
from linkage import _compiled


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    try:
        _compiled._compiler(None)
    except linkage.LinkageError:
        if required("LINKAGE_CC"):
            raise
        pytest.skip("no C compiler")
    return tmp_path_factory.mktemp("cache")


def same(found, expected) -> bool:
    bits = found._numbers.view(np.uint64) == expected._numbers.view(np.uint64)
    return (bits | (np.isnan(found._numbers) & np.isnan(expected._numbers))).all()


FILES = ["quick_return", "spatial_slider_crank", "two_crank_triad", "burmester"]

#: Its group has no closed form.
COUPLED = ["two_crank_triad"]


@pytest.mark.parametrize("name", FILES)
def test_sweeps_have_the_bits_of_the_interpreter(cache, name):
    path = ROOT / "mechanisms" / f"{name}.rs"
    interpreted = linkage.load(path, fused=False)
    compiled = linkage.load(path).compile(cache=cache)
    assert compiled.is_compiled and not interpreted.is_compiled
    random = np.random.default_rng(3)
    m, i = compiled.assemble(), interpreted.assemble()
    for function in compiled.functions.values():
        arguments = []
        for argument in function.arguments:
            driven = compiled.inputs.get(argument.name)
            low, high = (driven.low, driven.high) if driven else (-20.0, 20.0)
            beyond = 0.02 * (high - low)
            arguments.append(random.uniform(low - beyond, high + beyond, 70_001))
        for threads in (1, 3):
            linkage.set_threads(threads)
            found, expected = m[function.name](*arguments), i[function.name](*arguments)
            if name in COUPLED:
                # Tables of the export are made with the arithmetic of the build.
                assert np.allclose(
                    found._numbers, expected._numbers, rtol=1e-9, atol=1e-9, equal_nan=True
                )
            else:
                assert same(found, expected), function.name
        if len(arguments) > 1 and name not in COUPLED:
            arguments[-1] = 1.5
            assert same(m[function.name](*arguments), i[function.name](*arguments))
    assert m._machine is not None


def test_dimensions_and_other_assemblies_stay_right(cache, bar):
    compiled = bar.compile(cache=cache)
    interpreted = linkage.parse(bar.source, fused=False)
    phi = np.linspace(0, 6, 1000)
    m, i = compiled.assemble(crank=51.0), interpreted.assemble(crank=51.0)
    assert same(m.motion(phi), i.motion(phi))
    assert same(m.motion(phi, crank=np.linspace(49, 51, 1000)), i.motion(phi, crank=np.linspace(49, 51, 1000)))
    assert same(m.motion(1.2), i.motion(1.2))
    assert same(m.motion([1.2]), i.motion([1.2]))
    other = compiled.assemblies()[1]
    assert same(other.motion(phi), interpreted.assemblies()[1].motion(phi))
    assert m.motion(np.empty(0)).psi.shape == (0,)


@pytest.mark.parametrize("name", FILES)
def test_sweeps_over_dimensions_have_the_bits_of_the_interpreter(cache, name):
    path = ROOT / "mechanisms" / f"{name}.rs"
    interpreted = linkage.load(path, fused=False)
    compiled = linkage.load(path).compile(cache=cache)
    random = np.random.default_rng(4)
    count = 40_001
    m, i = compiled.assemble(), interpreted.assemble()
    dimensions = {}
    for k, one in enumerate(compiled.parameters.values()):
        if k % 3 < 2:
            off = 0.05 * abs(one.nominal) + (0.01 if one.nominal == 0 else 0.0)
            alias = one.name.replace(".", "_")
            dimensions[alias] = one.nominal + off * random.uniform(-1, 1, count)
    for function in compiled.functions.values():
        arguments = []
        for argument in function.arguments:
            driven = compiled.inputs.get(argument.name)
            low, high = (driven.low, driven.high) if driven else (-20.0, 20.0)
            arguments.append(random.uniform(low, high, count))
        index = function.index
        assert (m.mechanism._code.sets[index] is None) == (name in COUPLED), function.name
        linkage.set_threads(3)
        found, expected = m[function.name](*arguments, **dimensions), i[function.name](*arguments, **dimensions)
        assert same(found, expected), function.name
        assert np.isfinite(expected._numbers).any()
        arguments = [0.5 * (one.low + one.high) for one in compiled.inputs.values()][: len(arguments)]
        if len(arguments) == len(function.arguments):
            found, expected = m[function.name](*arguments, **dimensions), i[function.name](*arguments, **dimensions)
            assert same(found, expected), function.name


def test_equal_mechanisms_are_compiled_once(cache, bar, monkeypatch):
    bar.compile(cache=cache)
    built = []
    run = _compiled.subprocess.run
    def counted(command, **options):
        built.append(command)
        return run(command, **options)
    monkeypatch.setattr(_compiled.subprocess, "run", counted)
    again = pickle.loads(pickle.dumps(bar.compile(cache=cache)))
    assert again.is_compiled and again == bar.compile(cache=cache) and again != bar
    assert all(command[1:] == ["--version"] for command in built)


def test_a_missing_and_a_failing_compiler(bar, tmp_path, monkeypatch):
    with pytest.raises(linkage.LinkageError, match="no C compiler: `nothing` is found"):
        bar.compile(compiler="nothing")
    failing = tmp_path / "failing"
    failing.write_text("#!/bin/sh\necho it is broken >&2\nexit 1\n", encoding="utf-8")
    os.chmod(failing, 0o755)
    with pytest.raises(linkage.LinkageError, match="it is broken"):
        bar.compile(compiler=str(failing), cache=tmp_path / "cache")
    assert not list((tmp_path / "cache").iterdir())
