"""Mechanisms that several tests use."""

import os
import signal
import threading
import time
from pathlib import Path

import _thread
import linkage
import pytest

#: The root of the repository.
ROOT = Path(__file__).resolve().parents[2]

FOUR_BAR = """
pub struct FourBar {
    unit mm;
    param crank = 50mm +- 12um;
    param coupler = 120mm +- 20um;
    param rocker = 100mm +- 20um;
    param pivot = (140mm, 0mm);
    input phi = 30deg in 0deg..360deg;
    unknown theta = 40deg;
    unknown psi = 80deg;
    let tracer = polar(crank, phi) + polar(70mm, theta);
    loop polar(crank, phi) + polar(coupler, theta) = pivot + polar(rocker, psi);
}
impl FourBar {
    pub fn motion(phi) -> Motion {
        tracer, psi, v: velocity(psi), a: acceleration(psi), e: sensitivity(psi),
        to: sensitivity(tracer),
    }
    pub fn path(phi) -> Path { tracer }
}
"""

#: Its range is longer than its links reach.
ROCKING = """
pub struct Rocking {
    unit mm;
    param crank = 90mm;
    input phi = 50deg in 0deg..360deg;
    unknown theta = 10deg;
    unknown psi = 60deg;
    loop polar(crank, phi) + polar(30mm, theta) = (100mm, 0) + polar(90mm, psi);
}
impl Rocking { pub fn motion(phi) -> Motion { psi, v: velocity(psi), margin: margin() } }
"""


@pytest.fixture(scope="session")
def bar():
    return linkage.parse(FOUR_BAR)


@pytest.fixture(scope="session")
def m(bar):
    return bar.assemble()


@pytest.fixture(scope="session")
def rocking():
    return linkage.parse(ROCKING, any_range=True)


@pytest.fixture(autouse=True)
def _default_threads():
    yield
    linkage.set_threads(None)


@pytest.fixture
def ctrl_c():
    """A function that interrupts the test after so many seconds, as Ctrl-C does."""
    timers = []

    def start(seconds: float):
        timers.append(threading.Timer(seconds, _thread.interrupt_main))
        timers[-1].start()

    # A process in the background of a shell begins with the signal ignored, and then nothing arrives.
    earlier = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield start
    for timer in timers:
        timer.join()
    signal.signal(signal.SIGINT, earlier)


@pytest.fixture
def interrupted(ctrl_c):
    """A function that runs `call(progress)`, interrupts it after its first news, and returns the last ones."""

    def run(call):
        seen = []

        def progress(*news):
            if not seen:
                ctrl_c(0.2)
            seen.append(news)

        began = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            call(progress)
        assert time.perf_counter() - began < 30
        return seen[-1]

    return run


def required(name: str) -> bool:
    """True if a part of the tests must run, as in CI."""
    return os.environ.get(name) == "required"
