"""Results as data sets of xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._results import Result


def dataset(result: Result):
    """Returns a data set with a variable for each field."""
    import numpy as np
    import xarray

    names = [f"dim_{k}" for k in range(len(result.shape))]
    coordinates = {}
    for argument, value in result.arguments.items():
        axes = [k for k, length in enumerate(value.shape) if length > 1]
        if len(axes) == 1:
            # The last axes of an argument are the last ones of the shape.
            axis = axes[0] + len(result.shape) - value.ndim
            if names[axis] == f"dim_{axis}":
                names[axis] = argument
                coordinates[argument] = value.reshape(-1)
    variables = {}
    for name, field in result.function.fields.items():
        dimensions, value = list(names), np.asarray(result[name])
        if field.kind in ("vector2", "vector3"):
            dimensions.append("component" if field.kind == "vector3" else "component2")
            coordinates[dimensions[-1]] = list("xyz" if field.kind == "vector3" else "xy")
        elif field.kind != "scalar":
            dimensions += [f"{field.kind}_row", f"{field.kind}_column"]
        # Jacobians: entries of the innermost array are the last axis but for the outer ones.
        for level, labels in reversed(list(enumerate(field.labels))):
            dimensions.append(f"{name}_{level}" if len(field.labels) > 1 else f"{name}_entry")
            coordinates[dimensions[-1]] = list(labels)
        variables[name] = (dimensions, value, {"units": field.unit})
    return xarray.Dataset(variables, coordinates)
