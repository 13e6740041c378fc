"""Assembled mechanisms and their functions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _numbers
from ._describe import Function
from ._numbers import unknown
from ._results import Result
from ._threads import threads

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    import numpy as np

    from ._analysis import Summary, Tolerance
    from ._follower import Follower
    from ._mechanism import Mechanism
    from ._study import Study


class Assembly:
    """A mechanism whose loops are closed with some dimensions, in one assembly.

    The functions of the mechanism are its attributes, `m.motion(phi)`, and items, `m["motion"]`.
    An assembly cannot be changed, and threads may share it.

    Attributes
    ----------
    mechanism : Mechanism
        The mechanism.
    """

    __slots__ = ("mechanism", "_native", "_recipe", "_machine")

    def __init__(self, mechanism: Mechanism, native, recipe: tuple):
        self.mechanism = mechanism
        self._native = native
        self._recipe = recipe
        self._machine = None

    @property
    def dimensions(self) -> dict[str, float]:
        """The dimensions, in the units of `mechanism.parameters`."""
        return dict(zip(self.mechanism.parameters, self._native.dimensions))

    @property
    def modes(self) -> tuple[int, ...]:
        """The mode of each group that has two: 1 or -1."""
        return tuple(self._native.modes)

    @property
    def served(self) -> float:
        """The share of the ranges of the inputs in which coupled groups are assembled, to 1."""
        return self._native.served

    def __getitem__(self, function: str) -> BoundFunction:
        functions = self.mechanism.functions
        if function not in functions:
            error = unknown("function", function, list(functions), self.mechanism.name)
            raise KeyError(str(error))
        return BoundFunction(self, functions[function])

    def __getattr__(self, name: str) -> BoundFunction:
        if name.startswith("__"):
            raise AttributeError(name)
        functions = self.mechanism.functions
        if name not in functions:
            error = unknown("function", name, list(functions), self.mechanism.name)
            raise AttributeError(str(error))
        return BoundFunction(self, functions[name])

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.mechanism.functions]

    def unknowns(self, *inputs: float, **named: float) -> dict[str, Any]:
        """Returns the unknowns at a position: angles in radians, points as arrays.

        Inputs that are not given are at their references.
        """
        import numpy as np

        at = self.mechanism.position(inputs, named)
        found = {}
        for name, numbers in self._native.unknowns(at):
            found[name] = numbers[0] if len(numbers) == 1 else np.array(numbers)
        return found

    def gaps(self, *inputs: Any, **named: Any) -> np.ndarray:
        """Returns the gaps by which the groups miss closing.

        Parameters
        ----------
        inputs
            Values or arrays of all inputs in order, or by name; others are at their references.

        Returns
        -------
        array, shape S + (groups,)
            0 for a group that closes, the distance in the unit of its loops for one that does not,
            and NaN for those after it. `mechanism.groups` has their unknowns and
            joints.
        """
        import numpy as np

        given = self.mechanism.input_arrays(inputs, named)
        shape, flat = _numbers.broadcast(given)
        count = _numbers.size(shape)
        out = np.empty((len(self.mechanism.groups), count))
        whole = [np.ascontiguousarray(np.broadcast_to(one, (count,))) for one in flat]
        self._native.gaps(whole, out)
        return np.moveaxis(out.reshape(-1, *shape), 0, -1)

    def check_range(self) -> tuple[bool, str]:
        """Checks the declared range: true if it has no findings, and the report."""
        return self._native.check_range()

    def tolerance(self, function: str, *arguments: Any, **named: Any) -> dict[str, Tolerance]:
        """Returns the effects of the tolerances on each quantity with `sensitivity(q)`.

        Arguments are those of the function, values or arrays. Tolerances are those of the text, or
        of `mechanism.with_tolerances`.

        Raises
        ------
        AnalysisError
            If a tolerance is negative or no number, or if the function has no sensitivities.
        """
        from ._analysis import tolerance

        return tolerance(self, self[function], arguments, named)

    def monte_carlo(
        self,
        function: str,
        *arguments: float,
        quantities: str | Sequence[str] | None = None,
        count: int = 100_000,
        seed: int = 0,
        distribution: str = "normal",
        distributions: Mapping[str, str] | None = None,
        part: tuple[int, int] = (0, 1),
        progress: Callable[[int, int], object] | None = None,
        **named: float,
    ) -> Study:
        """Draws mechanisms within their tolerances, and evaluates a function of each.

        Mechanism number `k` depends on the seed and `k` alone. Results are those of `MonteCarlo` of
        Rust, to the last bit, for every number of threads and parts.

        Parameters
        ----------
        arguments
            The position: arguments of the function in order or by name.
        quantities
            Fields or columns that are counted, at most 4 columns: by default all values of the
            function, without derivatives.
        count, seed
            The number of mechanisms; another seed gives other ones.
        distribution
            `normal` with a standard deviation of a third of the tolerance, `uniform`, `triangular`,
            `arcsine` or `truncated normal`.
        distributions
            Distributions of single dimensions, by name.
        part
            Number of the part, from 0, and number of parts: `Study.merge` unites them.
        progress
            A function that is called with the mechanisms that are done, and all of them.

        Raises
        ------
        AnalysisError
            For tolerances below zero or none at all, a part that does not exist, and no or too many
            quantities.
        """
        from ._study import study

        return study(
            self[function], arguments, named, quantities, count, seed, distribution,
            distributions or {}, part, progress,
        )  # fmt: skip

    def summary(
        self,
        function: str,
        quantity: str,
        *,
        positions: int = 360,
        band: float | None = None,
        range: tuple[float, float] | None = None,
        **arguments: float,
    ) -> Summary:
        """Returns the figures of a quantity over the range of the function's input.

        Parameters
        ----------
        quantity
            A field that is a number, or a component of one, as `tracer.x`. The function must have
            its `velocity`; with `acceleration` and `jerk` more figures are exact.
        positions
            Evenly spaced positions from which roots are searched.
        band
            The height within which the quantity rests, in its unit: for `dwells`.
        range
            Another range of the input than the declared one.
        arguments
            Speeds and loads of the function by name.

        Raises
        ------
        AnalysisError
            If the derivative is missing or the mechanism closes nowhere in the range.
        """
        from ._analysis import summary

        return summary(self, self[function], quantity, positions, band, range, arguments)

    def follow(self, *inputs: float, **named: float) -> Follower:
        """Returns a follower: it goes from position to position in this assembly.

        It begins at these inputs, by default at the references. Groups that have no closed form
        are followed from their current state, whatever the ranges of the inputs are.

        Raises
        ------
        AssemblyError
            If there is no assembly at the inputs.
        """
        from ._follower import follower

        return follower(self, inputs, named)

    def page(self, positions: int = 361) -> str:
        """Returns a page with drawing, plots and tables of this many positions as HTML.

        The file needs nothing else. Raises `LinkageError` for a mechanism without an input.
        """
        return self.mechanism.page(positions, dimensions=self._native.dimensions)

    def _repr_html_(self) -> str:
        from ._html import frame

        return frame(self.page(121), self.mechanism.name)

    def __copy__(self) -> Assembly:
        return self

    def __deepcopy__(self, _memo) -> Assembly:
        return self

    def __reduce__(self):
        return _assembled, (self.mechanism, self._recipe)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Assembly):
            return NotImplemented
        return (self.mechanism, self._recipe) == (other.mechanism, other._recipe)

    def __hash__(self) -> int:
        return hash((self.mechanism, self._recipe[0], tuple(self._native.dimensions)))

    def __repr__(self) -> str:
        parameters = self.mechanism.parameters.values()
        numbers = zip(parameters, self._native.dimensions)
        shown = ", ".join(f"{one.name}={number:g}" for one, number in numbers)
        return f"<Assembly of {self.mechanism.name}: {shown}>"


def _assembled(mechanism: Mechanism, recipe: tuple) -> Assembly:
    """Assembles a copied assembly again."""
    kind, *arguments = recipe
    return getattr(mechanism, kind)(*arguments)


class BoundFunction:
    """A function of an assembly.

    It takes the function's arguments in order or by name, then dimensions by name: numbers or
    arrays of any shape, which are broadcast together. Where arrays of dimensions are given, each
    position is another mechanism in the modes of this assembly. `out` takes a result of the same
    function and size whose arrays are filled again, which saves the time for new memory: it is
    returned, with the new arguments.

    Numbers of `uncertainties` and GTC may be inputs and dimensions of one position: results are
    such numbers, too.

    Returns a `Result`. Numbers alone give the bits of a single call of the macro, arrays those of
    its sweeps, which do not depend on their length or on threads.

    Raises
    ------
    TypeError
        For a missing, unknown or repeated name, or anything that is no real number.
    ValueError
        For shapes that do not fit together.
    """

    __slots__ = ("assembly", "function")

    def __init__(self, assembly: Assembly, function: Function):
        self.assembly = assembly
        self.function = function

    @property
    def __name__(self) -> str:
        return self.function.name

    @property
    def __signature__(self):
        import inspect

        kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
        named = [
            inspect.Parameter(
                one.name, kind, default=inspect.Parameter.empty if one.default is None else one.default
            )
            for one in self.function.arguments
        ]
        rest = inspect.Parameter("dimensions", inspect.Parameter.VAR_KEYWORD)
        return inspect.Signature([*named, rest])

    def __call__(self, *arguments: Any, out: Result | None = None, **named: Any) -> Result:
        from ._implicit import is_uncertain, uncertain

        if any(is_uncertain(value) for value in (*arguments, *named.values())):
            return uncertain(self, arguments, named)
        given, dimensions = self.arrays(arguments, named)
        return evaluate(self, given, dimensions, out)

    def arrays(self, arguments: tuple, named: dict) -> tuple[dict, dict]:
        """Returns arrays of all arguments by name, and of given dimensions by index."""
        taken, dimensions = self.bind(arguments, named)
        given = {
            one.name: _numbers.array(one.name, one.unit, taken[one.name])
            for one in self.function.arguments
        }
        return given, self.assembly.mechanism.dimensions.given(dimensions)

    def bind(self, arguments: tuple, named: dict) -> tuple[dict, dict]:
        """Returns the value of each argument by name, and dimensions by name."""
        own = self.function.arguments
        name = self.function.name
        if len(arguments) > len(own):
            takes = ", ".join(one.name for one in own) or "nothing"
            raise TypeError(f"`{name}` takes {takes}: {len(arguments)} arguments are too many")
        taken = {one.name: value for one, value in zip(own, arguments)}
        dimensions = {}
        names = {one.name for one in own}
        for key, value in named.items():
            if key in taken and key in names:
                raise TypeError(f"argument `{key}` of `{name}` is given twice")
            if key in names:
                taken[key] = value
            elif self.assembly.mechanism.dimensions.has(key):
                dimensions[key] = value
            else:
                known = [*(one.name for one in own), *self.assembly.mechanism.parameters]
                raise unknown("argument or dimension", key, known, f"`{name}`")
        for one in own:
            if one.name not in taken:
                if one.default is None:
                    raise TypeError(f"`{name}` needs the argument `{one.name}`")
                taken[one.name] = one.default
        return taken, dimensions

    def __repr__(self) -> str:
        return f"<function {self.function}>"

    def __reduce__(self):
        return _function, (self.assembly, self.function.name)


def _function(assembly: Assembly, name: str) -> BoundFunction:
    return assembly[name]


def evaluate(
    bound: BoundFunction,
    given: dict[str, np.ndarray],
    dimensions: dict[int, np.ndarray],
    reused: Result | None = None,
) -> Result:
    """Computes a function for arrays of all its arguments, and of some dimensions by index.

    The arrays of a result that is no longer needed are filled again.
    """
    import numpy as np

    function, native = bound.function, bound.assembly._native
    parameters = bound.assembly.mechanism.dimensions.parameters
    named = {parameters[index].name: value for index, value in dimensions.items()}
    shape, flat = _numbers.broadcast({**given, **named})
    arguments = {**given, **named}
    if shape == () and not dimensions:
        numbers = native.call(function.index, [float(one) for one in given.values()])
        return Result(function, shape, arguments, np.array(numbers).reshape(-1, 1))
    wanted = (len(function.columns), _numbers.size(shape))
    if reused is None:
        result = Result(function, shape, arguments, np.empty(wanted))
    elif reused._numbers.shape == wanted and reused.function == function:
        result = reused._refilled(shape, arguments)
    else:
        raise ValueError(
            f"`out` is a result of `{reused.function.name}` at {reused.shape}: a result of "
            f"`{function.name}` at {shape} is needed"
        )
    flat, others = flat[: len(given)], flat[len(given) :]
    sets = None
    if dimensions:
        sets = [np.array([number]) for number in native.dimensions]
        for index, one in zip(dimensions, others):
            sets[index] = one
    if bound.assembly.mechanism._code is not None:
        from ._compiled import code_sweep

        if code_sweep(bound, sets, flat, result._numbers):
            return result
    native.sweep(function.index, sets, flat, result._numbers, threads())
    return result
