"""SUNDIALS through CasADi: IDA on the equations of index 1, and CVODE on accelerations from a linear system.

Right sides and Jacobians are derived by CasADi and compiled by the C compiler (`cc`).
"""

import os
import tempfile

import casadi

from measures import report, sweep
from problems import PROBLEMS

TOLERANCES = [10.0 ** -digits for digits in range(3, 14)]


def equations(problem):
    """Lagrange's equations with multipliers: `M w + h - Q + G' lambda`, and the second derivative of the gaps."""
    count = len(problem.bodies)
    q, v, w = (casadi.SX.sym(name, count) for name in "qvw")

    def place(index, point):
        """A point in the frame of a body, by the coordinates of the body and its parents."""
        found = casadi.DM([0.0, 0.0])
        while index >= 0:
            body = problem.bodies[index]
            if body.slides:
                arm = casadi.vertcat(point[0] + q[index], point[1])
            else:
                c, s = casadi.cos(q[index]), casadi.sin(q[index])
                arm = casadi.vertcat(c * point[0] - s * point[1], s * point[0] + c * point[1])
            found, point, index = found + arm, body.pivot, body.parent
        return found + casadi.DM(point)

    kinetic, potential = 0, -problem.torque * q[0]
    for index, body in enumerate(problem.bodies):
        centre = place(index, body.centre)
        rate = casadi.jtimes(centre, q, v)
        kinetic += body.mass * casadi.dot(rate, rate) / 2
        potential += body.mass * problem.gravity * centre[1]
        if not body.slides:
            kinetic += body.inertia * v[index] ** 2 / 2
    if problem.spring:
        body, point, fixed, stiffness, free = problem.spring
        potential += stiffness / 2 * (casadi.norm_2(place(body, point) - casadi.DM(fixed)) - free) ** 2
    gaps = casadi.vertcat(*[place(a, p) - place(b, r) for a, p, b, r in problem.closures])
    multipliers = casadi.SX.sym("lambda", gaps.shape[0])
    momentum = casadi.gradient(kinetic, v)
    balance = (casadi.jtimes(momentum, v, w) + casadi.jtimes(momentum, q, v)
               - casadi.gradient(kinetic - potential, q) + casadi.jtimes(gaps, q, multipliers, True))
    rate = casadi.jtimes(gaps, q, v)
    bend = casadi.jtimes(rate, q, v) + casadi.jtimes(rate, v, w)
    return q, v, w, multipliers, casadi.simplify(casadi.vertcat(balance, bend))


def compiled():
    return {"jit": True, "compiler": "shell", "jit_options": {"flags": ["-O3"]}}


def prepare(problem, tolerance, solver):
    q, v, w, multipliers, residual = equations(problem)
    unknown = casadi.vertcat(w, multipliers)
    state = casadi.vertcat(q, v)
    matrix = casadi.jacobian(residual, unknown)
    right = -casadi.substitute(residual, unknown, casadi.SX.zeros(unknown.shape[0]))
    solved = casadi.solve(matrix, right)
    first = casadi.Function("first", [state], [solved])
    options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000, **compiled()}
    if solver == "idas":
        system = {"x": state, "z": unknown, "ode": casadi.vertcat(v, w), "alg": residual}
    else:
        system = {"x": state, "ode": casadi.vertcat(v, solved[:len(problem.bodies)])}
        options |= {"nonlinear_solver_iteration": "functional", "linear_multistep_method": "adams"}
    integrator = casadi.integrator("integrator", solver, system, 0.0, problem.end, options)
    positions, speeds = problem.start()
    start = casadi.DM([*positions, *speeds])
    arguments = {"x0": start, "z0": first(start)} if solver == "idas" else {"x0": start}
    return lambda: float(integrator(**arguments)["xf"][0])


def main():
    # The compiled files are left in the current folder.
    folder = tempfile.TemporaryDirectory()
    os.chdir(folder.name)
    rows = []
    for problem in PROBLEMS:
        rows += sweep(problem, "IDA, index 1", TOLERANCES, lambda t: prepare(problem, t, "idas"))
        # Each setting compiles the solution of the linear system, which is long.
        rows += sweep(problem, "CVODE, Adams", TOLERANCES[::2], lambda t: prepare(problem, t, "cvodes"))
    report(rows, "casadi")


if __name__ == "__main__":
    main()
