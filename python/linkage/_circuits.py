"""Assemblies over the range of an input."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ._assembly import Assembly
from ._errors import LinkageError

if TYPE_CHECKING:
    from ._mechanism import Mechanism


class End(NamedTuple):
    """An end of a branch: `range`, `turning point` or `lost`, and the input there."""

    kind: str
    at: float


class Branch(NamedTuple):
    """An assembly and how far it reaches.

    `circuit` is the number of its circuit: without being taken apart, a mechanism reaches all
    branches of a circuit and no other. `closed` is true if a turn leads back to the same position.
    `margin` is the smallest one, 0 at a turning point, at the input `margin_at`. `unknowns` has the
    values at the input `at`.
    """

    assembly: Assembly
    circuit: int
    ends: tuple[End, End]
    closed: bool
    margin: float
    margin_at: float
    at: float
    unknowns: dict[str, Any]

    @property
    def is_whole(self) -> bool:
        """True if the assembly runs through the whole range."""
        return all(end.kind == "range" for end in self.ends)


class Circuits(tuple):
    """All branches, in the order of the inputs where they begin. Printed, it is a table."""

    text: str

    def __str__(self) -> str:
        return self.text


def circuits(mechanism: Mechanism, numbers: list[float]) -> Circuits:
    """Follows all assemblies of a mechanism with these dimensions."""
    import numpy as np

    found = mechanism._native.circuits(numbers)
    if found is None:
        raise LinkageError(
            f"circuits are those of mechanisms with one input and loops: {mechanism.name} has "
            f"{len(mechanism.inputs)} inputs and {len(mechanism.groups)} groups"
        )
    text, branches, natives = found
    made = []
    for index, (branch, native) in enumerate(zip(branches, natives)):
        circuit, ends, closed, (margin, margin_at), at, unknowns = branch
        values = {
            name: one[0] if len(one) == 1 else np.array(one) for name, one in unknowns
        }
        assembly = Assembly(mechanism, native, ("_branch", numbers, index))
        ends = tuple(End(*end) for end in ends)
        made.append(Branch(assembly, circuit, ends, closed, margin, margin_at, at, values))
    result = Circuits(made)
    result.text = text
    return result


def whole(mechanism: Mechanism, numbers: list[float], unknowns: list) -> Assembly:
    """Returns the assembly over the whole range that has these unknowns at the reference."""
    at = [one.reference for one in mechanism.inputs.values()]

    def distance(branch: Branch) -> float:
        pairs = zip(branch.assembly._native.unknowns(at), unknowns)
        return sum(abs(a - b) for (_, one), (_, other) in pairs for a, b in zip(one, other))

    branches = [branch for branch in circuits(mechanism, numbers) if branch.is_whole]
    native = min(branches, key=distance).assembly._native
    return Assembly(mechanism, native, ("_whole", numbers, unknowns))
