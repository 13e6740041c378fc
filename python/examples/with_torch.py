"""A mechanism in PyTorch: a function with its derivative rule.

`python with_torch.py` checks its gradients.
"""

import linkage
import numpy as np
import torch

TEXT = """
pub struct FourBar {
    unit mm;
    param crank = 50mm;
    param coupler = 120mm;
    param rocker = 100mm;
    input phi = 30deg in 0deg..360deg;
    unknown theta = 40deg;
    unknown psi = 80deg;
    loop polar(crank, phi) + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
}
impl FourBar { pub fn motion(phi) -> Motion { psi, v: velocity(psi), e: sensitivity(psi) } }
"""

NAMES = ("crank", "coupler", "rocker")
M = linkage.parse(TEXT).assemble()


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
