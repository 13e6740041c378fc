"""The command `linkage` of this repository: tables of the three files beside this script.

The program is `target/release/linkage`, or the one that the variable `LINKAGE` names.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import mpmath

from mechanisms import FOUR_BAR, away_from_change_point, exact, gap_of_angles, is_crossed

HERE = pathlib.Path(__file__).parent
PROGRAM = os.environ.get("LINKAGE", str(HERE / "../../target/release/linkage"))


def command(*arguments):
    """Returns exit status, standard output and standard error."""
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def table(file, first, last, steps, *options):
    """Returns the rows as dictionaries; an empty cell is `None`."""
    status, text, _ = command("table", str(HERE / file), "motion", "--json", f"--from={first}deg", f"--to={last}deg",
                              f"--steps={steps}", *options)
    assert status == 0
    columns = json.loads(text)["columns"]
    names = [column["name"] for column in columns]
    return [dict(zip(names, row)) for row in zip(*(column["values"] for column in columns))]


def four_bar():
    """Returns the gap in mm, and the largest relative errors of velocity and of the sensitivity to the coupler."""
    rows = table("four_bar.mech", 0, 360, 721)
    gap = max(gap_of_angles(FOUR_BAR, row["phi"], row["theta"], row["psi"]) for row in rows)

    def miss(name, true):
        values = [(row[name], true(row["phi"])) for row in rows[::10]]
        return float(max(abs(found - known) for found, known in values) / max(abs(known) for _, known in values))

    def by_coupler(phi):
        def psi(length):
            return exact(type(FOUR_BAR)(FOUR_BAR.crank, length, FOUR_BAR.rocker, FOUR_BAR.frame), phi).psi

        return mpmath.diff(psi, mpmath.mpf(FOUR_BAR.coupler))

    return gap, miss("v", lambda phi: exact(FOUR_BAR, phi).psi_1), miss("e[coupler]", by_coupler)


def parallelogram():
    """Returns changes in ten turns of 1 degree, on the grid and off it, cells at a change point, and the refusal."""

    def changes(first):
        rows = [row for row in table("parallelogram.mech", first, first + 3600, 3601)
                if away_from_change_point(row["phi"])]
        sides = [is_crossed(row["phi"], row["psi"]) for row in rows]
        return sum(a != b for a, b in zip(sides, sides[1:]))

    at = table("parallelogram.mech", 180, 180, 1)[0]
    text = (HERE / "parallelogram.mech").read_text()
    with tempfile.TemporaryDirectory() as folder:
        whole = pathlib.Path(folder) / "whole.mech"
        whole.write_text(text.replace("10deg..170deg", "0deg..360deg"))
        status, _, error = command("check", str(whole))
    return changes(30), changes(30.5), [at["psi"], at["v"]], [status, error.splitlines()[0]]


def short_rocker():
    """Returns the last angle with numbers and what comes next, and the count of empty cells in a turn."""
    rows = table("short_rocker.mech", 90, 180, 901)
    last = max(row["phi"] for row in rows if row["psi"] is not None)
    options = "--from=0deg", "--to=359deg", "--steps=360", "--degrees"
    _, text, note = command("table", str(HERE / "short_rocker.mech"), "motion", *options)
    empty = sum(row.split(",")[2] == "" for row in text.splitlines()[1:])
    assert f"at {empty} of 360 positions" in note
    return math.degrees(last), "empty cells and a note", empty


def main():
    gap, velocity, sensitivity = four_bar()
    on_grid, off_grid, at, refusal = parallelogram()
    version = command("--version")[1].split()[-1]
    print(json.dumps({
        "package": "linkage", "version": version, "python": sys.version.split()[0], "gap": gap,
        "relative_errors": [velocity, sensitivity], "changes": on_grid, "changes_off_grid": off_grid,
        "at_change_point": at, "refusal": refusal, "unreachable": short_rocker()}))


if __name__ == "__main__":
    main()
