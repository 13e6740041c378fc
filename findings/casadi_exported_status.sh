#!/usr/bin/env bash
# casadi 3.8.2, `Function.generate` for a root finder; needs a C compiler (`cc`).
#
# Behaviour: for an equation without a root, the root finder raises RuntimeError in Python. The C that the same
# function is exported to returns 0, as for a success, and writes the last iterate as the result: for x^2 = -1, from
# 0.7, it writes -2.8 and returns 0.
#
# Guess before: the C function returns a value other than 0 where Python raises.
#
# Source: the package's header casadi/core/function.hpp says "return code (0 on success)" of an evaluation. The
# generated file calls the step of casadi/core/runtime/casadi_newton.hpp in a loop of `max_iter` rounds and then
# returns 0.
#
# Seen:
#   Python: RuntimeError
#   C: x^2 = 1: (0, 1.0)
#   C: x^2 = -1: (0, -2.8172756111295394)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet casadi==3.8.2
cat >"$folder/check.py" <<'CHECK'
import ctypes
import os
import subprocess
import sys

import casadi

os.chdir(sys.argv[1])
x, p = casadi.SX.sym("x"), casadi.SX.sym("p")
root = casadi.rootfinder("root", "fast_newton", {"x": x, "p": p, "g": x * x - p})
try:
    root(0.7, -1.0)
    raised = None
except RuntimeError as error:
    raised = type(error).__name__
print("Python:", raised)
root.generate("root.c")
subprocess.run(["cc", "-shared", "-fPIC", "-o", "root.so", "root.c", "-lm"], check=True)
library = ctypes.CDLL(os.path.abspath("root.so"))
sizes = [ctypes.c_longlong() for _ in range(4)]
library.root_work(*(ctypes.byref(size) for size in sizes))
pointer = ctypes.POINTER(ctypes.c_double)


def call(start, right):
    values = [ctypes.c_double(start), ctypes.c_double(right), ctypes.c_double()]
    arguments = (pointer * (sizes[0].value + 2))(ctypes.pointer(values[0]), ctypes.pointer(values[1]))
    results = (pointer * (sizes[1].value + 2))(ctypes.pointer(values[2]))
    integers = (ctypes.c_longlong * (sizes[2].value + 1))()
    work = (ctypes.c_double * (sizes[3].value + 1))()
    return library.root(arguments, results, integers, work, 0), values[2].value


good, bad = call(0.7, 1.0), call(0.7, -1.0)
print("C: x^2 = 1:", good)
print("C: x^2 = -1:", bad)
assert raised == "RuntimeError" and good == (0, 1.0)
assert bad[0] == 0 and bad[1] * bad[1] + 1.0 >= 1.0
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>/dev/null
