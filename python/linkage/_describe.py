"""Names, units and shapes of a mechanism."""

from __future__ import annotations

from typing import NamedTuple

#: Components of an entry, and its shape in results.
KINDS = {
    "scalar": (1, ()),
    "vector2": (2, (2,)),
    "vector3": (3, (3,)),
    "plane_frame": (6, (3, 3)),
    "frame": (12, (4, 4)),
}


class Parameter(NamedTuple):
    """A scalar dimension: a component of a vector has `.x`, `.y` or `.z` after its name."""

    name: str
    unit: str
    nominal: float
    tolerance: float


class Input(NamedTuple):
    """A driving coordinate.

    `range` is the declared one, or `None`. `low` and `high` are its ends; without a declared range
    they are a turn from the reference on, or the reference itself.
    """

    name: str
    unit: str
    reference: float
    range: tuple[float, float] | None
    low: float
    high: float

    def linspace(self, count: int):
        """Returns `count` evenly spaced values from `low` to `high`, an array of shape (count,)."""
        import numpy as np

        return np.linspace(self.low, self.high, count)


class Argument(NamedTuple):
    """An argument of functions: an input, a speed, an acceleration or a load.

    Loads have the declared value as default; other arguments have none.
    """

    name: str
    unit: str
    default: float | None


class Column(NamedTuple):
    """A number of a result, such as `tracer.x`.

    `kind` is `value`, `rate`, `sensitivity`, `margin` or `picture`. `order` is that of a rate, and
    `parameter` the dimension of a sensitivity. `of` is the index of the column that is
    differentiated, if the function has it.
    """

    name: str
    unit: str
    kind: str
    order: int | None
    parameter: str | None
    of: int | None


class Field(NamedTuple):
    """A field of a result.

    `labels` has the names along each array around the entries: those of dimensions for
    `sensitivity`. `kind` is that of an entry. `first` is its first column.
    """

    name: str
    unit: str
    about: str
    documentation: str
    labels: tuple[tuple[str, ...], ...]
    kind: str
    first: int

    @property
    def width(self) -> int:
        """The number of its columns."""
        width = KINDS[self.kind][0]
        for labels in self.labels:
            width *= len(labels)
        return width


class Function(NamedTuple):
    """A function of a mechanism: its arguments in order, and the fields of its results."""

    name: str
    documentation: str
    arguments: tuple[Argument, ...]
    fields: dict[str, Field]
    columns: tuple[Column, ...]
    index: int

    def __str__(self) -> str:
        arguments = ", ".join(f"{one.name} [{one.unit or '1'}]" for one in self.arguments)
        lines = [f"{self.name}({arguments})"]
        lines += [f"  {field.name} [{field.unit or '1'}] {field.about}" for field in self.fields.values()]
        return "\n".join(line.rstrip() for line in lines)


def functions(native, inputs: int) -> dict[str, Function]:
    """Returns all functions of a native mechanism with this number of inputs."""
    arguments = [Argument(*argument) for argument in native.arguments]
    # An input has a reference, which is no default.
    arguments[:inputs] = [one._replace(default=None) for one in arguments[:inputs]]
    parameters = [parameter[0] for parameter in native.parameters]
    found = {}
    for index, (name, documentation, taken, fields, columns) in enumerate(native.functions):
        columns = tuple(_column(column, parameters) for column in columns)
        found[name] = Function(
            name=name,
            documentation=documentation,
            arguments=tuple(arguments[argument] for argument in taken),
            fields=_fields(fields, columns),
            columns=columns,
            index=index,
        )
    return found


def _column(column: tuple, parameters: list[str]) -> Column:
    name, unit, kind, number, of = column
    order = number if kind == "rate" else None
    parameter = parameters[number] if kind == "sensitivity" else None
    return Column(name, unit, kind, order, parameter, of)


def _fields(fields: list, columns: tuple[Column, ...]) -> dict[str, Field]:
    found = {}
    first = 0
    for name, documentation, unit, about, lengths, kind in fields:
        labels = _labels(lengths, KINDS[kind][0], columns[first:])
        field = Field(name, unit, about, documentation, labels, kind, first)
        found[name] = field
        first += field.width
    return found


def _labels(lengths: list[int], inner: int, columns: tuple[Column, ...]) -> tuple:
    """The names along each array: those between brackets in the names of columns."""
    labels = []
    stride = inner
    for length in lengths:
        stride *= length
    for level, length in enumerate(lengths):
        stride //= length
        heads = (columns[k * stride] for k in range(length))
        labels.append(tuple(_label(head, level, k) for k, head in enumerate(heads)))
    return tuple(labels)


def _label(column: Column, level: int, index: int) -> str:
    parts = column.name.split("[")[1:]
    if level < len(parts):
        return parts[level].split("]")[0]
    return column.parameter or str(index)
