"""Solutions of the problems to 30 digits: the speed from the energy, the time from its integral, in mpmath.

The closures are solved by Newton's method at each point; nothing but the numbers of the problems is shared with the
other solvers. `python solutions.py` prints the coordinates that `problems.py` has.
"""

import mpmath as mp

from problems import PROBLEMS

mp.mp.dps = 50


def decimal(number):
    """The decimal that a double was written as."""
    return mp.mpf(repr(number))


class Mechanism:
    def __init__(self, problem):
        self.problem = problem
        self.estimate = [decimal(value) for value in problem.estimate]

    def places(self, q, points):
        """Points of bodies with their derivatives with respect to all coordinates."""
        bodies = self.problem.bodies
        found = []
        for index, point in points:
            place, slopes = [mp.mpf(0), mp.mpf(0)], {}
            point = tuple(map(decimal, point))
            while index >= 0:
                body = bodies[index]
                if body.slides:
                    arm = [point[0], point[1]]
                    place[0] += q[index]
                    slopes[index] = (mp.mpf(1), mp.mpf(0))
                else:
                    c, s = mp.cos(q[index]), mp.sin(q[index])
                    arm = [c * point[0] - s * point[1], s * point[0] + c * point[1]]
                    slopes[index] = (-arm[1], arm[0])
                place = [a + b for a, b in zip(place, arm)]
                point, index = tuple(map(decimal, body.pivot)), body.parent
            found.append(([a + b for a, b in zip(place, point)], slopes))
        return found

    def closure(self, q):
        """Gaps and their derivatives."""
        gaps, rows = [], []
        for first, point, second, other in self.problem.closures:
            (a, a_slopes), (b, b_slopes) = self.places(q, [(first, point), (second, other)])
            for axis in range(2):
                gaps.append(a[axis] - b[axis])
                row = [mp.mpf(0)] * len(q)
                for index, slope in a_slopes.items():
                    row[index] += slope[axis]
                for index, slope in b_slopes.items():
                    row[index] -= slope[axis]
                rows.append(row)
        return gaps, rows

    def inertia_and_work(self, angle):
        """Reduced inertia, and the work of torque, weights and spring."""
        problem = self.problem
        q = [angle] + self.estimate[1:]
        for _ in range(60):
            gaps, rows = self.closure(q)
            matrix = mp.matrix([row[1:] for row in rows])
            step = mp.lu_solve(matrix, mp.matrix(gaps))
            q[1:] = [value - change for value, change in zip(q[1:], step)]
            if max(map(abs, step)) < mp.mpf(10) ** -45:
                break
        self.estimate = q
        _, rows = self.closure(q)
        rates = mp.lu_solve(mp.matrix([row[1:] for row in rows]), mp.matrix([-row[0] for row in rows]))
        rates = [mp.mpf(1), *rates]
        inertia, work = mp.mpf(0), decimal(problem.torque) * angle
        centres = self.places(q, [(index, body.centre) for index, body in enumerate(problem.bodies)])
        for index, (body, (centre, slopes)) in enumerate(zip(problem.bodies, centres)):
            rate = [sum(slope[axis] * rates[i] for i, slope in slopes.items()) for axis in range(2)]
            inertia += decimal(body.mass) * (rate[0] ** 2 + rate[1] ** 2)
            if not body.slides:
                inertia += decimal(body.inertia) * rates[index] ** 2
            work -= decimal(body.mass) * decimal(problem.gravity) * centre[1]
        if problem.spring:
            body, point, fixed, stiffness, free = problem.spring
            [(place, _)] = self.places(q, [(body, point)])
            length = mp.hypot(place[0] - decimal(fixed[0]), place[1] - decimal(fixed[1]))
            work -= decimal(stiffness) / 2 * (length - decimal(free)) ** 2
        return inertia, work

    def solution(self, start):
        """The first coordinate at the end of the problem."""
        inertia, work = self.inertia_and_work(start)
        kinetic = inertia * decimal(self.problem.speed) ** 2 / 2
        nodes = mp.calculus.quadrature.GaussLegendre(mp.mp).calc_nodes(5, 180)

        def speed(angle):
            j, w = self.inertia_and_work(angle)
            return mp.sqrt(2 * (kinetic + w - work) / j)

        def time(a, b):
            # From rest the speed grows with the root of the distance.
            first, last = (mp.sqrt(a - start), mp.sqrt(b - start))
            half, middle = (last - first) / 2, (last + first) / 2
            points = [(middle + half * node, weight) for node, weight in sorted(nodes)]
            return half * sum(weight * 2 * s / speed(start + s * s) for s, weight in points)

        left, angle, step = decimal(self.problem.end), start, mp.mpf(1) / 2
        while True:
            part = time(angle, angle + step)
            if part > left:
                break
            left, angle = left - part, angle + step
        end = angle + step * left / part
        for _ in range(8):
            change = (left - time(angle, end)) * speed(end)
            end += change
            if abs(change) < mp.mpf(10) ** -36:
                return end


if __name__ == "__main__":
    STARTS = {"andrews": "-0.0617138900142764496358948458001", "slider-crank": "0"}
    for problem in PROBLEMS:
        print(problem.name, mp.nstr(Mechanism(problem).solution(mp.mpf(STARTS[problem.name])), 32))
