"""Mistakes are exceptions with clear texts."""

import os
import subprocess
import sys
import textwrap
import time

import linkage
import numpy as np
import pytest


def test_mistakes_of_a_text_have_their_lines():
    text = "pub struct A {\n    unit mm;\n    param r = 30parsec;\n    param s = zz;\n}"
    with pytest.raises(linkage.CompileError) as caught:
        linkage.parse(text)
    error = caught.value
    assert error.line == 3 and error.messages[0].column == 15
    assert error.messages[0].text.startswith("unknown unit `parsec`")
    assert [one.line for one in error.messages] == [3, 4]
    assert "3 |     param r = 30parsec;" in str(error)
    with pytest.raises(linkage.CompileError) as caught:
        linkage.parse("pub struct A {\n (")
    assert caught.value.line == 2


def test_one_of_several_mechanisms_is_chosen():
    text = "struct A { unit mm; param r = 1mm; } struct B { unit mm; param r = 2mm; }"
    assert linkage.parse(text).name == "B"
    assert linkage.parse(text, "A").parameters["r"].nominal == 1.0
    assert list(linkage.parse_all(text)) == ["A", "B"]
    with pytest.raises(linkage.CompileError, match="no mechanism `C`; it has `A`, `B`"):
        linkage.parse(text, "C")


def test_a_missing_file_and_no_text():
    with pytest.raises(FileNotFoundError):
        linkage.load("missing.mech")
    with pytest.raises(TypeError, match="a text is a `str`"):
        linkage.parse(b"struct A {}")


@pytest.mark.parametrize(
    ("call", "kind", "text"),
    [
        (lambda m: m.motion(), TypeError, "`motion` needs the argument `phi`"),
        (lambda m: m.motion(1, 2), TypeError, "2 arguments are too many"),
        (lambda m: m.motion(1, phi=2), TypeError, "given twice"),
        (lambda m: m.motion(1, crnk=2), TypeError, "help: `crank` is similar"),
        (lambda m: m.motion("51 mm"), TypeError, "`phi` takes real numbers, not `str`"),
        (lambda m: m.motion(1, crank="51 mm"), TypeError, "help: write the number in mm"),
        (lambda m: m.motion(1j), TypeError, "real numbers"),
        (lambda m: m.motion(None), TypeError, "real numbers"),
        (lambda m: m.motion([[1], [1, 2]]), ValueError, "`phi`"),
        (lambda m: m.motion([1, 2], crank=[1, 2, 3]), ValueError, r"`phi` \(2,\), `crank` \(3,\)"),
        (lambda m: m.motion(1, pivot=[1, 2, 3]), ValueError, "the last axis has 2 components"),
        (lambda m: m.motion(1, pivot=[1, 2], pivot_x=1), TypeError, "`pivot.x` is given twice"),
        (lambda m: m.moton, AttributeError, "help: `motion` is similar"),
        (lambda m: m["moton"], KeyError, "no function `moton`"),
        (lambda m: m.motion(1).trcer, AttributeError, "help: `tracer` is similar"),
        (lambda m: m.motion(1)["trcer"], KeyError, "no field `trcer`"),
        (lambda m: m.motion(1).e["x"], KeyError, "no entry `x`"),
        (lambda m: m.gaps(1, 2), TypeError, "2 are too many"),
        (lambda m: m.gaps(psi=1), TypeError, "no input `psi`"),
        (lambda m: m.tolerance("path", 1), linkage.AnalysisError, "has no sensitivities"),
        (lambda m: m.summary("path", "tracer.x"), linkage.AnalysisError, "velocity"),
        (lambda m: m.summary("motion", "x"), linkage.AnalysisError, "no number `x`"),
        (lambda m: m.summary("motion", "psi", range=(1, 1)), linkage.AnalysisError, "range"),
        (lambda m: m.page(1), linkage.LinkageError, "at least 2"),
        (lambda m: m.mechanism.assemble(crank=[1, 2]), ValueError, "is one number"),
        (lambda m: m.mechanism.assemble(crank=1000), linkage.AssemblyError, "cannot close"),
        (lambda m: m.mechanism.assemble(crank=np.nan), linkage.AssemblyError, "NaN"),
        (lambda m: m.mechanism.assemble(crnk=1), TypeError, "help: `crank` is similar"),
        (lambda m: m.mechanism.to_c(scalar="half"), ValueError, "no scalar `half`"),
        (
            lambda m: m.mechanism.with_tolerances(crank=-1).assemble().tolerance("motion", 1),
            linkage.AnalysisError,
            "crank",
        ),
        (lambda m: linkage.set_threads(0), ValueError, "at least 1"),
    ],
)
def test_each_mistake_has_a_clear_text(m, call, kind, text):
    with pytest.raises(kind, match=text):
        call(m)


def test_nan_arguments_give_nan(m):
    psi = m.motion([1.0, np.nan, 2.0]).psi
    assert np.isfinite(psi[[0, 2]]).all() and np.isnan(psi[1])
    assert np.isnan(m.motion(1.0, crank=[np.nan, 1e6]).psi).all()


def test_nothing_half_written_stays(bar, tmp_path):
    (tmp_path / "file").write_text("x", encoding="utf-8")
    with pytest.raises(OSError):
        bar.to_c(tmp_path / "file")
    folder = tmp_path / "c"
    (folder / "four_bar.c").mkdir(parents=True)
    with pytest.raises(OSError):
        bar.to_c(folder)
    assert sorted(path.name for path in folder.iterdir()) == ["four_bar.c", "four_bar.h"]


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_ends_a_long_sweep(m, threads, ctrl_c):
    linkage.set_threads(threads)
    phi = np.zeros(20_000_000) if threads == 1 else np.zeros(30_000_000)
    m.path(phi[:10])
    began = time.perf_counter()
    ctrl_c(0.2)
    with pytest.raises(KeyboardInterrupt):
        # Long enough on any machine: each round is a fraction of a second.
        for _ in range(1000):
            m.motion(phi)
    assert time.perf_counter() - began < 30
    assert np.isfinite(m.motion(1.0).psi)


def test_memory_that_is_not_there_is_an_exception():
    program = """
    import resource, numpy as np, linkage
    from conftest import FOUR_BAR
    m = linkage.parse(FOUR_BAR).assemble()
    phi = np.zeros(1)
    resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
    try:
        m.motion(np.broadcast_to(phi, (1_000_000_000,)), crank=phi)
    except MemoryError:
        print("caught", m.motion(1.0).psi > 0)
    """
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.path.dirname(__file__), *sys.path])}
    command = [sys.executable, "-c", textwrap.dedent(program)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.stdout.split() == ["caught", "True"], done.stderr
