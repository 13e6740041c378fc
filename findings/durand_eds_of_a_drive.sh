#!/usr/bin/env bash
# durand 0.5.0 and canopen 2.4.1: the EDS that a CANopen node of durand describes itself with, read by canopen.
#
# Behaviour: a record becomes an array and an array a record. The limits of positions (0x607B), which have two
# entries, have a third one in canopen, by the rule for arrays. A position in metres with the factor 0.001 is 1000
# counts on the bus for 1 m, and the EDS has 1 with limits of -2 and 2 for the counts: canopen takes 1 count, within 2
# counts. For 1.5 m canopen has no default, as that is no integer. Plain variables are right. Nothing is raised or
# printed.
#
# Guess before: the same kinds of objects, and the counts of the bus in the EDS.
#
# Source: CiA 306 has the object type 8 for arrays and 9 for records, as canopen/objectdictionary/eds.py, lines 22 and
# 23. `describe_object` of durand/eds.py writes 0x8 for `Record` and 0x9 for others, and `describe_variable` the
# values before the factor, which `Variable.pack` applies. The README of durand has "Dynamic generation of EDS files".
#
# Seen:
#   record 607B: ODArray, third entry Min_3
#   array 2002: ODRecord
#   position of 1 m: 1000 on the bus, in the EDS 1, -2 to 2
#   position of 1.5 m: 1500 on the bus, in the EDS None, -2 to 2
#   target of -1000: -1000 on the bus, in the EDS -1000, -2147483648 to 2147483647
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile durand==0.5.0 canopen==2.4.1
cat >"$folder/check.py" <<'CHECK'
import sys

import canopen
from durand import Array, DatatypeEnum, MinimalNode, Record, Variable
from durand.network import NetworkABC

INTEGER = DatatypeEnum.INTEGER32


class Bus(NetworkABC):
    """A bus without other nodes."""

    def add_subscription(self, cob_id, callback):
        pass

    def remove_subscription(self, cob_id):
        pass

    def send(self, cob_id, msg):
        pass


node = MinimalNode(Bus(), 2)
objects = node.object_dictionary
limits = Record(name="Position range limit")
limits[1], limits[2] = Variable(INTEGER, "rw", -100, name="Min"), Variable(INTEGER, "rw", 100, name="Max")
objects[0x607B] = limits
objects[0x2002] = Array(Variable(INTEGER, "rw", 5, name="Gain"), 3, name="Gains")
for index, metres in ((0x2003, 1), (0x2004, 1.5)):
    objects[index] = Variable(INTEGER, "ro", metres, factor=0.001, minimum=-2, maximum=2, name=f"Position {index:X}")
objects[0x607A] = Variable(INTEGER, "rw", -1000, name="Target position")

path = sys.argv[1] + "/drive.eds"
with open(path, "w") as file:
    file.write(node.eds.content)
read = canopen.import_od(path, 2)

kinds = type(read[0x607B]).__name__, type(read[0x2002]).__name__
third = read[0x607B][3].name.split(".")[-1]
print(f"record 607B: {kinds[0]}, third entry {third}")
print(f"array 2002: {kinds[1]}")
assert kinds == ("ODArray", "ODRecord") and third == "Min_3" and 3 not in limits

for text, index, value, sent, expected in (
    ("position of 1 m", 0x2003, 1, 1000, (1, -2, 2)), ("position of 1.5 m", 0x2004, 1.5, 1500, (None, -2, 2)),
    ("target of -1000", 0x607A, -1000, -1000, (-1000, -(2**31), 2**31 - 1)),
):
    found = read[index]
    counts = int.from_bytes(objects[index].pack(value), "little", signed=True)
    print(f"{text}: {counts} on the bus, in the EDS {found.default}, {found.min} to {found.max}")
    assert counts == sent and (found.default, found.min, found.max) == expected
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
