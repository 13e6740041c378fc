"""Mechanisms of the plane and of space, compiled from their loop equations.

>>> import numpy as np, linkage
>>> bar = linkage.parse('''
...     pub struct FourBar {
...         unit mm;
...         param crank = 50mm +- 12um;
...         input phi = 30deg in 0deg..360deg;
...         unknown theta = 40deg;
...         unknown psi = 80deg;
...         loop polar(crank, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi);
...     }
...     impl FourBar { pub fn rocker(phi) -> Rocker { psi, v: velocity(psi), e: sensitivity(psi) } }
... ''')
>>> m = bar.assemble(crank=51.0)
>>> r = m.rocker(np.linspace(0, 2 * np.pi, 721))
>>> r.psi.shape, r.e["crank"].shape
((721,), (721,))

Lengths are in the unit of the mechanism, angles in radians.
"""

from ._assembly import Assembly, BoundFunction
from ._design import Design, Designs, Relation, Target, at_least, at_most, crank_turns, exactly
from ._errors import (
    AnalysisError,
    AssemblyError,
    CompileError,
    DesignError,
    LinkageError,
    Message,
)
from ._mechanism import Mechanism
from ._results import Entries, Result
from ._study import Study
from ._text import load, load_all, parse, parse_all
from ._threads import set_threads, threads

__version__ = "0.1.0"

__all__ = [
    "AnalysisError",
    "Assembly",
    "AssemblyError",
    "BoundFunction",
    "CompileError",
    "Design",
    "DesignError",
    "Designs",
    "Entries",
    "LinkageError",
    "Mechanism",
    "Message",
    "Relation",
    "Result",
    "Study",
    "Target",
    "at_least",
    "at_most",
    "crank_turns",
    "exactly",
    "load",
    "load_all",
    "parse",
    "parse_all",
    "set_threads",
    "threads",
]
