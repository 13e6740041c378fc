"""pylinkage: a crank and an RRR dyad, steps of 1 degree; positions by `step`, and by its compiled `step_fast`."""

import math

import mpmath
import numpy as np
from pylinkage.actuators import Crank
from pylinkage.components import Ground
from pylinkage.dyads import RRRDyad
from pylinkage.simulation import Linkage

from measures import report
from mechanisms import (
    FOUR_BAR,
    PARALLELOGRAM,
    SHORT_ROCKER,
    FourBar,
    away_from_change_point,
    exact,
    gap_of_points,
    is_crossed,
)


class Model:
    def __init__(self, bar, start, step=1.0):
        base, end = Ground(0.0, 0.0), Ground(bar.frame, 0.0)
        self.crank = Crank(base, bar.crank, angular_velocity=math.radians(step), initial_angle=math.radians(start))
        pin = tuple(float(x) for x in exact(bar, math.radians(start)).pin)
        self.rocker = RRRDyad(self.crank.output, end, bar.coupler, bar.rocker, *pin)
        self.linkage = Linkage([base, end, self.crank, self.rocker])

    def rows(self, count):
        for row in self.linkage.step(count):
            yield row[2], row[3]


def gap():
    model = Model(FOUR_BAR, 30.0)
    list(model.rows(360))
    return max(gap_of_points(FOUR_BAR, a, pin) for a, pin in model.rows(360))


def changes(start):
    was, count = False, 0
    for a, pin in Model(PARALLELOGRAM, start).rows(3600):
        phi = math.atan2(a[1], a[0])
        if away_from_change_point(phi):
            now = is_crossed(phi, math.atan2(pin[1], pin[0] - PARALLELOGRAM.frame))
            count += now != was
            was = now
    return count


def unreachable():
    """Returns the last closed angle and the exception of `step`, and what `step_fast` returns through the gap."""
    model, last = Model(SHORT_ROCKER, 90.0, 0.1), 90.0
    try:
        for a, _ in model.rows(900):
            last = math.degrees(math.atan2(a[1], a[0]))
        error = "no sign"
    except Exception as found:  # Its class is what is wanted.
        error = type(found).__name__
    pins = Model(SHORT_ROCKER, 90.0, 1.0).linkage.step_fast(360)[:, 3]
    return last, error, int(np.isnan(pins).any(axis=1).sum())


def velocity_error():
    """Relative error of the pin's velocity at 1 rad/s, largest over a turn, and what comes at a change point."""
    model = Model(FOUR_BAR, 30.0)
    model.linkage.set_input_velocity(model.crank, 1.0)
    worst = 0.0
    for (positions, velocities, _) in model.linkage.step_with_derivatives(360):
        (ax, ay), v = positions[2], velocities[3]
        true = exact(FOUR_BAR, mpmath.atan2(ay, ax))
        speed = FOUR_BAR.rocker * abs(true.psi_1)
        miss = abs(mpmath.hypot(*v) - speed)
        worst = max(worst, float(miss / FOUR_BAR.rocker))
    at = Model(PARALLELOGRAM, 179.0)
    at.linkage.set_input_velocity(at.crank, 1.0)
    rows = [velocities[3] for _, velocities, _ in at.linkage.step_with_derivatives(3)]
    return worst, [str(row) for row in rows]


def sensitivity():
    """The analysis' number for the coupler's length, and the true derivative of the pin, averaged over a turn."""
    model = Model(FOUR_BAR, 30.0)
    analysis = model.linkage.analyze_sensitivity(model.rocker)
    number = next(value for name, value in analysis.sensitivities.items() if name.endswith("dist1"))

    def pin(phi, axis):
        return lambda length: exact(FourBar(FOUR_BAR.crank, length, FOUR_BAR.rocker, FOUR_BAR.frame), phi).pin[axis]

    length = mpmath.mpf(FOUR_BAR.coupler)
    true = [mpmath.hypot(*(mpmath.diff(pin(math.radians(k), axis), length) for axis in (0, 1)))
            for k in range(0, 360, 5)]
    return float(number), float(sum(true) / len(true))


def main():
    report("pylinkage", gap=gap(), changes=changes(30.0), changes_off_grid=changes(30.5), unreachable=unreachable(),
           velocity=velocity_error(), sensitivity=sensitivity())


if __name__ == "__main__":
    main()
