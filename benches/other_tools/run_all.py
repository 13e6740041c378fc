"""Runs the script of every tool in an environment of its Python, and prints the table of `docs/other_tools.md`.

    python3 benches/other_tools/run_all.py [NAME...]

Environments are made in `target/other_tools` once. The interpreters are `python3.11` and `python3.12`, or those that
the variables `PYTHON311` and `PYTHON312` name. Results are kept in `results.json` beside this script; with names, only
those tools are run again.
"""

import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from environments import interpreter

RESULTS = HERE / "results.json"
TOOLS = {
    "linkage": "3.11",
    "pylinkage": "3.11",
    "py_slvs": "3.11",
    "casadi": "3.11",
    "exudyn": "3.11",
    "drake": "3.12",
    "dartpy": "3.12",
    "mujoco": "3.11",
    "pybullet": "3.11",
    "pinocchio": "3.11",
    "codac": "3.11",
}


def run(name):
    program = interpreter(HERE, TOOLS[name])
    command = [str(program), "-B", f"run_{name}.py"]
    done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not lines:
        sys.exit(f"{name}: {done.stderr}")
    return json.loads(lines[-1])


def change_point(result):
    if "changes" not in result:
        return ""
    return "stays" if result["changes"] == 0 else f"goes over, {result['changes']} times in 10 turns"


def turned(result, key):
    turns, gap = result[key]
    return f"{turns:.2f} turns, gap {gap:.2g} mm"


def unreachable(result):
    if "strong" in result:
        return f"strong drive: {turned(result, 'strong')}; weak: {turned(result, 'weak')}"
    if "weak" in result:
        return f"no drive: {turned(result, 'weak')}"
    if "exception" in result:
        return f"{result['exception']} at {result['last']:.2f} deg"
    if "unreachable" in result:
        return f"last at {result['unreachable'][0]:.1f} deg, then {result['unreachable'][1]}"
    return result.get("verdict", "")


def row(name, result):
    gap = f"{result['gap']:.2g}" if "gap" in result else ""
    steps = result.get("step")
    label = f"{name} {result['version']}" + (f", {steps * 1000:.3g} ms" if steps else "")
    return f"| {label} | {gap} | {change_point(result)} | {unreachable(result)} |"


def main():
    results = json.loads(RESULTS.read_text()) if RESULTS.exists() else {}
    for name in sys.argv[1:] or TOOLS:
        results[name] = run(name)
        RESULTS.write_text(json.dumps(results, indent=1) + "\n")
    print("| tool | gap, mm | change points | a loop that cannot close |\n|---|---|---|---|")
    for name in TOOLS:
        if name in results:
            print(row(name, results[name]))


if __name__ == "__main__":
    main()
