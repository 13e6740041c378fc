#!/usr/bin/env bash
# sympy 1.14.0, printing of `Mod` as C; needs a C compiler (`cc`).
#
# Behaviour: `Mod(x, 2*pi)` of a real symbol is between 0 and 2 pi, in sympy itself, through `lambdify` and in the
# JavaScript that sympy prints. In C it is printed as `fmod(x, 2*M_PI)`, which has the sign of x: for -1 sympy gives
# 5.283, the C gives -1. An angle brought to one turn in a model is no longer so in the exported code.
#
# Guess before: the printed C computes the value of the expression.
#
# Source: sympy/printing/c.py. The printer corrects the sign for integers, with a comment that C's % is a remainder,
# and falls back to `fmod` for all other numbers. The page of `Mod` says that the result has the sign of the divisor.
#
# Seen: lambdify 5.283185307179586, JavaScript ((x % (2*Math.PI)) + (2*Math.PI)) % (2*Math.PI), C -1.0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet sympy==1.14.0
cat >"$folder/check.py" <<'CHECK'
import math
import subprocess
import sys

import sympy

x = sympy.symbols("x", real=True)
turn = sympy.Mod(x, 2 * sympy.pi)
text = sympy.ccode(turn)
source, program = sys.argv[1] + "/mod.c", sys.argv[1] + "/mod"
with open(source, "w") as file:
    file.write("#define _GNU_SOURCE\n#include <math.h>\n#include <stdio.h>\nint main(void)\n{\n    double x = -1.0;\n")
    file.write(f'    printf("%.17g\\n", {text});\n    return 0;\n}}\n')
subprocess.run(["cc", "-o", program, source, "-lm"], check=True)
in_c = float(subprocess.run([program], capture_output=True, text=True, check=True).stdout)
in_python = sympy.lambdify(x, turn)(-1.0)
print("sympy", turn.subs(x, -1).evalf(), "lambdify", in_python)
print("JavaScript", sympy.jscode(turn))
print("C", text, "=", in_c)
assert abs(in_python - (2 * math.pi - 1)) < 1e-15 and in_c == -1.0
assert sympy.jscode(turn).count("%") == 2
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
