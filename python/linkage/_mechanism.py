"""Mechanisms."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _describe, _numbers
from ._assembly import Assembly
from ._describe import Function, Input, Parameter
from ._dimensions import Dimensions
from ._errors import LinkageError, Message, messages

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Iterable, Mapping

    import numpy as np

    from ._circuits import Circuits
    from ._compiled import Code
    from ._design import Designs, Range, Relation, Target


class Origin(NamedTuple):
    """All that a mechanism is compiled from."""

    text: str
    file: str
    name: str
    any_range: bool
    fused: bool | None


class Group(NamedTuple):
    """Unknowns that are solved together, the kind of their group, such as `RRR`, and their loops.

    The loops are named by the joints and links that they stand for, or by their numbers.
    """

    unknowns: tuple[str, ...]
    kind: str
    loops: str


class Mechanism:
    """A compiled mechanism: names, units and functions, and the way to its assemblies.

    `load` and `parse` make it. It cannot be changed, and threads may share it.
    """

    def __init__(
        self,
        native,
        origin: Origin,
        tolerances: tuple[float, ...] | None = None,
        code: Code | None = None,
    ):
        self._native = native
        self._origin = origin
        self._tolerances = tolerances
        self._code = code
        self._extended: dict[tuple, Mechanism | None] = {}

    @property
    def name(self) -> str:
        """The name of its declaration."""
        return self._native.name

    @property
    def source(self) -> str:
        """The text that it was compiled from."""
        return self._origin.text

    @property
    def documentation(self) -> str:
        """The doc comment of its declaration."""
        return self._native.documentation.strip()

    @property
    def warnings(self) -> list[Message]:
        """The warnings of the compiler."""
        return messages(self._native.messages)

    @property
    def structure(self) -> str:
        """A table of its groups, with class, order, kind and method."""
        return self._native.structure

    @property
    def mobility(self) -> int:
        """The number of its degrees of freedom."""
        return self._native.mobility

    @cached_property
    def groups(self) -> tuple[Group, ...]:
        """Its groups in the order in which they are solved."""
        groups = self._native.groups
        return tuple(Group(tuple(unknowns), kind, loops) for unknowns, kind, loops in groups)

    @cached_property
    def dimensions(self) -> Dimensions:
        """The names of its dimensions."""
        return Dimensions(self.name, tuple(self.parameters.values()))

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        """Its scalar dimensions by name: unit, nominal value and tolerance."""
        return {one[0]: Parameter(*one) for one in self._native.parameters}

    @cached_property
    def inputs(self) -> dict[str, Input]:
        """Its inputs by name: unit, reference and range."""
        found = {}
        for name, unit, reference, declared, (low, high) in self._native.inputs:
            found[name] = Input(name, unit, reference, declared, low, high)
        return found

    @cached_property
    def functions(self) -> dict[str, Function]:
        """Its functions by name: arguments, fields and columns."""
        return _describe.functions(self._native, len(self.inputs))

    def assemble(self, **dimensions: Any) -> Assembly:
        """Closes the loops, in the assembly that the estimates of the text choose.

        Parameters
        ----------
        dimensions
            Numbers by name, in the units of `parameters`: those that are not given are nominal. A
            vector takes its components, `pivot=(140, 0)`, or one of them, `pivot_x=141`.

        Raises
        ------
        AssemblyError
            If the loops do not close at the reference inputs, or a dimension is NaN.
        """
        return self._assemble(self.dimensions.scalars(dimensions))

    def _assemble(self, numbers: list[float]) -> Assembly:
        return Assembly(self, self._native.assemble(numbers), ("_assemble", numbers))

    def assemblies(self, *inputs: float, **named: Any) -> list[Assembly]:
        """Returns every assembly at a position, the one that `assemble` chooses first.

        Parameters
        ----------
        inputs
            The position; inputs that are not given are at their references.
        named
            Inputs and dimensions by name.

        Raises
        ------
        AssemblyError
            If there is none.
        """
        own = {name: value for name, value in named.items() if name in self.inputs}
        rest = {name: value for name, value in named.items() if name not in self.inputs}
        return self._assemblies(self.dimensions.scalars(rest), self.position(inputs, own))

    def _assemblies(self, numbers: list[float], at: list[float]) -> list[Assembly]:
        found = self._native.assemblies(numbers, at)
        return [
            Assembly(self, native, ("_assembly", numbers, at, index))
            for index, native in enumerate(found)
        ]

    def _assembly(self, numbers: list[float], at: list[float], index: int) -> Assembly:
        return self._assemblies(numbers, at)[index]

    def assemble_from(self, assembly: Assembly, **dimensions: Any) -> Assembly:
        """Assembles other dimensions in the assembly of `assembly`, followed from there.

        Dimensions that are not given are those of `assembly`.

        Raises
        ------
        AssemblyError
            If the assembly ends on the way to the dimensions.
        """
        base = assembly._native.dimensions
        return self._assemble_from(self.dimensions.scalars(dimensions, base), assembly)

    def _assemble_from(self, numbers: list[float], assembly: Assembly) -> Assembly:
        native = self._native.assemble_from(numbers, assembly._native)
        return Assembly(self, native, ("_assemble_from", numbers, assembly))

    def circuits(self, **dimensions: Any) -> Circuits:
        """Follows every assembly over the range of the input.

        Raises
        ------
        AssemblyError
            If there is none.
        LinkageError
            If the mechanism has another number of inputs than one, or no loops.
        """
        from ._circuits import circuits

        return circuits(self, self.dimensions.scalars(dimensions))

    def _derived(self, function: str, fields: tuple, variables: tuple) -> Mechanism | None:
        """The mechanism with derivatives of a function, compiled once."""
        key = function, fields, variables
        if key not in self._extended:
            native = self._native.with_derivatives(function, list(fields), list(variables))
            found = None if native is None else Mechanism(native, self._origin, self._tolerances)
            self._extended[key] = found
        return self._extended[key]

    def _branch(self, numbers: list[float], index: int) -> Assembly:
        from ._circuits import circuits

        return circuits(self, numbers)[index].assembly

    def _whole(self, numbers: list[float], unknowns: list) -> Assembly:
        from ._circuits import whole

        return whole(self, numbers, unknowns)

    def design(
        self,
        vary: Mapping[str, Range],
        want: Target | Iterable[Target],
        *,
        hold: Iterable[Relation | Iterable[Relation]] = (),
        start: Assembly | None = None,
        starts: int | None = None,
        steps: int | None = None,
        seed: int = 0,
        listed: int | None = None,
        time_limit: float | None = None,
        progress: Callable[[int, int, float], object] | None = None,
    ) -> Designs:
        """Searches for dimensions with which quantities have wanted values.

        The search descends from many starts by least squares with exact derivatives, in all
        assemblies. Each design exists over the whole range on one circuit. Results are those of
        `linkage::design` of Rust with equal seed, for every number of threads.

        Parameters
        ----------
        vary
            The dimensions that may change, by name: bounds as a tuple, `(5, 60)`, a part of the
            size as a number, `0.1`, or a catalogue of values as a list. A vector has the same range
            for each component.
        want : Target or several
            The wanted values.
        hold
            Relations of `at_most`, `at_least`, `exactly` and `crank_turns`.
        start : Assembly
            Dimensions that do not change, and the sizes of parts; by default nominal.
        starts, steps, listed
            The number of starts (1024), the most evaluations of a descent (300), and the most
            designs in the list (100).
        time_limit
            Seconds after which no starts are begun.
        progress
            A function that is called with the starts that are done, all of them, and the least sum.

        Raises
        ------
        DesignError
            For mistakes in the problem, all at once, and if there is no design.
        """
        from ._design import search

        settings = (starts, steps, seed, listed, time_limit)
        return search(self, vary, want, hold, start, settings, progress)

    def with_tolerances(self, **tolerances: Any) -> Mechanism:
        """Returns the same mechanism with other tolerances, in the units of `parameters`."""
        given = self.dimensions.given(tolerances)
        numbers = [one.tolerance for one in self.parameters.values()]
        for index, value in given.items():
            if value.ndim:
                raise ValueError("a tolerance is one number, not an array")
            numbers[index] = float(value)
        return self._with_tolerances(tuple(numbers))

    def _with_tolerances(self, numbers: tuple[float, ...]) -> Mechanism:
        native = self._native.with_tolerances(list(numbers))
        return Mechanism(native, self._origin, numbers, self._code)

    @property
    def is_compiled(self) -> bool:
        """True if sweeps run as machine code of a C compiler."""
        return self._code is not None

    def compile(
        self, *, compiler: str | None = None, cache: str | os.PathLike | None = None
    ) -> Mechanism:
        """Returns the mechanism with sweeps as machine code of the system's C compiler.

        They take a fraction of the time of the interpreter, and have the numbers of `fused=False`:
        to the last bit if all groups have a closed form, else to the last digits. Sweeps of coupled
        groups over dimensions stay with the interpreter.

        Parameters
        ----------
        compiler
            The C compiler, by default `CC` of the environment, else `gcc`, `cc` or `clang`.
        cache
            The folder of compiled code, by default `LINKAGE_CACHE` of the environment, else
            `linkage` in the user's folder of caches. Equal mechanisms are compiled once.

        Raises
        ------
        LinkageError
            If there is no C compiler, it fails, or C cannot be exported for the mechanism.
        """
        from ._compiled import compiled

        return compiled(self, compiler=compiler, cache=cache)

    def to_c(self, folder: str | os.PathLike | None = None, *, scalar: str = "double"):
        """Returns the mechanism as C99: the texts of header and source by their file names.

        Parameters
        ----------
        folder
            Writes the two files into this folder, too.
        scalar
            `double`, `fused` for processors with fused multiply-adds, or `float`.

        Raises
        ------
        ValueError
            For another scalar, or a mechanism beyond the limits of exported C.
        """
        name, header, source = self._native.to_c(scalar)
        texts = {f"{name}.h": header, f"{name}.c": source}
        if folder is not None:
            from ._files import write_all

            write_all(folder, texts)
        return texts

    def page(self, positions: int = 361, *, dimensions: list[float] | None = None) -> str:
        """Returns a page with drawing, plots and tables of this many positions as HTML.

        Dimensions are nominal, or all of them in the order of `parameters`. The page computes in
        the browser: its sliders change the dimensions.

        Raises
        ------
        LinkageError
            If nothing moves, or the loops do not close.
        """
        if positions < 2:
            raise LinkageError(f"{positions} positions: a page has at least 2")
        if dimensions is None:
            dimensions = [one.nominal for one in self.parameters.values()]
        try:
            return self._native.page(list(dimensions), positions)
        except ValueError as error:
            raise LinkageError(str(error)) from None

    def _repr_html_(self) -> str:
        from ._html import frame

        return frame(self.page(121), self.name)

    def position(self, inputs: tuple, named: dict) -> list[float]:
        """Returns a number for each input: given in order or by name, else its reference."""
        given = self.input_arrays(inputs, named)
        for name, value in given.items():
            if value.ndim:
                raise ValueError(f"input `{name}` is one number here, not an array")
        return [float(value) for value in given.values()]

    def input_arrays(self, inputs: tuple, named: dict) -> dict[str, np.ndarray]:
        """Returns an array for each input: given in order or by name, else its reference."""
        names = list(self.inputs)
        if len(inputs) > len(names):
            raise TypeError(f"{self.name} has {len(names)} inputs: {len(inputs)} are too many")
        values = {name: one.reference for name, one in self.inputs.items()}
        values.update(zip(names, inputs))
        for name, value in named.items():
            if name not in values:
                raise _numbers.unknown("input", name, names, self.name)
            if name in names[: len(inputs)]:
                raise TypeError(f"input `{name}` is given twice")
            values[name] = value
        return {
            name: _numbers.array(name, self.inputs[name].unit, value)
            for name, value in values.items()
        }

    def __copy__(self) -> Mechanism:
        return self

    def __deepcopy__(self, _memo) -> Mechanism:
        return self

    def __reduce__(self):
        options = None
        if self._code is not None:
            options = {"compiler": self._code.compiler, "cache": self._code.cache}
        return _revived, (self._origin, self._tolerances, options)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mechanism):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple:
        return self._origin, self._tolerances, self.is_compiled

    def __repr__(self) -> str:
        inputs = ", ".join(self.inputs) or "no inputs"
        functions = ", ".join(self.functions) or "none"
        return (
            f"<Mechanism {self.name}: {len(self.parameters)} dimensions, inputs: {inputs}, "
            f"functions: {functions}>"
        )


def _revived(origin: Origin, tolerances: tuple | None, options: dict | None) -> Mechanism:
    """Compiles a copied mechanism again."""
    from ._text import revive

    mechanism = revive(origin)
    if tolerances is not None:
        mechanism = mechanism._with_tolerances(tolerances)
    return mechanism if options is None else mechanism.compile(**options)
