"""Dimensions for requirements: problems, and the designs that a search finds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _linkage, _numbers
from ._assembly import Assembly
from ._threads import threads

if TYPE_CHECKING:
    import numpy as np

    from ._mechanism import Mechanism

#: Bounds, a part of the size, or a list of values.
Range = tuple[float, float] | float | Sequence[float]

#: Inputs that the search chooses, by their order.
ORDERS = ("in order", "backwards", "free")


class Target:
    """Values that quantities of a function should have at positions.

    Parameters
    ----------
    function
        A function of the input with the quantities, their `sensitivity(q)` for all dimensions that
        may change and, without `at`, their `velocity(q)`.
    quantity
        A field as `tracer`, or several: a pose is `("tracer", "theta")`.
    values : array, shape (positions, numbers) or (positions,)
        The wanted numbers of all quantities, angles in radians.
    at : array, shape (positions,)
        The inputs of the positions. Without it the search chooses them.
    order
        `in order` for positions that follow each other as the input grows, `backwards` as it falls,
        or `free`.
    step
        The distance from each input to the next one: the search chooses the first one.
    weights : array, shape (numbers,)
        The inverse of a difference that is as bad as 1; by default 1.
    """

    __slots__ = ("function", "quantities", "values", "timing", "weights")

    def __init__(
        self,
        function: str,
        quantity: str | Sequence[str],
        values: Any,
        *,
        at: Any = None,
        order: str = "in order",
        step: float | None = None,
        weights: Any = None,
    ):
        self.function = function
        self.quantities = (quantity,) if isinstance(quantity, str) else tuple(quantity)
        rows = _numbers.array("values", "", values)
        self.values = rows.reshape(-1, 1) if rows.ndim == 1 else rows
        if self.values.ndim != 2:
            raise ValueError(
                f"`values` has the shape {rows.shape}: rows are positions, columns are numbers"
            )
        if order not in ORDERS:
            raise ValueError(f"no order `{order}`; there are `{'`, `'.join(ORDERS)}`")
        if at is not None and step is not None:
            raise ValueError("inputs are given by `at`, or by `step`")
        self.timing: tuple[str, list[float]] = (order, [])
        if at is not None:
            self.timing = ("given", _numbers.array("at", "", at).ravel().tolist())
        elif step is not None:
            self.timing = ("evenly", [float(step)])
        self.weights = None
        if weights is not None:
            self.weights = _numbers.array("weights", "", weights).ravel().tolist()

    def __repr__(self) -> str:
        names = ", ".join(self.quantities)
        return f"<Target: {names} of `{self.function}` at {len(self.values)} positions>"


class Relation(NamedTuple):
    """A linear relation: the sum of dimensions, each times its factor, is at most `most`."""

    terms: tuple[tuple[str, float], ...]
    most: float
    is_equality: bool = False


def at_most(terms: Mapping[str, float], most: float) -> Relation:
    """Returns a relation: the sum of dimensions, each times its factor, is at most `most`."""
    return Relation(tuple(terms.items()), float(most))


def at_least(terms: Mapping[str, float], least: float) -> Relation:
    """Returns a relation: the sum is at least `least`."""
    return at_most({name: -factor for name, factor in terms.items()}, -least)


def exactly(terms: Mapping[str, float], total: float) -> Relation:
    """Returns a relation: the sum is `total`."""
    return Relation(tuple(terms.items()), float(total), True)


def crank_turns(
    frame: str, crank: str, coupler: str, rocker: str, spare: float = 0.0
) -> tuple[Relation, ...]:
    """Returns Grashof's condition: the crank of a four-bar turns fully.

    With any other link it is shorter than the two that are left, by `spare` at least.
    """
    pairs = ((frame, coupler, rocker), (coupler, frame, rocker), (rocker, frame, coupler))
    return tuple(
        at_most({crank: 1.0, other: 1.0, first: -1.0, second: -1.0}, -spare)
        for other, first, second in pairs
    )


class Bound(NamedTuple):
    """A dimension at its bound, and how much the sum of squares falls for each unit beyond it."""

    bound: float
    gain: float


class Design(NamedTuple):
    """A local optimum that exists over the whole range on one circuit.

    `sum` is the sum of squares of all weighted differences, `residuals` has the differences of each
    target, shape (positions, numbers), and `inputs` the positions of each. `margin` is the smallest
    one over the range, at the input `margin_at`. `bounds` are the dimensions at their bounds,
    `relations` those in the way. `is_converged` is false if the descent used up its steps. `hits`
    is the number of starts that led here, `start` the first of them. Printed, a design is a text.
    """

    dimensions: dict[str, float]
    assembly: Assembly
    sum: float
    residuals: tuple[np.ndarray, ...]
    inputs: tuple[np.ndarray, ...]
    margin: float
    margin_at: float
    bounds: dict[str, Bound]
    relations: tuple[str, ...]
    is_converged: bool
    start: int
    hits: int
    text: str

    def __str__(self) -> str:
        return self.text


class Figures(NamedTuple):
    """Counts of a search: of a problem, of starts and of optima.

    `against_relations` and `apart` are starts that contradict relations or do not close,
    `not_whole` are optima that do not exist over the whole range, `left_out` those that are not
    listed.
    """

    residuals: int
    variables: int
    starts: int
    against_relations: int
    apart: int
    not_whole: int
    left_out: int
    evaluations: int
    ended_early: bool


class Designs(tuple):
    """All distinct local optima, the least sum of squares first. Printed, it is a table."""

    figures: Figures
    text: str

    @property
    def best(self) -> Design:
        """The design with the least sum of squares."""
        return self[0]

    def __str__(self) -> str:
        return self.text


def search(
    mechanism: Mechanism,
    vary: Mapping[str, Range],
    want: Target | Iterable[Target],
    hold: Iterable[Relation | Iterable[Relation]],
    start: Assembly | None,
    settings: tuple,
    progress: Callable[[int, int, float], object] | None,
) -> Designs:
    """Searches for designs of a mechanism."""
    numbers = [one.nominal for one in mechanism.parameters.values()]
    if start is not None:
        numbers = start._native.dimensions
    targets = [want] if isinstance(want, Target) else list(want)
    text, figures, found, natives = _linkage.design(
        mechanism._native,
        numbers,
        [one for name, given in vary.items() for one in _variables(mechanism, name, given)],
        _relations(mechanism, hold),
        [_target(mechanism, one) for one in targets],
        settings,
        threads(),
        progress,
    )
    designs = Designs(
        _design(mechanism, targets, one, native) for one, native in zip(found, natives)
    )
    designs.text = text
    designs.figures = Figures(*figures[0], figures[1])
    return designs


def _variables(mechanism: Mechanism, given: str, value: Range) -> list[tuple]:
    """The native variables of a name: those of all components of a vector."""
    kind, numbers = _range(given, value)
    dimensions = mechanism.dimensions
    name = dimensions.aliases.get(given, given)
    indices = dimensions.vectors.get(name)
    if indices is None:
        return [(name, kind, numbers)]
    return [(dimensions.parameters[index].name, kind, numbers) for index in indices]


def _range(name: str, value: Range) -> tuple[str, list[float]]:
    numbers = _numbers.array(name, "", value)
    if numbers.ndim == 0:
        return "by", [float(numbers)]
    if numbers.ndim == 1 and isinstance(value, tuple):
        if numbers.size != 2:
            raise ValueError(
                f"`{name}` has {numbers.size} bounds\nhelp: write 2 bounds as a tuple, a part of the "
                "size as a number, or values as a list"
            )
        return "between", numbers.tolist()
    return "one of", numbers.ravel().tolist()


def _relations(mechanism: Mechanism, hold: Iterable) -> list[tuple]:
    found = []
    for given in [hold] if isinstance(hold, Relation) else hold:
        for one in [given] if isinstance(given, Relation) else given:
            aliases = mechanism.dimensions.aliases
            terms = [(aliases.get(name, name), float(factor)) for name, factor in one.terms]
            found.append((terms, one.most, one.is_equality))
    return found


def _target(mechanism: Mechanism, target: Target) -> tuple:
    functions = mechanism.functions
    if target.function not in functions:
        raise _numbers.unknown("function", target.function, list(functions), mechanism.name)
    index = functions[target.function].index
    rows = target.values.tolist()
    return (index, list(target.quantities), rows, target.weights, *target.timing)


def _design(mechanism: Mechanism, targets: list[Target], found: tuple, native) -> Design:
    import numpy as np

    numbers, total, residuals, inputs, margin, bounds, converged, start, hits, held, text = found
    shaped = (
        np.array(one).reshape(target.values.shape) for one, target in zip(residuals, targets)
    )
    at = [one.reference for one in mechanism.inputs.values()]
    recipe = ("_whole", numbers, native.unknowns(at))
    return Design(
        dimensions=dict(zip(mechanism.parameters, numbers)),
        assembly=Assembly(mechanism, native, recipe),
        sum=total,
        residuals=tuple(shaped),
        inputs=tuple(np.array(one) for one in inputs),
        margin=margin[0],
        margin_at=margin[1],
        bounds={name: Bound(bound, gain) for name, bound, gain in bounds},
        relations=tuple(held),
        is_converged=converged,
        start=start,
        hits=hits,
        text=text,
    )
