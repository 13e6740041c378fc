"""A mechanism in JAX: a function with its derivative rule, for `jit`, `vmap` and `grad`.

`python with_jax.py` compares its gradients with differences.
"""

from pathlib import Path

import jax
import jax.numpy as jnp
import linkage
import numpy as np

jax.config.update("jax_enable_x64", True)

NAMES = ("crank", "coupler", "rocker")
M = linkage.load(Path(__file__).with_name("rocker.mech")).assemble()


def _on_host(phi, x):
    """Value, derivative by the input and by the dimensions, of arrays of any leading axes."""
    phi, x = np.asarray(phi), np.asarray(x)
    r = M.motion(phi, **{name: x[..., k] for k, name in enumerate(NAMES)})
    shape = np.broadcast_shapes(phi.shape, x.shape[:-1])
    e = np.broadcast_to(np.asarray(r.e), (*shape, len(NAMES)))
    return r.psi.reshape(shape), r.v.reshape(shape), e


def _call(phi, x):
    phi, x = jnp.asarray(phi, jnp.float64), jnp.asarray(x, jnp.float64)
    number = jax.ShapeDtypeStruct(phi.shape, jnp.float64)
    row = jax.ShapeDtypeStruct((*phi.shape, len(NAMES)), jnp.float64)
    return jax.pure_callback(_on_host, (number, number, row), phi, x, vmap_method="broadcast_all")


@jax.custom_jvp
def rocker(phi, x):
    """The angle of the rocker at an input, for the dimensions `x` of shape phi.shape + (3,)."""
    return _call(phi, x)[0]


@rocker.defjvp
def _rocker_jvp(primals, tangents):
    psi, v, e = _call(*primals)
    phi_step, x_step = tangents
    return psi, v * phi_step + jnp.sum(e * x_step, axis=-1)


def main():
    """Returns the largest difference between the rule and central differences."""
    x = jnp.array([50.0, 120.0, 100.0])
    phi = jnp.linspace(0.1, 6.0, 40)

    def cost(x):
        return jnp.sum(jax.vmap(lambda one: rocker(one, x))(phi) ** 2)

    gradient = jax.jit(jax.grad(cost))(x)
    step = 1e-5
    differences = jnp.array(
        [(cost(x.at[k].add(step)) - cost(x.at[k].add(-step))) / (2 * step) for k in range(3)]
    )
    off = float(jnp.max(jnp.abs(gradient - differences)))
    print(f"gradient {gradient}, off by {off:.1e} from differences")
    return off


if __name__ == "__main__":
    main()
