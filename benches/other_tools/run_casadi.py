"""CasADi: a root finder for the two angles, the last solution is the next guess; derivatives of the root finder.

Also its export to C, which is compiled with the system's compiler (`cc`).
"""

import ctypes
import math
import os
import pathlib
import subprocess
import tempfile

import casadi
import mpmath

from measures import Positions, report
from mechanisms import FOUR_BAR, PARALLELOGRAM, SHORT_ROCKER, exact, gap_of_angles


def function(solver, **options):
    unknown = casadi.SX.sym("unknown", 2)
    given = casadi.SX.sym("given", 5)
    phi, crank, coupler, rocker, frame = casadi.vertsplit(given)
    theta, psi = casadi.vertsplit(unknown)
    miss = casadi.vertcat(
        crank * casadi.cos(phi) + coupler * casadi.cos(theta) - frame - rocker * casadi.cos(psi),
        crank * casadi.sin(phi) + coupler * casadi.sin(theta) - rocker * casadi.sin(psi))
    return casadi.rootfinder("loop", solver, {"x": unknown, "p": given, "g": miss}, options)


def given(bar, phi):
    return [phi, bar.crank, bar.coupler, bar.rocker, bar.frame]


def solve_with(finder):
    def solve(bar, phi, guess):
        a = bar.crank * math.cos(phi), bar.crank * math.sin(phi)
        angles = [math.atan2(guess[1] - a[1], guess[0] - a[0]), math.atan2(guess[1], guess[0] - bar.frame)]
        try:
            theta, psi = finder(angles, given(bar, phi)).full().ravel()
        except RuntimeError as error:
            raise Positions.Open(type(error).__name__) from error
        return bar.frame + bar.rocker * math.cos(psi), bar.rocker * math.sin(psi)

    return solve


def angle_gap(finder):
    """The gap over one turn of 1 degree a step, of the angles themselves."""
    worst, angles = 0.0, [float(x) for x in (exact(FOUR_BAR, 0.5).theta, exact(FOUR_BAR, 0.5).psi)]
    for k in range(361):
        phi = 0.5 + math.radians(k)
        angles = finder(angles, given(FOUR_BAR, phi)).full().ravel()
        worst = max(worst, gap_of_angles(FOUR_BAR, phi, *angles))
    return worst


def jacobian(finder, bar, phi, angles):
    """Derivatives of both angles with respect to the crank's angle and the four lengths."""
    p = casadi.MX.sym("p", 5)
    return casadi.Function("j", [p], [casadi.jacobian(finder(angles, p), p)])(given(bar, phi))


def at_change_point(finder):
    """What comes for the derivatives of the parallelogram at 180 degrees, where the links are in a row."""
    try:
        return str(jacobian(finder, PARALLELOGRAM, math.pi, [0.0, math.pi])[1, 0])
    except RuntimeError as error:
        return type(error).__name__


def derivatives(finder):
    """Relative errors of psi by the crank's angle and by the coupler's length, at 1 radian."""
    start = exact(FOUR_BAR, 1.0)
    found = jacobian(finder, FOUR_BAR, 1.0, [float(start.theta), float(start.psi)])

    def psi(length):
        bar = type(FOUR_BAR)(FOUR_BAR.crank, length, FOUR_BAR.rocker, FOUR_BAR.frame)
        return exact(bar, 1.0).psi

    by_coupler = mpmath.diff(psi, mpmath.mpf(120))
    pairs = (found[1, 0], start.psi_1), (found[1, 2], by_coupler)
    return [float(abs(mpmath.mpf(float(value)) - true) / abs(true)) for value, true in pairs]


def exported(finder, bar, phi):
    """Returns the status of the exported C function and the angles that it wrote."""
    with tempfile.TemporaryDirectory() as folder:
        here = os.getcwd()
        os.chdir(folder)
        try:
            finder.generate("loop.c")
            subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-o", "loop.so", "loop.c", "-lm"], check=True)
            library = ctypes.CDLL(str(pathlib.Path(folder) / "loop.so"))
        finally:
            os.chdir(here)
    sizes = [ctypes.c_longlong() for _ in range(4)]
    library.loop_work(*(ctypes.byref(size) for size in sizes))
    n_arg, n_res, n_iw, n_w = (max(size.value, 1) for size in sizes)
    inputs = (ctypes.c_double * 2)(1.0, 1.5), (ctypes.c_double * 5)(*given(bar, phi))
    output = (ctypes.c_double * 2)()
    pointer = ctypes.POINTER(ctypes.c_double)
    arguments = (pointer * n_arg)(*(ctypes.cast(values, pointer) for values in inputs))
    results = (pointer * n_res)(ctypes.cast(output, pointer))
    work = (ctypes.c_double * n_w)()
    integers = (ctypes.c_longlong * n_iw)()
    status = library.loop(arguments, results, integers, work, 0)
    return status, gap_of_angles(bar, phi, *output)


def main():
    newton, fast = function("newton"), function("fast_newton")
    tool = Positions(solve_with(newton))
    status, gap = exported(fast, SHORT_ROCKER, math.radians(170.0))
    report("casadi", gap=angle_gap(newton), gap_fast=angle_gap(fast), changes=tool.changes(30.0),
           changes_off_grid=tool.changes(30.5), unreachable=tool.unreachable(),
           relative_errors=derivatives(newton), at_change_point=at_change_point(newton),
           exported_status=status, exported_gap=gap)


if __name__ == "__main__":
    main()
