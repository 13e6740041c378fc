"""Effects of tolerances, and figures of a cycle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ._assembly import evaluate
from ._describe import Function
from ._errors import AnalysisError

if TYPE_CHECKING:
    import numpy as np

    from ._assembly import Assembly, BoundFunction


class Tolerance(NamedTuple):
    """The effects of the tolerances on a quantity, in its unit: arrays of the shape `S`.

    `worst` is the longest error that is possible, `statistical` the root of the sum of squares,
    `parts` has the length of the effect of each dimension. `text` has all definitions for the first
    position.
    """

    worst: np.ndarray
    statistical: np.ndarray
    parts: dict[str, np.ndarray]
    text: str


class Extreme(NamedTuple):
    """A stationary place: `high`, `low` or `pass`; `is_end` is true at an end of the curve."""

    at: float
    value: float
    kind: str
    is_end: bool


class Extremes(NamedTuple):
    """The stationary places in order of the input, the lowest and the highest value."""

    points: tuple[Extreme, ...]
    lowest: Extreme
    highest: Extreme

    @property
    def stroke(self) -> float:
        """The highest value less the lowest one."""
        return self.highest.value - self.lowest.value


class Dwell(NamedTuple):
    """An interval in which a quantity stays within the band."""

    start: float
    end: float
    length: float
    lowest: float
    highest: float


class Summary(NamedTuple):
    """The figures of a quantity over the range of an input.

    `velocity` and `acceleration` are those of derivatives whose derivative the function has, else
    `None`. `strokes` are the lengths of rise and fall, `None` without two strokes.
    `transmission_angle` has the smallest and the greatest angle with its input, for a quantity that
    is the angle between two links. `parts` are the intervals in which it is assembled. Printed, the
    summary is a text with all figures.
    """

    position: Extremes
    velocity: Extremes | None
    acceleration: Extremes | None
    dwells: tuple[Dwell, ...]
    strokes: tuple[float, float] | None
    transmission_angle: tuple[tuple[float, float], tuple[float, float]]
    parts: tuple[tuple[float, float], ...]
    text: str

    def __str__(self) -> str:
        return self.text


def tolerance(
    assembly: Assembly, bound: BoundFunction, arguments: tuple, named: dict
) -> dict[str, Tolerance]:
    """Returns the effects on each sensitive quantity of a function."""
    import numpy as np

    function = bound.function
    given, dimensions = bound.arrays(arguments, named)
    result = evaluate(bound, given, dimensions)
    columns = np.ascontiguousarray(result._numbers)
    native = assembly._native.effects(function.index, columns)
    if not native:
        raise AnalysisError(
            f"`{function.name}` has no sensitivities\nhelp: add a field as `e: sensitivity(q)`"
        )
    names = list(assembly.mechanism.parameters)
    found = {}
    for name, parameters, worst, statistical, parts, text in native:
        shaped = [np.array(part).reshape(result.shape) for part in (worst, statistical, *parts)]
        by_name = dict(zip((names[index] for index in parameters), shaped[2:]))
        found[name] = Tolerance(shaped[0], shaped[1], by_name, text)
    return found


def summary(
    assembly: Assembly,
    bound: BoundFunction,
    quantity: str,
    positions: int,
    band: float | None,
    range: tuple[float, float] | None,
    arguments: dict[str, float],
) -> Summary:
    """Returns the figures of a quantity of a function over the range of its input."""
    function = bound.function
    inputs = assembly.mechanism.inputs
    running = [one.name for one in function.arguments if one.name in inputs]
    if len(running) != 1:
        raise AnalysisError(
            f"a summary follows one input: `{function.name}` takes {len(running)}"
        )
    columns = _cascade(function, quantity)
    driven = inputs[running[0]]
    low, high = (driven.low, driven.high) if range is None else range
    taken, dimensions = bound.bind((), {**arguments, driven.name: driven.reference})
    if dimensions:
        raise TypeError("dimensions of a summary are those of the assembly")
    numbers = [float(taken[one.name]) for one in function.arguments]
    index = [one.name for one in function.arguments].index(driven.name)
    units = (function.columns[columns[0]].unit, driven.unit)
    extremes, dwells, strokes, angle, parts, text = assembly._native.curve(
        function.index, numbers, index, columns, (float(low), float(high)), positions, band, units
    )
    found: list[Any] = [_extremes(one) for one in extremes]
    found += [None] * (3 - len(found))
    return Summary(
        position=found[0],
        velocity=found[1],
        acceleration=found[2],
        dwells=tuple(Dwell(*one) for one in dwells),
        strokes=strokes,
        transmission_angle=tuple(angle),
        parts=tuple(parts),
        text=text,
    )


def _extremes(points: list) -> Extremes:
    points = [Extreme(*one) for one in points]
    return Extremes(tuple(points[:-2]), *points[-2:])


def _cascade(function: Function, quantity: str) -> list[int]:
    """The columns of a quantity and of up to three derivatives."""
    names = [column.name for column in function.columns]
    if quantity not in names:
        known = ", ".join(names)
        raise AnalysisError(f"`{function.name}` has no number `{quantity}`; it has {known}")
    first = names.index(quantity)
    orders = {
        column.order: index
        for index, column in enumerate(function.columns)
        if column.kind == "rate" and column.of == first
    }
    columns = [first]
    while len(columns) < 4 and len(columns) in orders:
        columns.append(orders[len(columns)])
    if len(columns) < 2:
        raise AnalysisError(
            f"`{function.name}` has no derivative of `{quantity}`\n"
            f"help: add a field as `v: velocity({quantity})`"
        )
    return columns
