"""Numbers are those of the macro's code, to the last bit, on all mechanisms of the repository.

`cargo run -p linkage-command --bin macro-values` prints the values to compare with; the variable
`LINKAGE_MACRO_VALUES` has the path of the file.
"""

import os

import linkage
import numpy as np
import pytest
from linkage import _text
from linkage._mechanism import Mechanism, Origin


def values() -> dict:
    """The lines of the file, by mechanism: its path and its number."""
    path = os.environ.get("LINKAGE_MACRO_VALUES")
    if path is None:
        return {}
    found = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            kind, source, index, function, *rows = line.rstrip("\n").split("\t")
            parts = [numbers(row) for row in rows]
            found.setdefault((source, int(index)), []).append((kind, int(function), parts))
    return found


def numbers(rows: str) -> np.ndarray:
    """Rows of numbers from the digits of their bits."""
    split = [[int(digits, 16) for digits in row.split(",") if digits] for row in rows.split(";")]
    return np.array(split, dtype=np.uint64).view(np.float64)


def same(found: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """True for equal bits; any NaN is as good as another."""
    bits = found.view(np.uint64) == expected.view(np.uint64)
    return bits | (np.isnan(found) & np.isnan(expected))


VALUES = values()


def mechanism(source: str, index: int, fused: bool | None = None) -> Mechanism:
    with open(source, encoding="utf-8") as file:
        text = file.read()
    native = _text._compiled(text, source, False, fused)[index]
    return Mechanism(native, Origin(text, source, native.name, False, fused))


def result(assembly, function: int, arguments: np.ndarray, sets: np.ndarray | None = None):
    """The columns of a function, one row for each position."""
    bound = assembly[list(assembly.mechanism.functions)[function]]
    named = {} if sets is None else dict(zip(assembly.mechanism.parameters, sets.T))
    found = bound(*arguments.T, **named)
    assert found.shape == (len(arguments),)
    return np.ascontiguousarray(np.array(list(found.columns.values())).T)


@pytest.mark.skipif(not VALUES, reason="LINKAGE_MACRO_VALUES is not set")
@pytest.mark.parametrize("key", VALUES, ids=lambda key: f"{os.path.basename(key[0])}-{key[1]}")
def test_numbers_are_those_of_the_macro(key):
    bar = mechanism(*key)
    assembly = bar.assemble()
    names = list(bar.functions)
    for kind, function, (*given, expected) in VALUES[key]:
        if kind == "call":
            found = assembly[names[function]](*given[0].reshape(-1))
            assert found.shape == ()
            found = np.array(list(found.columns.values())).reshape(1, -1)
        elif kind == "sweep":
            for count in (1, 3):
                linkage.set_threads(count)
                found = result(assembly, function, given[0])
                assert same(found, expected).all(), (kind, names[function], count)
        else:
            found = result(assembly, function, given[1], given[0])
        if kind == "near":
            assert (np.isnan(found) == np.isnan(expected)).all()
            size = np.nanmax(np.abs(expected), axis=1, keepdims=True, initial=1.0)
            near = np.abs(found - expected) <= 1e-9 * size
            assert (near | np.isnan(expected)).all(), names[function]
        else:
            assert same(found, expected).all(), (kind, names[function])


def test_all_kinds_of_values_are_compared():
    if "LINKAGE_MACRO_VALUES" not in os.environ:
        pytest.skip("LINKAGE_MACRO_VALUES is not set")
    kinds = {kind for lines in VALUES.values() for kind, *_ in lines}
    assert kinds == {"call", "sweep", "sets", "near"}
    assert len(VALUES) > 25


@pytest.mark.parametrize("count", [1, 2, 5])
def test_rows_do_not_depend_on_threads_or_length(m, count):
    phi = np.linspace(-1.0, 8.0, 30_001)
    linkage.set_threads(1)
    whole = m.motion(phi)
    linkage.set_threads(count)
    assert same(m.motion(phi)._numbers, whole._numbers).all()
    part = m.motion(phi[17_000:17_003])
    assert same(part._numbers, np.ascontiguousarray(whole._numbers[:, 17_000:17_003])).all()
    crank = np.linspace(45.0, 55.0, phi.size)
    many = m.motion(phi, crank=crank)
    linkage.set_threads(1)
    assert same(many._numbers, m.motion(phi, crank=crank)._numbers).all()
