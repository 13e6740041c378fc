"""Runs the script of every solver in an environment of its Python, and writes `rivals.csv`.

    python3 benches/dynamics_rivals/run_all.py [NAME...]

Environments are made in `target/dynamics_rivals` once. The interpreters are `python3.11` and `python3.12`, or those
that the variables `PYTHON311` and `PYTHON312` name. With names only those scripts are run, and the other rows stay.
"""

import datetime
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from environments import interpreter

CSV = HERE / "rivals.csv"
COLUMNS = ["script", "problem", "method", "setting", "error", "seconds"]
SCRIPTS = {"ida": "3.11", "mujoco": "3.11", "exudyn": "3.11", "pinocchio": "3.11", "drake": "3.12"}


def run(name):
    """Versions and rows of a script."""
    command = [str(interpreter(HERE, SCRIPTS[name])), "-B", f"run_{name}.py"]
    done = subprocess.run(command, cwd=HERE, stdout=subprocess.PIPE, text=True, check=True)
    line = [line for line in done.stdout.splitlines() if line.startswith("{")][-1]
    found = json.loads(line)
    versions = ", ".join(f"{package} {version}" for package, version in found["versions"].items())
    rows = [[name, row["problem"], row["method"], row["setting"], f"{row['error']:.3e}", f"{row['seconds']:.3e}"]
            for row in found["rows"]]
    return f"{versions} (Python {found['python']})", rows


def stored():
    """Versions and rows of the file, by script."""
    found = {}
    if CSV.exists():
        for line in CSV.read_text().splitlines():
            if line.startswith("# ") and ": " in line:
                name, versions = line[2:].split(": ", 1)
                found[name] = (versions, [])
            elif (cells := line.split(";"))[0] in found:
                found[cells[0]][1].append(cells)
    return found


def processor():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.split(": ")[1] for line in lines if line.startswith("model name")), "unknown processor")


def main():
    found = stored()
    for name in sys.argv[1:] or SCRIPTS:
        versions, rows = run(name)
        found[name] = f"{versions}; {processor()}; {datetime.date.today()}", rows
        lines = [f"# {script}: {versions}" for script, (versions, _) in found.items()]
        lines.append(";".join(COLUMNS))
        lines += [";".join(row) for _, rows in found.values() for row in rows]
        CSV.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
