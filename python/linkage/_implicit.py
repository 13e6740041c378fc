"""Uncertain numbers as arguments and dimensions: derivatives of the closed loops.

Numbers of `uncertainties` and GTC carry their derivatives through arithmetic. A mechanism is solved
for their values; then each result is one Newton step from there, `y + sum(dy/dx * (x - value(x)))`.
The derivatives are exact, those of the implicit functions that the loops define, so results keep
their correlations. Beyond a dead point they are NaN.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._errors import AnalysisError
from ._results import Entries, Result

if TYPE_CHECKING:
    from ._assembly import Assembly, BoundFunction
    from ._describe import Function


def is_uncertain(value: Any) -> bool:
    """Returns true for a number of `uncertainties` or GTC."""
    kind = type(value)
    return hasattr(kind, "nominal_value") or (hasattr(kind, "x") and hasattr(kind, "u"))


def nominal(value: Any) -> float:
    """Returns the value of an uncertain number."""
    return float(value.nominal_value if hasattr(value, "nominal_value") else value.x)


def uncertain(bound: BoundFunction, arguments: tuple, named: dict) -> Result:
    """Computes a function at one position, with some uncertain arguments and dimensions.

    Fields that are numbers are uncertain numbers, points are arrays of them.

    Raises
    ------
    AnalysisError
        If an uncertain argument is no input, or a field has no derivative.
    ValueError
        For an array as another argument.
    """
    taken, dimensions = bound.bind(arguments, named)
    mechanism = bound.assembly.mechanism
    steps = {}
    values = {}
    for name, value in {**taken, **dimensions}.items():
        if is_uncertain(value):
            values[name] = nominal(value)
            steps[mechanism.dimensions.aliases.get(name, name)] = value - values[name]
        else:
            values[name] = value
    for name in steps:
        if name not in mechanism.inputs and name not in mechanism.parameters:
            raise AnalysisError(
                f"`{name}` is uncertain, and neither an input nor one number of a dimension"
            )
    function = bound.function
    derived = derivatives(bound.assembly, function, tuple(function.fields), tuple(steps))
    result = derived(**values)
    if result.shape:
        raise ValueError("uncertain numbers and arrays do not go together: call it for each number")
    stepped = Result(function, result.shape, result.arguments, result._numbers)
    for number, name in enumerate(function.fields):
        slopes = [result[f"linkage_{number}_{index}"] for index in range(len(steps))]
        stepped._fields[name] = _moved(result[name], slopes, list(steps.values()))
    return stepped


def _moved(value: Any, slopes: list, steps: list) -> Any:
    """A field after the step."""
    import numpy as np

    if isinstance(value, Entries):
        entries = [
            _moved(value[k], [slope[k] for slope in slopes], steps) for k in range(len(value))
        ]
        return Entries(value.names, entries)
    if np.ndim(value):
        moved = np.empty(value.shape, dtype=object)
        for index in np.ndindex(value.shape):
            moved[index] = _moved(value[index], [slope[index] for slope in slopes], steps)
        return moved
    total = float(value)
    for slope, step in zip(slopes, steps):
        total = total + float(slope) * step
    return total


def derivatives(
    assembly: Assembly, function: Function, fields: tuple[str, ...], variables: tuple[str, ...]
) -> BoundFunction:
    """Returns a function with all fields of another one, and then the derivatives of some of them.

    The derivative of field `i` with respect to variable `j` is the field `linkage_i_j`.

    Raises
    ------
    AnalysisError
        If the compiler has no such derivative.
    """
    extended = assembly.mechanism._derived(function.name, fields, variables)
    if extended is None:
        names = "`, `".join(variables)
        raise AnalysisError(
            f"a field of `{function.name}` has no derivative with respect to `{names}`"
        )
    again = extended._assemble(list(assembly._native.dimensions))
    if again.modes != assembly.modes:
        raise AnalysisError("derivatives are those of the assembly that the estimates choose")
    return again[list(extended.functions)[-1]]
