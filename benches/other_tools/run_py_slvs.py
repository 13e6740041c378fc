"""py-slvs, the solver of SolveSpace: two distances from fixed points, the last solution is the next guess."""

import math

from py_slvs import slvs

from measures import Positions, report
from mechanisms import PARALLELOGRAM


def attempt(bar, phi, guess):
    """Returns the solver's code, 0 if it is content, and the point that it leaves."""
    system = slvs.System()
    origin = system.addPoint3dV(0.0, 0.0, 0.0, group=1)
    plane = system.addWorkplane(origin, system.addNormal3dV(1.0, 0.0, 0.0, 0.0, group=1), group=1)
    a = system.addPoint2dV(plane, bar.crank * math.cos(phi), bar.crank * math.sin(phi), group=1)
    d = system.addPoint2dV(plane, bar.frame, 0.0, group=1)
    u, v = system.addParamV(guess[0], group=2), system.addParamV(guess[1], group=2)
    pin = system.addPoint2d(plane, u, v, group=2)
    system.addPointsDistance(bar.coupler, a, pin, plane, group=2)
    system.addPointsDistance(bar.rocker, d, pin, plane, group=2)
    code = system.solve(group=2)
    return code, (system.getParam(u).val, system.getParam(v).val)


def solve(bar, phi, guess):
    code, pin = attempt(bar, phi, guess)
    if code not in (0, 5):
        raise Positions.Open(f"code {code}")
    return pin


def main():
    tool = Positions(solve)
    code, _ = attempt(PARALLELOGRAM, math.pi, (-190.0 + 280.0, 0.0))
    report("py-slvs", gap=tool.gap(), changes=tool.changes(30.0), changes_off_grid=tool.changes(30.5),
           unreachable=tool.unreachable(), code_at_change_point=code)


if __name__ == "__main__":
    main()
