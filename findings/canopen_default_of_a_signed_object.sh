#!/usr/bin/env bash
# canopen 2.4.1: the EDS of a drive, with default values of signed objects that are written in hexadecimal.
#
# Behaviour: the default of the lower software limit of a drive, 0x80000000, is read as 2147483648, the whole range
# away from the -2147483648 that it stands for, while `LowLimit=0x80000000` of the same object is read as -2147483648.
# The default exponent of the interpolation time, 0xFD, is 253, so that a cycle of 1 ms has 10^253 s; as a limit 0xFD
# is -3. A local node that is made from the file raises ValueError where these objects are read. Nothing is printed on
# reading the file. Defaults in decimal are right.
#
# Guess before: the default has the sign of its type, as the limits have.
#
# Source: canopen/objectdictionary/eds.py takes hexadecimal limits of signed types for two's complement, by
# `_signed_int_from_hex`, and does not call it for `DefaultValue` and `ParameterValue`.
#
# Seen:
#   lower limit of position: default 2147483648, smallest value -2147483648; local node: ValueError
#   exponent of interpolation time: default 253, smallest value -3; local node: ValueError
#   homing method: default -1, smallest value -128; local node: -1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile canopen==2.4.1
cat >"$folder/check.py" <<'CHECK'
import logging
import sys

import canopen

INTEGER8, UNSIGNED8, UNSIGNED32, INTEGER32 = 2, 5, 7, 4
logging.disable(logging.CRITICAL)


def entry(section, name, kind, **values):
    lines = [f"[{section}]", f"ParameterName={name}", "ObjectType=0x7", f"DataType={kind:#06x}", "AccessType=rw"]
    return "\n".join(lines + [f"{key}={value}" for key, value in values.items()])


def group(index, name, value):
    head = f"[{index}]\nParameterName={name}\nObjectType=0x8\nSubNumber=3"
    count = entry(index + "sub0", "entries", UNSIGNED8, DefaultValue=2)
    return "\n".join([head, count, value])


path = sys.argv[1] + "/drive.eds"
with open(path, "w") as file:
    file.write("\n".join([
        "[DeviceInfo]\n[MandatoryObjects]\nSupportedObjects=1\n1=0x1000",
        "[OptionalObjects]\nSupportedObjects=3\n1=0x6098\n2=0x607D\n3=0x60C2",
        entry("1000", "Device type", UNSIGNED32, DefaultValue="0x00020192"),
        entry("6098", "Homing method", INTEGER8, DefaultValue=-1, LowLimit="0x80", HighLimit="0x7F"),
        group("607D", "Software position limit",
              entry("607Dsub1", "Smallest", INTEGER32, DefaultValue="0x80000000", LowLimit="0x80000000")),
        group("60C2", "Interpolation time period",
              entry("60C2sub2", "Exponent", INTEGER8, DefaultValue="0xFD", LowLimit="0xFD"))]) + "\n")
dictionary = canopen.import_od(path, node_id=5)
node = canopen.LocalNode(5, dictionary)
for name, place, default, smallest in (("lower limit of position", (0x607D, 1), 2**31, -2**31),
                                       ("exponent of interpolation time", (0x60C2, 2), 0xFD, -3),
                                       ("homing method", (0x6098,), -1, -128)):
    variable, stored = dictionary, node.sdo
    for key in place:
        variable, stored = variable[key], stored[key]
    try:
        value = stored.raw
    except ValueError as error:
        value = type(error).__name__
    print(f"{name}: default {variable.default}, smallest value {variable.min}; local node: {value}")
    assert (variable.default, variable.min) == (default, smallest)
    assert value == (default if default < 0 else "ValueError")
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
