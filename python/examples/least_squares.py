"""Finds dimensions for a path: `scipy.optimize.least_squares` with the exact Jacobian.

`python least_squares.py` prints the dimensions that were found.
"""

import linkage
import numpy as np
from scipy.optimize import least_squares

TEXT = """
pub struct FourBar {
    unit mm;
    param crank = 45mm;
    param coupler = 115mm;
    param rocker = 105mm;
    param arm = 66mm;
    input phi = 30deg in 0deg..360deg;
    unknown theta = 40deg;
    unknown psi = 80deg;
    let tracer = polar(crank, phi) + polar(arm, theta);
    loop polar(crank, phi) + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
}
impl FourBar { pub fn path(phi) -> Path { tracer, e: sensitivity(tracer) } }
"""


def problem(names, phi, wanted):
    """Returns residuals and their Jacobian as functions of the dimensions, both from one sweep."""
    m = linkage.parse(TEXT).assemble()
    last = {}

    def path(x):
        # The optimizer asks for the Jacobian at the position of the residuals.
        if last.get("x") != tuple(x):
            last.update(x=tuple(x), result=m.path(phi, **dict(zip(names, x))))
        return last["result"]

    def residuals(x):
        return (path(x).tracer - wanted).ravel()

    def jacobian(x):
        e = path(x).e
        return np.stack([e[name].ravel() for name in names], axis=-1)

    return residuals, jacobian


def main():
    """Recovers the dimensions from points of the path that they have."""
    names = ["crank", "coupler", "rocker", "arm"]
    right = np.array([50.0, 120.0, 100.0, 70.0])
    phi = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    wanted = linkage.parse(TEXT).assemble(**dict(zip(names, right))).path(phi).tracer
    residuals, jacobian = problem(names, phi, wanted)
    found = least_squares(residuals, [45.0, 115.0, 105.0, 66.0], jac=jacobian, xtol=1e-15, ftol=1e-15)
    print(f"{dict(zip(names, found.x.round(9)))} after {found.nfev} evaluations")
    return found.x - right


if __name__ == "__main__":
    main()
