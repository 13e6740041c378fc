"""Random mechanisms within their tolerances."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _linkage
from ._describe import Function
from ._errors import AnalysisError
from ._numbers import unknown
from ._threads import threads

if TYPE_CHECKING:
    import numpy as np

    from ._assembly import Assembly, BoundFunction


class Estimate(NamedTuple):
    """An estimate from samples, and the ends of its confidence interval."""

    value: float
    low: float
    high: float


class Statistics(NamedTuple):
    """Figures of a quantity over the mechanisms that close; intervals are of 95 %."""

    count: int
    mean: Estimate
    deviation: Estimate
    skewness: float
    least: float
    largest: float


class ExtremeMechanism(NamedTuple):
    """The least or the largest value of a study: number and dimensions of its mechanism."""

    value: float
    number: int
    dimensions: dict[str, float]


class _Plan(NamedTuple):
    """All that a study is drawn from: arguments of the native module."""

    function: tuple[int, list[float], list[int]]
    draw: tuple[int, int, str, list[tuple[int, str]], int, int]


class Study:
    """The results of a study by random sampling, or of a part of it.

    Values are counted and not kept: 2 MB for each quantity. Mechanisms depend on the seed and their
    number alone, and are those of `MonteCarlo` of Rust. `quantities` are names of columns. Printed,
    a study is a table.
    """

    __slots__ = ("assembly", "quantities", "_native", "_plan")

    def __init__(self, assembly: Assembly, quantities: tuple[str, ...], native, plan: _Plan):
        self.assembly = assembly
        self.quantities = quantities
        self._native = native
        self._plan = plan

    @property
    def done(self) -> int:
        """The number of mechanisms that are evaluated."""
        return self._native.done

    @property
    def missing(self) -> int:
        """The number of mechanisms that do not close."""
        return self._native.missing

    def statistics(self, quantity: str) -> Statistics:
        """Returns mean, standard deviation, skewness and limits of a quantity."""
        count, mean, deviation, *rest = self._native.statistics(self._number(quantity))
        return Statistics(count, Estimate(*mean), Estimate(*deviation), *rest)

    def percentile(self, quantity: str, part: float, confidence: float = 0.95) -> Estimate:
        """Returns the value below which a part of the mechanisms is, 0.95 for the 95th percentile.

        It is NaN if no mechanism closes, or an argument is not between 0 and 1.
        """
        return Estimate(*self._native.percentile(self._number(quantity), part, confidence))

    def part_within(
        self, quantity: str, low: float, high: float, confidence: float = 0.95
    ) -> Estimate:
        """Returns the part of all mechanisms whose quantity is between two limits: the yield."""
        return Estimate(*self._native.part_within(self._number(quantity), low, high, confidence))

    def histogram(
        self, quantity: str, bins: int = 50, range: tuple[float, float] | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Returns counts and edges of bins, as `numpy.histogram`: from the least value to the largest.

        Counts are those of exact limits to a part in 16,000 of the standard deviation.
        """
        import numpy as np

        if bins < 1:
            raise ValueError(f"{bins} bins: a histogram has at least 1")
        number = self._number(quantity)
        low, high = self._native.statistics(number)[-2:] if range is None else range
        counts = np.array(self._native.histogram(number, low, high, bins))
        return counts, np.linspace(low, high, bins + 1)

    def extremes(self, quantity: str) -> tuple[ExtremeMechanism, ExtremeMechanism] | None:
        """Returns the mechanisms with the least and the largest value; `None` if none closes."""
        found = self._native.extremes(self._number(quantity))
        if found is None:
            return None
        names = list(self.assembly.mechanism.parameters)
        least, largest = (
            ExtremeMechanism(value, number, dict(zip(names, dimensions)))
            for value, number, dimensions in found
        )
        return least, largest

    def merge(self, *others: Study) -> Study:
        """Returns these results and those of other parts of the same study.

        They are equal to those of the whole study, to the last bit, in any order.

        Raises
        ------
        AnalysisError
            If a part is of another study, or has mechanisms that are there already.
        """
        native = self._native.merged([other.to_bytes() for other in others])
        return Study(self.assembly, self.quantities, native, self._plan)

    def to_bytes(self) -> bytes:
        """Returns the results as bytes: equal for equal studies."""
        return self._native.to_bytes()

    def _number(self, quantity: str) -> int:
        if quantity not in self.quantities:
            error = unknown("quantity", quantity, list(self.quantities), "the study")
            raise KeyError(str(error))
        return self.quantities.index(quantity)

    def __reduce__(self):
        return _read, (self.assembly, self.quantities, self._plan, self.to_bytes())

    def __str__(self) -> str:
        lines = [f"{self.done} mechanisms, {self.missing} do not close"]
        lines.append(f"{'':16}{'mean':>14}{'deviation':>14}{'0.135 %':>14}{'99.865 %':>14}")
        for name in self.quantities:
            found = self.statistics(name)
            limits = [self.percentile(name, part).value for part in (0.00135, 0.99865)]
            numbers = (found.mean.value, found.deviation.value, *limits)
            lines.append(f"{name:16}" + "".join(f"{number:14.6g}" for number in numbers))
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Study of {self.assembly.mechanism.name}: {self.done} mechanisms>"


def study(
    bound: BoundFunction,
    arguments: tuple,
    named: dict[str, Any],
    quantities: Sequence[str] | None,
    count: float,
    seed: int,
    distribution: str,
    distributions: dict[str, str],
    part: tuple[int, int],
    progress: Callable[[int, int], object] | None,
) -> Study:
    """Draws and evaluates mechanisms in the modes of an assembly."""
    function, assembly = bound.function, bound.assembly
    taken, dimensions = bound.bind(arguments, named)
    if dimensions:
        raise TypeError(
            "dimensions of a study are those of the assembly\nhelp: assemble with other dimensions, "
            "or change tolerances with `mechanism.with_tolerances`"
        )
    if not any(one.tolerance for one in assembly.mechanism.parameters.values()):
        raise AnalysisError(
            f"no dimension of {assembly.mechanism.name} has a tolerance\nhelp: write "
            "`param crank = 50mm +- 12um;`, or call `with_tolerances` of the mechanism"
        )
    numbers = [float(taken[one.name]) for one in function.arguments]
    columns = _columns(function, quantities)
    names = list(assembly.mechanism.parameters)
    exceptions = []
    for name, own in distributions.items():
        if name not in names:
            raise unknown("dimension", name, names, assembly.mechanism.name)
        exceptions.append((names.index(name), own))
    if int(count) != count or count < 0:
        raise ValueError(f"{count} mechanisms: a study has a whole number of them")
    plan = _Plan(
        (function.index, numbers, columns),
        (int(count), seed, distribution, exceptions, *part),
    )
    shown = None if progress is None else (lambda done, all, _: progress(done, all))
    native = _linkage.random_study(assembly._native, *plan, threads(), shown)
    return Study(assembly, tuple(function.columns[k].name for k in columns), native, plan)


def _columns(function: Function, quantities: Sequence[str] | None) -> list[int]:
    """The columns of quantities: fields, or single numbers of them."""
    names = [column.name for column in function.columns]
    if quantities is None:
        return [k for k, column in enumerate(function.columns) if column.kind == "value"]
    found = []
    for quantity in [quantities] if isinstance(quantities, str) else quantities:
        field = function.fields.get(quantity)
        if field is not None:
            found += range(field.first, field.first + field.width)
        elif quantity in names:
            found.append(names.index(quantity))
        else:
            known = [*function.fields, *(name for name in names if name not in function.fields)]
            raise unknown("quantity", quantity, known, f"`{function.name}`")
    return found


def _read(assembly: Assembly, quantities: tuple[str, ...], plan: _Plan, data: bytes) -> Study:
    """Reads a copied study."""
    native = _linkage.read_study(assembly._native, *plan, data)
    return Study(assembly, quantities, native, plan)
