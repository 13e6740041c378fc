"""MuJoCo in C: a tree of joints, closed by `connect` constraints; steps of several sizes and integrators.

Constraints are as hard as they can be (`solimp` 0.9999), with a time constant of two steps, the shortest that is
accepted. MJX is not measured.
"""

import mujoco

from measures import report, sweep
from problems import PROBLEMS

STEPS = [1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6, 1e-6, 5e-7]


def tree(problem, start, index):
    """A body of the tree with its children."""
    body = problem.bodies[index]
    (x, y), turn = body.pivot, start[index]
    if body.parent >= 0:
        turn -= start[body.parent]
    sites = [f'<site name="s{k}{end}" pos="{point[0]!r} {point[1]!r} 0"/>' for k, closure in enumerate(problem.closures)
             for end, (owner, point) in enumerate([closure[:2], closure[2:]]) if owner == index]
    if problem.spring and problem.spring[0] == index:
        px, py = problem.spring[1]
        sites.append(f'<site name="spring" pos="{px!r} {py!r} 0"/>')
    children = [tree(problem, start, k) for k, child in enumerate(problem.bodies) if child.parent == index]
    joint = '<joint type="slide" axis="1 0 0"/>' if body.slides else '<joint axis="0 0 1"/>'
    place, angle = (f"{x + turn!r} {y!r} 0", 0.0) if body.slides else (f"{x!r} {y!r} 0", float(turn))
    (cx, cy), i = body.centre, body.inertia
    return (f'<body pos="{place}" euler="0 0 {angle!r}">{joint}<inertial pos="{cx!r} {cy!r} 0" mass="{body.mass!r}" '
            f'diaginertia="{i!r} {i!r} {i!r}"/>{"".join(sites)}{"".join(children)}</body>')


def text(problem, step, integrator):
    start = [float(value) for value in problem.start()[0]]
    roots = [tree(problem, start, k) for k, body in enumerate(problem.bodies) if body.parent < 0]
    closures = [f'<connect site1="s{k}0" site2="s{k}1" solref="{2 * step!r} 1" solimp="0.9999 0.9999 0.001"/>'
                for k in range(len(problem.closures))]
    spring, fixed = "", ""
    if problem.spring:
        _, _, (x, y), stiffness, free = problem.spring
        fixed = f'<site name="fixed" pos="{x!r} {y!r} 0"/>'
        spring = (f'<tendon><spatial stiffness="{stiffness!r}" springlength="{free!r}"><site site="fixed"/>'
                  '<site site="spring"/></spatial></tendon>')
    return (f'<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/><option timestep="{step!r}" '
            f'integrator="{integrator}" gravity="0 {-problem.gravity!r} 0" '
            'jacobian="dense"><flag contact="disable" limit="disable"/></option><size nconmax="0"/><worldbody>'
            f'{fixed}{"".join(roots)}</worldbody><equality>{"".join(closures)}</equality>{spring}</mujoco>')


def prepare(problem, integrator, step):
    model = mujoco.MjModel.from_xml_string(text(problem, step, integrator))
    positions, speeds = problem.start()
    data = mujoco.MjData(model)
    rates = problem.relative(speeds)
    # MuJoCo orders joints by the tree, depth first.
    order = []

    def visit(index):
        order.append(index)
        for k, child in enumerate(problem.bodies):
            if child.parent == index:
                visit(k)

    for k, body in enumerate(problem.bodies):
        if body.parent < 0:
            visit(k)
    count = round(problem.end / step)
    first = float(positions[0])

    def run():
        mujoco.mj_resetData(model, data)
        data.qvel[:] = rates[order]
        data.qfrc_applied[0] = problem.torque
        mujoco.mj_step(model, data, count)
        return first + float(data.qpos[0])

    return run


def main():
    rows = []
    for problem in PROBLEMS:
        scale = problem.end / 0.03
        for integrator in ("RK4", "implicitfast", "Euler"):
            settings = [(integrator, step * scale) for step in STEPS]
            rows += sweep(problem, "MuJoCo C, connect", settings, lambda setting: prepare(problem, *setting))
    report(rows, "mujoco")


if __name__ == "__main__":
    main()
