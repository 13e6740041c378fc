"""A mechanism in PyTorch: a function with its derivative rule.

`python with_torch.py` checks its gradients.
"""

from pathlib import Path

import linkage
import numpy as np
import torch

NAMES = ("crank", "coupler", "rocker")
M = linkage.load(Path(__file__).with_name("rocker.mech")).assemble()


class Rocker(torch.autograd.Function):
    """The angle of the rocker at inputs, for dimensions of shape (3,)."""

    @staticmethod
    def forward(context, phi, x):
        numbers = x.detach().numpy()
        r = M.motion(phi.detach().numpy(), **dict(zip(NAMES, numbers)))
        context.save_for_backward(torch.from_numpy(r.v), torch.from_numpy(np.asarray(r.e)))
        return torch.from_numpy(np.array(r.psi))

    @staticmethod
    def backward(context, gradient):
        v, e = context.saved_tensors
        return gradient * v, gradient @ e


def main():
    """Returns true if the gradients are those of differences."""
    phi = torch.linspace(0.1, 6.0, 12, dtype=torch.float64, requires_grad=True)
    x = torch.tensor([50.0, 120.0, 100.0], dtype=torch.float64, requires_grad=True)
    right = torch.autograd.gradcheck(Rocker.apply, (phi, x), eps=1e-5, atol=1e-7)
    print(f"gradients are right: {right}")
    return right


if __name__ == "__main__":
    main()
