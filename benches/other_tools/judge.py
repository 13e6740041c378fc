"""Proofs, by the interval arithmetic of codac, that a linkage closes at an angle of its crank or that it cannot.

A box without a solution is contracted to nothing, which proves that nothing is in it; a box that the Krawczyk operator
maps into its own interior has a solution in it. Dimensions and angle are doubles and count as exact numbers, every
rounding is outwards.
"""

import math

from codac import AnalyticFunction, CtcInverse, Interval, IntervalMatrix, IntervalVector, VectorVar, cos, sin, vec

CLOSES, CANNOT, UNDECIDED = "closes", "cannot close", "undecided"
# A box this small, in radians or as a part of the largest length, is no longer halved.
SMALLEST = 1e-12
MOST_BOXES = 4_000
TURN = Interval(-math.pi - 1e-9, math.pi + 1e-9)


def four_bar(crank, coupler, rocker, frame, phi):
    """Returns the closure equations of the angles of coupler and rocker, and the box in which they are searched."""
    x = VectorVar(2)
    phi = Interval(phi)
    ax, ay = crank * cos(phi), crank * sin(phi)
    function = AnalyticFunction([x], vec(
        ax - frame + coupler * cos(x[0]) - rocker * cos(x[1]), ay + coupler * sin(x[0]) - rocker * sin(x[1])))
    return function, IntervalVector([TURN, TURN])


def slider_crank(crank, rod, offset, phi):
    """The same of the rod's angle and of the slide, which is counted in lengths of the rod."""
    x = VectorVar(2)
    phi = Interval(phi)
    ax, ay = crank * cos(phi), crank * sin(phi)
    function = AnalyticFunction([x], vec(ax + rod * cos(x[0]) - rod * x[1], ay + rod * sin(x[0]) - offset))
    reach = 1.01 * (crank + rod) / rod
    return function, IntervalVector([TURN, Interval(-reach, reach)])


def krawczyk(function, box):
    """Returns the operator's box, or `None` where the Jacobian in the middle has no inverse."""
    middle = IntervalVector(box.mid())
    jacobian = function.diff(middle)
    a, b, c, d = (jacobian[i, j].mid() for i in (0, 1) for j in (0, 1))
    determinant = a * d - b * c
    if determinant == 0.0:
        return None
    inverse = IntervalMatrix([[Interval(d / determinant), Interval(-b / determinant)],
                              [Interval(-c / determinant), Interval(a / determinant)]])
    rest = IntervalMatrix.eye(2, 2) - inverse * function.diff(box)
    return middle - inverse * function.eval(middle) + rest * (box - middle)


def judge(function, start):
    """Returns `CLOSES`, `CANNOT` or `UNDECIDED`, and the number of boxes that were looked at."""
    contractor = CtcInverse(function, [0.0, 0.0])
    stack, count, undecided = [start], 0, False
    while stack:
        box = stack.pop()
        count += 1
        if count > MOST_BOXES:
            return UNDECIDED, count
        contractor.contract(box)
        if box.is_empty():
            continue
        # Contraction may leave no more than roundings: a little room lets the operator prove the solution.
        wide = IntervalVector(box).inflate(0.05 * box.max_diam() + 1e-14)
        image = krawczyk(function, wide)
        if image is not None:
            if image.is_strict_interior_subset(wide):
                return CLOSES, count
            box &= image
            if box.is_empty():
                continue
        if box.max_diam() < SMALLEST:
            undecided = True
            continue
        stack.extend(box.bisect_largest(0.49))
    return (UNDECIDED if undecided else CANNOT), count
