"""Mechanisms from texts and files."""

from __future__ import annotations

import os
from functools import lru_cache

from . import _linkage
from ._errors import CompileError
from ._mechanism import Mechanism, Origin


def load(
    path: str | os.PathLike,
    name: str | None = None,
    *,
    any_range: bool = False,
    fused: bool | None = None,
) -> Mechanism:
    """Compiles a mechanism of a file.

    Parameters
    ----------
    path
        A file in the language of linkage (`.mech`), or a Rust file with calls of `mechanism!`.
    name
        The mechanism, if the file has several. By default it is the last one, which may have the
        others as parts.
    any_range
        Accepts a declared range in which the mechanism comes apart: results are NaN there.
    fused
        The rounding of multiply-adds: once (`True`), twice (`False`), or as the instructions of
        this machine do it (`None`). With `False` the numbers are those of exported C.

    Raises
    ------
    CompileError
        For mistakes in the text, each with its line.
    OSError
        If the file cannot be read, as `FileNotFoundError`.
    """
    with open(path, encoding="utf-8") as file:
        text = file.read()
    return _chosen(text, os.fspath(path), name, any_range, fused)


def parse(
    text: str,
    name: str | None = None,
    *,
    any_range: bool = False,
    fused: bool | None = None,
) -> Mechanism:
    """Compiles a mechanism of a text; arguments and errors are those of `load`."""
    return _chosen(text, "mechanism", name, any_range, fused)


def load_all(
    path: str | os.PathLike, *, any_range: bool = False, fused: bool | None = None
) -> dict[str, Mechanism]:
    """Compiles all mechanisms of a file: by their names, in the order of the file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    return _all(text, os.fspath(path), any_range, fused)


def parse_all(
    text: str, *, any_range: bool = False, fused: bool | None = None
) -> dict[str, Mechanism]:
    """Compiles all mechanisms of a text: by their names, in the order of the text."""
    return _all(text, "mechanism", any_range, fused)


def revive(origin: Origin) -> Mechanism:
    """Compiles a mechanism again where it was copied to, once in each process."""
    text, file, name, any_range, fused = origin
    return _chosen(text, file, name, any_range, fused)


def _all(text: str, file: str, any_range: bool, fused: bool | None) -> dict[str, Mechanism]:
    native = _compiled(text, file, any_range, fused)
    return {
        one.name: Mechanism(one, Origin(text, file, one.name, any_range, fused)) for one in native
    }


def _chosen(
    text: str, file: str, name: str | None, any_range: bool, fused: bool | None
) -> Mechanism:
    found = _all(text, file, any_range, fused)
    if name is None:
        return list(found.values())[-1]
    if name not in found:
        names = "`, `".join(found)
        raise CompileError(f"`{file}` has no mechanism `{name}`; it has `{names}`")
    return found[name]


# Descriptions of compiled mechanisms stay in memory, so equal texts are compiled once.
@lru_cache(maxsize=None)
def _compiled(text: str, file: str, any_range: bool, fused: bool | None):
    if not isinstance(text, str):
        raise TypeError(f"a text is a `str`, not `{type(text).__name__}`")
    return tuple(_linkage.compile(file, text, any_range, fused))
