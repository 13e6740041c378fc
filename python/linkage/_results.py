"""Results of functions: named arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ._describe import KINDS, Field, Function
from ._numbers import size, unknown

if TYPE_CHECKING:
    import numpy as np


class Entries(Mapping):
    """Derivatives with respect to several dimensions or inputs: `e["crank"]`.

    Entries are arrays with the shape of the quantity. As an array, `numpy.asarray(e)`, they are a
    Jacobian: the last axis counts the entries.
    """

    __slots__ = ("names", "_entries")

    def __init__(self, names: tuple[str, ...], entries: list):
        self.names = names
        self._entries = entries

    def __getitem__(self, name: str | int) -> Any:
        if isinstance(name, str):
            if name not in self.names:
                raise KeyError(f"no entry `{name}`; there are {', '.join(self.names)}")
            return self._entries[self.names.index(name)]
        return self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        import numpy as np

        if copy is False:
            raise ValueError("entries are separate arrays: an array of all of them is a copy")
        return np.stack([np.asarray(entry, dtype=dtype) for entry in self._entries], axis=-1)

    def __repr__(self) -> str:
        return f"Entries({', '.join(self.names)})"


class Result(Mapping):
    """The results of a function: one array for each field, by name or as an attribute.

    With the shape `S` of the arguments, a number has the shape `S`, a point `S + (2,)` or
    `S + (3,)`, and a frame is a homogeneous matrix, `S + (3, 3)` in the plane or `S + (4, 4)`.
    Derivatives with respect to dimensions are `Entries`. NaN stands where the mechanism cannot be
    assembled.

    Attributes
    ----------
    function : Function
        Names, units and meanings.
    shape : tuple of int
        The shape `S`.
    arguments : dict of str to array
        The arguments and dimensions that were given.
    """

    __slots__ = ("function", "shape", "arguments", "_numbers", "_fields")

    def __init__(self, function: Function, shape: tuple, arguments: dict, numbers: np.ndarray):
        self.function = function
        self.shape = shape
        self.arguments = arguments
        self._numbers = numbers
        self._fields: dict[str, Any] = {}

    def _refilled(self, shape: tuple, arguments: dict) -> Result:
        """Returns this result for other arguments, whose numbers are written next."""
        self.shape = shape
        self.arguments = arguments
        self._fields.clear()
        return self

    def __getitem__(self, name: str) -> Any:
        if name not in self._fields:
            field = self.function.fields.get(name)
            if field is None:
                known = ", ".join(f"`{one}`" for one in self.function.fields)
                raise KeyError(f"`{self.function.name}` has no field `{name}`; it has {known}")
            columns = self._numbers[field.first : field.first + field.width]
            self._fields[name] = _shaped(columns, field, 0, self.shape)
        return self._fields[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name not in self.function.fields:
            owner = f"the result of `{self.function.name}`"
            error = unknown("field", name, list(self.function.fields), owner)
            raise AttributeError(str(error))
        return self[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.function.fields)

    def __len__(self) -> int:
        return len(self.function.fields)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.function.fields]

    def __reduce__(self):
        return Result, (self.function, self.shape, self.arguments, self._numbers)

    @property
    def units(self) -> dict[str, str]:
        """The unit of each field; empty for a number."""
        return {name: field.unit for name, field in self.function.fields.items()}

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """Each number of the result by its name, such as `tracer.x`: arrays of the shape `S`."""
        shaped = self._numbers.reshape(len(self.function.columns), *self.shape)
        return {column.name: shaped[k] for k, column in enumerate(self.function.columns)}

    def to_pandas(self):
        """Returns a `pandas.DataFrame`: arguments, then columns; a row for each position."""
        import pandas

        return pandas.DataFrame(self._table())

    def to_polars(self):
        """Returns a `polars.DataFrame`: arguments, then columns; a row for each position."""
        import polars

        return polars.DataFrame(self._table())

    def to_xarray(self):
        """Returns an `xarray.Dataset`: a variable for each field, with its unit.

        Dimensions of positions have the name of the argument that runs along them, else `dim_0`
        and so on. Components have the dimension `component`, entries that of the field's name.
        """
        from ._xarray import dataset

        return dataset(self)

    def _table(self) -> dict[str, np.ndarray]:
        import numpy as np

        count = size(self.shape)
        table = {
            name: np.broadcast_to(value, self.shape).reshape(count)
            for name, value in self.arguments.items()
        }
        for name, column in self.columns.items():
            table[name] = column.reshape(count)
        return table

    def __repr__(self) -> str:
        lines = [f"Result of `{self.function.name}`, shape {self.shape}"]
        for name, field in self.function.fields.items():
            unit = f" {field.unit}" if field.unit else ""
            if self.shape == () and not field.labels:
                lines.append(f"  {name} = {self[name]}{unit}")
            else:
                inner = "".join(f"[{', '.join(labels)}]" for labels in field.labels)
                lines.append(f"  {name}{inner}{unit}")
        return "\n".join(lines)


def _shaped(columns: np.ndarray, field: Field, level: int, shape: tuple) -> Any:
    """Columns of a field, or of an entry in some of its arrays, as it is in results."""
    if level == len(field.labels):
        return _entry(columns, field.kind, shape)
    names = field.labels[level]
    width = len(columns) // len(names)
    parts = (columns[k * width : (k + 1) * width] for k in range(len(names)))
    return Entries(names, [_shaped(part, field, level + 1, shape) for part in parts])


def _entry(columns: np.ndarray, kind: str, shape: tuple) -> np.ndarray:
    import numpy as np

    if kind == "scalar":
        return columns[0].reshape(shape)[()]
    if kind in ("vector2", "vector3"):
        return np.moveaxis(columns.reshape(len(columns), *shape), 0, -1)
    rows, _ = KINDS[kind][1]
    components = rows - 1
    # Origin first, then the directions: columns of the matrix, the origin last.
    vectors = columns.reshape(rows, components, *shape)
    matrix = np.zeros((*shape, rows, rows))
    for k in range(rows):
        matrix[..., :components, (k - 1) % rows] = np.moveaxis(vectors[k], 0, -1)
    matrix[..., components, components] = 1.0
    return matrix
