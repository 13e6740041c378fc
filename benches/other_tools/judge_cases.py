"""Random linkages at and away from the limits of their cranks: verdicts of `linkage table` against proofs by codac.

    python judge_cases.py 2000                                            # prints the agreement
    python judge_cases.py 1000 ../../tests/reachability/judged.csv        # and writes the decided cases

The mechanisms are those of the test `tests/reachability/main.rs`, which reads the cases.

The cases are complete, as text too, before codac is loaded: loading it makes the whole process round upwards, and
Python then reads decimals wrongly.
"""

import collections
import csv
import json
import math
import pathlib
import random
import sys

from run_linkage import HERE, command

FILE = HERE / "../../tests/reachability/main.rs"
REFERENCE = math.radians(60.0)
NAMES = {"FourBar": ("crank", "coupler", "rocker", "base"), "SliderCrank": ("crank", "rod", "offset")}


def cosine_limits(crank, coupler, rocker, base):
    """Cosines of the crank's angle at which coupler and rocker are in line."""
    for reach in (coupler + rocker, coupler - rocker):
        yield (crank**2 + base**2 - reach**2) / (2 * crank * base)


def limits(kind, values):
    """Angles of the crank at which it stops; used to choose cases only, never to judge one."""
    if kind == "FourBar":
        return [s * math.acos(c) for c in cosine_limits(*values) if abs(c) < 1 for s in (1, -1)]
    crank, rod, offset = values
    sines = [(offset + s * rod) / crank for s in (1, -1)]
    return [angle for s in sines if abs(s) < 1 for angle in (math.asin(s), math.pi - math.asin(s))]


def is_closed_at_reference(kind, values):
    """Roughly, and a little away from the limits: the command reports what is left."""
    if kind == "SliderCrank":
        crank, rod, offset = values
        return abs(offset - crank * math.sin(REFERENCE)) < 0.99 * rod
    crank, coupler, rocker, base = values
    distance = math.hypot(base - crank * math.cos(REFERENCE), crank * math.sin(REFERENCE))
    return abs(coupler - rocker) * 1.01 < distance < 0.99 * (coupler + rocker)


def dimensions(generator, kind):
    """Three decimals each; every fourth set is of very unlike lengths."""
    spread = 3.0 if generator.random() < 0.25 else 0.8
    while True:
        values = [round(100 * math.exp(generator.uniform(-spread, spread)), 3) for _ in NAMES[kind]]
        if kind == "SliderCrank":
            values[2] = round(generator.uniform(-0.8, 0.8) * values[0], 3)
        if is_closed_at_reference(kind, values):
            return values


def verdicts(kind, values, first, last):
    """Returns the angle and whether there is a number, at two positions, by the command."""
    sets = [f"--set={name}={value!r}mm" for name, value in zip(NAMES[kind], values)]
    status, text, error = command("table", str(FILE), "angles", "--json", "--mechanism", kind, "--steps=2",
                                  f"--from={first!r}rad", f"--to={last!r}rad", *sets)
    if status != 0:
        sys.exit(f"{kind} {values}: {error}")
    columns = [column["values"] for column in json.loads(text)["columns"]]
    return [(row[0], None not in row) for row in zip(*columns)]


def cases(generator, count):
    while count > 0:
        kind = generator.choice(["FourBar", "FourBar", "SliderCrank"])
        values = dimensions(generator, kind)
        at = limits(kind, values)
        for _ in range(3):
            if at and generator.random() < 0.9:
                limit = generator.choice(at)
                distance = 10 ** generator.uniform(-15, -1)
                first, last = limit - distance, limit + distance
            else:
                distance = None
                first, last = (generator.uniform(-math.pi, math.pi) for _ in range(2))
            for phi, closes in verdicts(kind, values, first, last):
                yield kind, values, phi, closes, distance
                count -= 1


def main():
    count, target = int(sys.argv[1]), sys.argv[2:]
    rows = []
    for kind, values, phi, closes, distance in cases(random.Random(42), count):
        texts = [kind, *(repr(value) for value in values), *[""] * (4 - len(values)), repr(phi)]
        group = "away" if distance is None else f"1e{math.floor(math.log10(distance)):03}"
        rows.append((texts, kind, values, phi, closes, group))

    import judge

    agreed, kept = collections.Counter(), []
    for texts, kind, values, phi, closes, group in rows:
        equations = judge.four_bar if kind == "FourBar" else judge.slider_crank
        verdict, _ = judge.judge(*equations(*values, phi))
        agreement = "agree" if closes == (verdict == judge.CLOSES) else "differ"
        if verdict == judge.UNDECIDED:
            agreement = "undecided"
        else:
            kept.append([*texts, verdict])
        agreed[group, agreement] += 1
        if agreement == "differ":
            print("differs:", *texts, verdict, group)
    print("| distance from the limit, rad | agree | differ | undecided |\n|---|---|---|---|")
    for group in sorted({group for group, _ in agreed}):
        print(f"| {group} |", " | ".join(str(agreed[group, name]) for name in ("agree", "differ", "undecided")), "|")
    if target:
        with pathlib.Path(target[0]).open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["mechanism", "a", "b", "c", "d", "phi", "verdict"])
            writer.writerows(kept)


if __name__ == "__main__":
    main()
