"""Followers: from position to position."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._assembly import BoundFunction
from ._describe import Function
from ._numbers import unknown
from ._results import Result

if TYPE_CHECKING:
    from ._assembly import Assembly


class Follower:
    """An assembly at some inputs, which goes from there to others.

    Its functions are those of the assembly, `f.motion()`, at its position: they take speeds and
    loads, and no inputs. Groups without a closed form are followed from their current state,
    whatever the ranges of the inputs are.
    """

    __slots__ = ("assembly", "_native")

    def __init__(self, assembly: Assembly, native):
        self.assembly = assembly
        self._native = native

    @property
    def inputs(self) -> dict[str, float]:
        """The inputs of its position."""
        return dict(zip(self.assembly.mechanism.inputs, self._native.inputs))

    def go(self, *inputs: float, **named: float) -> Follower:
        """Goes straight to other inputs, in steps that are certain to stay on the assembly.

        Inputs that are not given stay as they are. Returns the follower.

        Raises
        ------
        AssemblyError
            Where no step leads any further, as at a dead point; the follower stays where it was.
        """
        names = list(self.assembly.mechanism.inputs)
        stay = {
            name: value
            for name, value in self.inputs.items()
            if name not in names[: len(inputs)] and name not in named
        }
        self._native.follow(self.assembly.mechanism.position(inputs, {**named, **stay}))
        return self

    def __getitem__(self, function: str) -> FollowerFunction:
        return FollowerFunction(self, self.assembly[function].function)

    def __getattr__(self, name: str) -> FollowerFunction:
        if name.startswith("__"):
            raise AttributeError(name)
        functions = self.assembly.mechanism.functions
        if name not in functions:
            error = unknown("function", name, list(functions), self.assembly.mechanism.name)
            raise AttributeError(str(error))
        return FollowerFunction(self, functions[name])

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.assembly.mechanism.functions]

    def __repr__(self) -> str:
        inputs = ", ".join(f"{name}={value:g}" for name, value in self.inputs.items())
        return f"<Follower of {self.assembly.mechanism.name} at {inputs}>"


class FollowerFunction:
    """A function at the position of a follower: it takes speeds and loads by name."""

    __slots__ = ("follower", "function")

    def __init__(self, follower: Follower, function: Function):
        self.follower = follower
        self.function = function

    def __call__(self, **named: Any) -> Result:
        import numpy as np

        assembly = self.follower.assembly
        position = self.follower.inputs
        given = {one.name: position[one.name] for one in self.function.arguments if one.name in position}
        for name in named:
            if name in given or assembly.mechanism.dimensions.has(name):
                raise TypeError(f"`{name}` is that of the follower")
        arrays, _ = BoundFunction(assembly, self.function).arrays((), {**given, **named})
        numbers = [float(value) for value in arrays.values()]
        found = self.follower._native.call(self.function.index, numbers)
        return Result(self.function, (), arrays, np.array(found).reshape(-1, 1))


def follower(assembly: Assembly, inputs: tuple, named: dict) -> Follower:
    """Returns a follower of an assembly at these inputs; others are at their references."""
    at = assembly.mechanism.position(inputs, named)
    return Follower(assembly, assembly._native.follower(at))
