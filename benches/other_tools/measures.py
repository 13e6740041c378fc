"""Runs of the three mechanisms in a simulation, and the report that `run_all.py` reads.

A simulation is an object with
    `advance()`: one step of time,
    `angles()`: angles of crank and rocker, the crank's counted over turns,
    `pins()`: the place of the pin by the coupler and by the rocker, in mm.
"""

import json
import math
import sys
from importlib.metadata import version

import mpmath

from mechanisms import (
    FOUR_BAR,
    PARALLELOGRAM,
    RPM,
    SHORT_ROCKER,
    START,
    away_from_change_point,
    exact,
    gap_of_points,
    is_crossed,
)


def largest_gap(simulation, turns, from_turn=0.0):
    """Returns the largest distance of the pins from `from_turn` until the crank has made so many turns."""
    first = simulation.angles()[0]
    gap = 0.0
    while True:
        simulation.advance()
        turned = (simulation.angles()[0] - first) / (2 * math.pi)
        if turned > turns:
            return gap
        if turned > from_turn:
            (ax, ay), (bx, by) = simulation.pins()
            gap = max(gap, math.hypot(ax - bx, ay - by))


def second_turn(make, step, rpm=RPM):
    return largest_gap(make(FOUR_BAR, step, rpm, START, strong=True), 2.0, 1.0)


def change_points(make, step, turns=10):
    """Counts how often a parallelogram becomes a crossed linkage, or back, in so many turns."""
    simulation = make(PARALLELOGRAM, step, RPM, START, strong=True)
    first = simulation.angles()[0]
    was, changes = False, 0
    while simulation.angles()[0] - first < turns * 2 * math.pi:
        simulation.advance()
        phi, psi = simulation.angles()
        if away_from_change_point(phi):
            changes += is_crossed(phi, psi) != was
            was = is_crossed(phi, psi)
    return changes


def unreachable(make, step, strong, rpm=RPM, turns=2):
    """Runs the mechanism that cannot turn for the time of so many turns: turns of the crank, and largest gap."""
    simulation = make(SHORT_ROCKER, step, rpm, math.radians(90.0), strong=strong)
    first = simulation.angles()[0]
    gap = 0.0
    for _ in range(round(turns * 60.0 / rpm / step)):
        simulation.advance()
        (ax, ay), (bx, by) = simulation.pins()
        gap = max(gap, math.hypot(ax - bx, ay - by))
    return (simulation.angles()[0] - first) / (2 * math.pi), gap


def report(package, **results):
    """Prints all results as one line of JSON, with the package's version and Python's."""
    results = {"package": package, "version": version(package), "python": sys.version.split()[0], **results}
    print(json.dumps(results))


class Positions:
    """Measures of a tool that solves positions: `solve(bar, phi, guess)` returns the pin, or raises `Open`."""

    class Open(Exception):
        """A position that the tool reports as unreachable; the message is what it returned."""

    def __init__(self, solve):
        self.solve = solve

    def path(self, bar, start, degrees, count):
        """Follows the pin from the closed position at `start` in steps of so many degrees: (phi, pin) each."""
        pin = tuple(float(x) for x in exact(bar, math.radians(start)).pin)
        for k in range(count + 1):
            phi = math.radians(start + k * degrees)
            pin = self.solve(bar, phi, pin)
            yield phi, pin

    def gap(self):
        worst = 0.0
        for phi, pin in self.path(FOUR_BAR, 30.0, 1.0, 720):
            a = FOUR_BAR.crank * mpmath.cos(mpmath.mpf(phi)), FOUR_BAR.crank * mpmath.sin(mpmath.mpf(phi))
            worst = max(worst, gap_of_points(FOUR_BAR, a, pin))
        return worst

    def changes(self, start):
        """Counts changes from a parallelogram to a crossed linkage, or back, in ten turns of 1 degree a step."""
        was, changes = False, 0
        for phi, pin in self.path(PARALLELOGRAM, start, 1.0, 3600):
            if away_from_change_point(phi):
                now = is_crossed(phi, math.atan2(pin[1], pin[0] - PARALLELOGRAM.frame))
                changes += now != was
                was = now
        return changes

    def unreachable(self):
        """Returns the last angle, in degrees, at which the short rocker closed, and what came at the next one."""
        last = 90.0
        try:
            for phi, _ in self.path(SHORT_ROCKER, 90.0, 0.1, 900):
                last = math.degrees(phi)
        except self.Open as open_:
            return last, str(open_)
        return last, "no sign"
