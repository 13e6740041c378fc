"""Two problems as trees of pins and slides with closures, their starts, and their solutions, of 16 digits or more.

Lengths are in m, masses in kg. A body's frame has its origin in its pin, and turns with the body; angles are those
against the frame of the mechanism. Numbers are those of `mechanisms/andrews.rs` and of `benches/dynamics/main.rs`.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Body:
    name: str
    parent: int  # -1: the frame
    pivot: tuple  # in the parent's frame
    mass: float
    centre: tuple
    inertia: float  # about the centre
    slides: bool = False  # along the x axis, instead of a pin


@dataclass(frozen=True)
class Problem:
    name: str
    bodies: tuple
    closures: tuple  # (body, point, body, point)
    torque: float  # on the first body
    gravity: float
    spring: tuple | None  # (body, point, fixed point, stiffness, free length)
    estimate: tuple  # coordinates; the first one is exact
    speed: float
    end: float
    solution: float  # the first coordinate at the end

    def frames(self, q):
        """Origin and axes of each body."""
        found = []
        for body, coordinate in zip(self.bodies, q):
            origin, axes = (np.zeros(2), np.eye(2)) if body.parent < 0 else found[body.parent]
            origin = origin + axes @ np.array(body.pivot)
            if body.slides:
                found.append((origin + np.array([coordinate, 0.0]), np.eye(2)))
            else:
                c, s = np.cos(coordinate), np.sin(coordinate)
                found.append((origin, np.array([[c, -s], [s, c]])))
        return found

    def gaps(self, q):
        frames = self.frames(q)
        place = lambda body, point: frames[body][0] + frames[body][1] @ np.array(point)
        return np.concatenate([place(a, p) - place(b, r) for a, p, b, r in self.closures])

    def start(self):
        """Coordinates and speeds that close all loops."""
        q = np.array(self.estimate)
        for _ in range(20):
            slopes = self.slopes(q)
            q[1:] -= np.linalg.solve(slopes[:, 1:], self.gaps(q))
        slopes = self.slopes(q)
        v = np.empty_like(q)
        v[0] = self.speed
        v[1:] = np.linalg.solve(slopes[:, 1:], -slopes[:, 0] * self.speed)
        return q, v

    def slopes(self, q):
        """Derivatives of the gaps, by complex steps."""
        columns = []
        for i in range(len(q)):
            moved = q.astype(complex)
            moved[i] += 1e-30j
            columns.append(self.gaps(moved).imag / 1e-30)
        return np.array(columns).T

    def relative(self, values):
        """Joint coordinates from those against the frame."""
        def turns(body):
            return body.parent >= 0 and not body.slides and not self.bodies[body.parent].slides

        return np.array([value - values[body.parent] if turns(body) else value
                         for body, value in zip(self.bodies, values)])


ANDREWS = Problem(
    "andrews",
    (
        Body("k1", -1, (0.0, 0.0), 0.04325, (0.00092, 0.0), 2.194e-6),
        Body("k2", 0, (0.007, 0.0), 0.00365, (-0.0115, 0.0), 4.410e-7),
        Body("k3", -1, (-0.03635, 0.03273), 0.02373, (0.01043, -0.01874), 5.255e-6),
        Body("k5", -1, (-0.06934, -0.00227), 0.07050, (0.02308, 0.00916), 1.169e-5),
        Body("k4", 3, (0.04, 0.0), 0.00706, (0.0, -(0.02 - 0.01421)), 5.667e-7),
        Body("k7", -1, (-0.06934, -0.00227), 0.05498, (-0.00449, -0.01228), 1.912e-5),
        Body("k6", 5, (0.0, -0.04), 0.00706, (0.02 - 0.01421, 0.0), 5.667e-7),
    ),
    ((1, (-0.028, 0.0), 2, (0.0, -0.035)), (1, (-0.028, 0.0), 4, (0.0, -0.02)), (1, (-0.028, 0.0), 6, (0.02, 0.0))),
    0.033,
    0.0,
    (2, (0.02, -0.018), (0.014, 0.072), 4530.0, 0.07785),
    (-0.06171389001427644, -0.0617, 0.4553, 0.4874, 0.7100, 1.2305, 1.0079),
    0.0,
    0.03,
    15.8107711951537070971193873047,
)

SLIDER_CRANK = Problem(
    "slider-crank",
    (
        Body("wheel", -1, (0.0, 0.0), 0.5, (0.05 / 3, 0.0), 0.002),
        Body("rod", 0, (0.05, 0.0), 0.4, (0.09, 0.0), 0.001),
        Body("piston", -1, (0.0, 0.0), 1.3, (0.0, 0.0), 1e-3, slides=True),
    ),
    ((1, (0.18, 0.0), 2, (0.0, 0.0)),),
    0.0,
    9.80665,
    None,
    (0.0, 0.0, 0.23),
    40.0,
    1.0,
    30.0965479129058518576454846,
)

PROBLEMS = (ANDREWS, SLIDER_CRANK)
assert all(abs(problem.gaps(problem.start()[0])).max() < 1e-15 for problem in PROBLEMS)
