"""Mechanisms as machine code of the system's C compiler."""

from __future__ import annotations

import ctypes
import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from pathlib import Path
from threading import Lock, Thread
from typing import TYPE_CHECKING, NamedTuple

from ._errors import AssemblyError, LinkageError
from ._files import write_all
from ._threads import threads

if TYPE_CHECKING:
    import numpy as np

    from ._assembly import Assembly, BoundFunction
    from ._mechanism import Mechanism

#: Options of C compilers: no fused arithmetic, so that numbers are those of the interpreter, and
#: functions of the library are never replaced, so that loops over them are those of their body.
FLAGS = ("-std=c99", "-O3", "-fPIC", "-fno-semantic-interposition", "-shared", "-ffp-contract=off", "-fno-math-errno",
         "-fno-trapping-math")  # fmt: skip

#: Code for this processor alone, in an order in which operations wait less. Not every compiler has
#: the options.
NATIVE = ("-march=native", "-fschedule-insns")

#: Positions of a call to the code: a fraction of a millisecond at most, and less if several threads
#: share a sweep.
PART = 1 << 17
SHARED_PART = 1 << 14

_lock = Lock()
_loaded: dict[Path, ctypes.CDLL] = {}


class Code(NamedTuple):
    """The machine code of a mechanism, and the compiler and the cache that it came from."""

    library: ctypes.CDLL
    functions: tuple[str, str, str]
    sweeps: tuple[str | None, ...]
    sets: tuple[str | None, ...]
    compiler: str | None
    cache: str | None


def compiled(
    mechanism: Mechanism, *, compiler: str | None = None, cache: str | os.PathLike | None = None
) -> Mechanism:
    """Returns a mechanism whose sweeps run as machine code.

    It is the mechanism of `fused=False`, and has the numbers of it: to the last bit if all groups
    have a closed form, else to the last digits, because tables of coupled groups are exported with
    the arithmetic of the build. Single positions, sweeps of coupled groups over dimensions, and
    assemblies other than that of the estimates stay with the interpreter.

    Parameters
    ----------
    compiler
        The C compiler, by default the variable `CC` of the environment, else `gcc`, `cc` or
        `clang`. GCC computes several positions at once.
    cache
        The folder of compiled code, by default `LINKAGE_CACHE` of the environment, else `linkage`
        in the user's folder of caches. Equal mechanisms are compiled once.

    Raises
    ------
    LinkageError
        If there is no compiler, it fails, or the mechanism is beyond the limits of exported C.
    """
    from ._mechanism import Mechanism
    from ._text import revive

    origin = mechanism._origin._replace(fused=False)
    base = revive(origin)
    if mechanism._tolerances is not None:
        base = base._with_tolerances(mechanism._tolerances)
    try:
        files, main, functions, sweeps, sets = base._native.column_sweeps()
    except ValueError as error:
        raise LinkageError(str(error)) from None
    chosen = _compiler(compiler)
    folder = _folder(cache)
    path = _built(dict(files), main, chosen, folder)
    with _lock:
        if path not in _loaded:
            _loaded[path] = ctypes.CDLL(str(path))
    cache = None if cache is None else os.fspath(cache)
    code = Code(_loaded[path], tuple(functions), tuple(sweeps), tuple(sets), compiler, cache)
    return Mechanism(base._native, origin, base._tolerances, code)


def _compiler(named: str | None) -> str:
    given = named or os.environ.get("CC")
    for name in [given] if given else ["gcc", "cc", "clang"]:
        found = shutil.which(name)
        if found:
            return found
    wanted = f"`{given}`" if given else "none of `gcc`, `cc` and `clang`"
    raise LinkageError(
        f"there is no C compiler: {wanted} is found\nhelp: without `compile()` the interpreter "
        "computes the same numbers"
    )


def _folder(cache: str | os.PathLike | None) -> Path:
    if cache is not None:
        return Path(cache)
    named = os.environ.get("LINKAGE_CACHE")
    if named:
        return Path(named)
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "linkage"


def _processor() -> str:
    """Everything that distinguishes processors here: code for one may not run on another."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    flags = [line for line in lines if line.startswith(("flags", "Features", "model name"))]
    return "\n".join(dict.fromkeys(flags))


def _built(files: dict[str, str], main: str, compiler: str, folder: Path) -> Path:
    """The library of these sources: from the cache, or compiled now."""
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False)
    # The check of ranges is the interpreter's concern.
    name = main.removesuffix("_columns.c").upper()
    common = (*FLAGS, f"-D{name}_WITHOUT_RANGE_CHECK")
    parts = [*files, *files.values(), compiler, version.stdout, *common, _processor()]
    key = hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]
    path = folder / f"{Path(main).stem}_{key}.so"
    if path.exists():
        return path
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as work:
        write_all(work, files)
        output = Path(work) / "code.so"
        failed = None
        for flags in ((*common, *NATIVE), common):
            command = [compiler, *flags, "-o", str(output), main, "-lm"]
            failed = subprocess.run(command, cwd=work, capture_output=True, text=True, check=False)
            if failed.returncode == 0:
                # Another process may have written the same file meanwhile.
                os.replace(output, path)
                return path
    raise LinkageError(f"`{compiler}` cannot compile the mechanism:\n{failed.stderr.strip()}")


class CodeAssembly:
    """An assembly in the memory of the machine code."""

    def __init__(self, code: Code, dimensions: list[float], turns: list[float]):
        import numpy as np

        assemble, size, error = (getattr(code.library, name) for name in code.functions)
        size.restype = ctypes.c_size_t
        error.restype = ctypes.c_char_p
        self.code = code
        self.turns = np.array(turns)
        self.memory = ctypes.create_string_buffer(max(size(), 1))
        numbers = (ctypes.c_double * max(len(dimensions), 1))(*dimensions)
        number = assemble(self.memory, numbers)
        if number != 0:
            raise AssemblyError(error(number).decode())

    def sweep(self, index: int, arguments: list[np.ndarray], out: np.ndarray, threads: int) -> None:
        """Fills the rows of an array, one for each column, by some threads."""
        self._fill(self.code.sweeps[index], self.memory, arguments, out, threads)

    def sweep_sets(
        self,
        index: int,
        dimensions: list[np.ndarray],
        arguments: list[np.ndarray],
        out: np.ndarray,
        threads: int,
    ) -> bool:
        """Fills the same for many mechanisms; false if the function has no such code."""
        name = self.code.sets[index]
        if name is None:
            return False
        turns = ctypes.c_void_p(self.turns.ctypes.data)
        self._fill(name, turns, [*arguments, *dimensions], out, threads)
        return True

    def _fill(
        self, name: str, shared, arguments: list[np.ndarray], out: np.ndarray, threads: int
    ) -> None:
        function = getattr(self.code.library, name)
        function.restype = None
        count = out.shape[1]
        pointers = ctypes.c_void_p * max(len(arguments), 1)
        columns = ctypes.c_void_p * max(len(out), 1)
        steps = (ctypes.c_size_t * max(len(arguments), 1))(*(int(one.size > 1) for one in arguments))
        bases = [(one.ctypes.data, 8 * (one.size > 1)) for one in arguments]
        first, stride = out.ctypes.data, out.strides[0]
        size = PART if threads == 1 else min(PART, max(SHARED_PART, count // (4 * threads)))

        def part(start: int) -> None:
            rows = min(size, count - start)
            given = pointers(*(base + step * start for base, step in bases))
            wanted = columns(*(first + stride * k + 8 * start for k in range(len(out))))
            function(shared, ctypes.c_size_t(rows), given, steps, wanted)

        _in_parts(part, range(0, count, size), threads)


def _in_parts(part, starts: range, threads: int) -> None:
    """Runs a function for each start in some threads; an exception, as of Ctrl-C, ends all."""
    threads = min(threads, len(starts))
    if threads < 2:
        for start in starts:
            part(start)
        return
    rest = iter(starts)
    lock = Lock()
    stopped = False

    def work() -> None:
        while not stopped:
            with lock:
                start = next(rest, None)
            if start is None:
                return
            part(start)

    workers = [Thread(target=work) for _ in range(threads)]
    try:
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
    finally:
        # No thread may write into the arrays once the caller goes on.
        stopped = True
        for worker in workers:
            if worker.ident is not None:
                worker.join()


def code_sweep(
    bound: BoundFunction,
    dimensions: list[np.ndarray] | None,
    arguments: list[np.ndarray],
    out: np.ndarray,
) -> bool:
    """Fills a sweep by machine code; false for what stays with the interpreter."""
    machine = _code_assembly(bound.assembly)
    if machine is None:
        return False
    index = bound.function.index
    if dimensions is None:
        machine.sweep(index, arguments, out, threads())
        return True
    return machine.sweep_sets(index, dimensions, arguments, out, threads())


def _code_assembly(assembly: Assembly) -> CodeAssembly | None:
    """The assembly in machine code, if it is the one that the estimates choose."""
    code = assembly.mechanism._code
    if code is None or assembly._recipe[0] != "_assemble":
        return None
    if assembly._machine is None:
        assembly._machine = CodeAssembly(code, assembly._native.dimensions, assembly._native.turns)
    return assembly._machine
