"""Dimensions that are given by name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._describe import Parameter
from ._numbers import array, unknown

if TYPE_CHECKING:
    import numpy as np


class Dimensions:
    """The dimensions of a mechanism: names, and the values that a call gives them.

    A vector takes an array whose last axis has its components; a component takes numbers by the
    name `pivot.x` or `pivot_x`.
    """

    def __init__(self, owner: str, parameters: tuple[Parameter, ...]):
        self.owner = owner
        self.parameters = parameters
        self.indices = {one.name: index for index, one in enumerate(parameters)}
        self.vectors: dict[str, list[int]] = {}
        for index, one in enumerate(parameters):
            base, dot, component = one.name.rpartition(".")
            if dot and component in ("x", "y", "z"):
                self.vectors.setdefault(base, []).append(index)
        self.aliases: dict[str, str] = {}
        for name in [*self.indices, *self.vectors]:
            alias = name.replace(".", "_")
            if alias != name and alias not in self.indices and alias not in self.vectors:
                self.aliases.setdefault(alias, name)

    def has(self, name: str) -> bool:
        """Returns true for the name of a dimension, of a vector or of a component."""
        return name in self.indices or name in self.vectors or name in self.aliases

    def given(self, values: dict[str, Any]) -> dict[int, np.ndarray]:
        """Returns arrays by the indices of parameters.

        Raises
        ------
        TypeError
            For a name that no dimension has, a dimension that is given twice, no real number.
        ValueError
            For a vector without its components.
        """
        found: dict[int, np.ndarray] = {}
        for given, value in values.items():
            name = self.aliases.get(given, given)
            if name in self.indices:
                index = self.indices[name]
                parts = {index: array(name, self.parameters[index].unit, value)}
            elif name in self.vectors:
                parts = self._components(name, value)
            else:
                raise unknown("dimension", given, [*self.indices, *self.vectors], self.owner)
            for index, part in parts.items():
                if index in found:
                    raise TypeError(f"dimension `{self.parameters[index].name}` is given twice")
                found[index] = part
        return found

    def scalars(self, values: dict[str, Any], base: list[float] | None = None) -> list[float]:
        """Returns a number for each parameter: a given one, that of `base`, or the nominal one.

        Raises
        ------
        TypeError, ValueError
            As `given`; for an array where an assembly has one number.
        """
        numbers = [one.nominal for one in self.parameters] if base is None else list(base)
        for index, value in self.given(values).items():
            if value.ndim:
                name = self.parameters[index].name
                raise ValueError(
                    f"dimension `{name}` of an assembly is one number, not an array of shape "
                    f"{value.shape}\nhelp: give arrays to the functions of the assembly"
                )
            numbers[index] = float(value)
        return numbers

    def _components(self, name: str, value: Any) -> dict[int, np.ndarray]:
        indices = self.vectors[name]
        whole = array(name, self.parameters[indices[0]].unit, value)
        if whole.ndim == 0 or whole.shape[-1] != len(indices):
            raise ValueError(
                f"`{name}` is a vector: the last axis has {len(indices)} components, "
                f"the shape is {whole.shape}"
            )
        return {index: whole[..., k] for k, index in enumerate(indices)}
