"""Environments of Python in which other programs are measured."""

import os
import pathlib
import subprocess


def interpreter(folder: pathlib.Path, version: str) -> pathlib.Path:
    """The interpreter with the packages of `requirements-VERSION.txt` of a folder of `benches`.

    The environment is made once, in the folder of that name in `target`. The variable `PYTHON311` names another
    interpreter for it than `python3.11`.
    """
    environment = folder.parent.parent / "target" / folder.name / version
    program = environment / "bin" / "python"
    if not (environment / "ready").exists():
        base = os.environ.get("PYTHON" + version.replace(".", ""), "python" + version)
        subprocess.run([base, "-m", "venv", str(environment)], check=True)
        requirements = folder / f"requirements-{version}.txt"
        subprocess.run([str(program), "-m", "pip", "install", "--quiet", "-r", str(requirements)], check=True)
        (environment / "ready").touch()
    return program
