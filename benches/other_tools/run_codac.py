"""codac: a proof that the short rocker cannot close at 170 degrees, and at any angle of the stretch out of reach."""

import math
import statistics
import time

from codac import AnalyticFunction, CtcInverse, Interval, IntervalVector, VectorVar, cos, sin, vec

from judge import CANNOT, CLOSES, TURN, four_bar, judge
from measures import report
from mechanisms import SHORT_ROCKER

BAR = SHORT_ROCKER.crank, SHORT_ROCKER.coupler, SHORT_ROCKER.rocker, SHORT_ROCKER.frame
LIMIT = math.acos((BAR[0] ** 2 + BAR[3] ** 2 - (BAR[1] + BAR[2]) ** 2) / (2 * BAR[0] * BAR[3]))


def nearest():
    """Returns the smallest power of ten, in rad from the limit, at which both sides are proved."""
    for exponent in range(1, 16):
        sides = [judge(*four_bar(*BAR, LIMIT + s * 10.0**-exponent))[0] for s in (-1, 1)]
        if sides != [CLOSES, CANNOT]:
            return 1 - exponent
    return -15


def whole_stretch(margin):
    """Returns whether no angle closes from the limit plus `margin` to its mirror image, and the boxes it took."""
    x = VectorVar(3)
    crank, coupler, rocker, frame = BAR
    function = AnalyticFunction([x], vec(
        crank * cos(x[2]) + coupler * cos(x[0]) - frame - rocker * cos(x[1]),
        crank * sin(x[2]) + coupler * sin(x[0]) - rocker * sin(x[1])))
    contractor = CtcInverse(function, [0.0, 0.0])
    stretch = Interval(LIMIT + margin, 2 * math.pi - LIMIT - margin)
    stack, count = [IntervalVector([TURN, TURN, stretch])], 0
    while stack:
        box = stack.pop()
        count += 1
        contractor.contract(box)
        if box.is_empty():
            continue
        if box.max_diam() < 1e-9 or count > 100_000:
            return False, count
        stack.extend(box.bisect_largest(0.49))
    return True, count


def main():
    times = []
    for _ in range(20):
        begin = time.perf_counter()
        verdict, boxes = judge(*four_bar(*BAR, math.radians(170.0)))
        times.append(time.perf_counter() - begin)
    report("codac", verdict=verdict, boxes=boxes, seconds=statistics.median(times), nearest=nearest(),
           whole_stretch=whole_stretch(1e-4))


if __name__ == "__main__":
    main()
