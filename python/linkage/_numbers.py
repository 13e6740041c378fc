"""Arguments and dimensions: checked numbers, broadcast to one shape."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

#: Kinds of NumPy's types that are numbers here: booleans, integers, floats.
REAL = "biuf"


def array(name: str, unit: str, value: Any) -> np.ndarray:
    """Returns a value as an array of doubles.

    Raises
    ------
    TypeError
        For anything that is no real number, such as a text with a unit.
    """
    import numpy as np

    try:
        found = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"`{name}`: {error}") from None
    if found.dtype.kind not in REAL:
        kind = type(value).__name__ if found.ndim == 0 else f"array of {found.dtype}"
        advice = f"write the number in {unit}" if unit else "write a number"
        raise TypeError(f"`{name}` takes real numbers, not `{kind}`\nhelp: {advice}")
    return np.asarray(found, dtype=np.float64)


def broadcast(values: dict[str, np.ndarray]) -> tuple[tuple[int, ...], list[np.ndarray]]:
    """Returns the shape of all arrays together, and each as a list of numbers.

    A list has a number for each position, or one for all of them.

    Raises
    ------
    ValueError
        If shapes do not fit together; the message has all of them.
    """
    import numpy as np

    try:
        shape = np.broadcast_shapes(*(one.shape for one in values.values()))
    except ValueError:
        shapes = ", ".join(f"`{name}` {one.shape}" for name, one in values.items() if one.ndim)
        raise ValueError(f"shapes do not fit together: {shapes}") from None
    flat = []
    for one in values.values():
        if one.size == 1:
            flat.append(one.reshape(1))
        else:
            flat.append(np.ascontiguousarray(np.broadcast_to(one, shape)).reshape(-1))
    return shape, flat


def size(shape: tuple[int, ...]) -> int:
    """Returns the number of positions of a shape."""
    count = 1
    for length in shape:
        count *= length
    return count


def unknown(kind: str, name: str, known: list[str], owner: str) -> TypeError:
    """Returns the exception of a name that nothing has, with the nearest known one."""
    from difflib import get_close_matches

    near = get_close_matches(name, known, 1)
    listed = ", ".join(f"`{one}`" for one in known) or "none"
    advice = f"\nhelp: `{near[0]}` is similar" if near else ""
    return TypeError(f"{owner} has no {kind} `{name}`; it has {listed}{advice}")
