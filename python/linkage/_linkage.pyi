"""The native part of the package: checked arguments only, without names and defaults."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

_Located = tuple[str, bool, tuple[int, int, int, int]]
_Branch = tuple[
    int,
    list[tuple[str, float]],
    bool,
    tuple[float, float],
    float,
    list[tuple[str, list[float]]],
]
_Extreme = tuple[float, float, str, bool]

_Estimate = tuple[float, float, float]
_Function = tuple[int, list[float], list[int]]
_Draw = tuple[int, int, str, list[tuple[int, str]], int, int]
_DesignOf = tuple[
    list[float],
    float,
    list[list[float]],
    list[list[float]],
    tuple[float, float],
    list[tuple[str, float, float]],
    bool,
    int,
    int,
    list[str],
    str,
]

def compile(name: str, text: str, any_range: bool, fused: bool | None) -> list[Mechanism]: ...

def design(
    mechanism: Mechanism,
    dimensions: list[float],
    variables: list[tuple[str, str, list[float]]],
    relations: list[tuple[list[tuple[str, float]], float, bool]],
    targets: list[
        tuple[int, list[str], list[list[float]], list[float] | None, str, list[float]]
    ],
    settings: tuple[int | None, int | None, int, int | None, float | None],
    threads: int,
    shown: Callable[[int, int, float], object] | None,
) -> tuple[str, tuple[list[int], bool], list[_DesignOf], list[Assembly]]: ...
def random_study(
    assembly: Assembly,
    function: _Function,
    draw: _Draw,
    threads: int,
    shown: Callable[[int, int, float], object] | None,
) -> Study: ...
def read_study(assembly: Assembly, function: _Function, draw: _Draw, bytes: bytes) -> Study: ...

class Study:
    done: int
    missing: int

    def to_bytes(self) -> bytes: ...
    def merged(self, others: list[bytes]) -> Study: ...
    def statistics(
        self, number: int
    ) -> tuple[int, _Estimate, _Estimate, float, float, float]: ...
    def percentile(self, number: int, part: float, confidence: float) -> _Estimate: ...
    def part_within(
        self, number: int, low: float, high: float, confidence: float
    ) -> _Estimate: ...
    def histogram(self, number: int, low: float, high: float, bins: int) -> list[float]: ...
    def extremes(self, number: int) -> list[tuple[float, int, list[float]]] | None: ...

class Mechanism:
    name: str
    documentation: str
    messages: list[_Located]
    warnings: str
    structure: str
    mobility: int
    groups: list[tuple[list[str], str, str]]
    parameters: list[tuple[str, str, float, float]]
    inputs: list[tuple[str, str, float, tuple[float, float] | None, tuple[float, float]]]
    arguments: list[tuple[str, str, float | None]]
    functions: list[
        tuple[
            str,
            str,
            list[int],
            list[tuple[str, str, str, str, list[int], str]],
            list[tuple[str, str, str, int, int | None]],
        ]
    ]

    def assemble(self, dimensions: list[float]) -> Assembly: ...
    def assemblies(self, dimensions: list[float], at: list[float]) -> list[Assembly]: ...
    def assemble_from(self, dimensions: list[float], from_: Assembly) -> Assembly: ...
    def circuits(
        self, dimensions: list[float]
    ) -> tuple[str, list[_Branch], list[Assembly]] | None: ...
    def with_tolerances(self, tolerances: list[float]) -> Mechanism: ...
    def with_derivatives(
        self, function: str, fields: list[str], variables: list[str]
    ) -> Mechanism | None: ...
    def to_c(self, scalar: str) -> tuple[str, str, str]: ...
    def column_sweeps(
        self,
    ) -> tuple[
        list[tuple[str, str]], str, tuple[str, str, str], list[str | None], list[str | None]
    ]: ...
    def page(self, dimensions: list[float], positions: int) -> str: ...

class Assembly:
    dimensions: list[float]
    modes: list[int]
    turns: list[float]
    served: float

    def follower(self, inputs: list[float]) -> Follower: ...
    def unknowns(self, inputs: list[float]) -> list[tuple[str, list[float]]]: ...
    def check_range(self) -> tuple[bool, str]: ...
    def call(self, function: int, arguments: list[float]) -> list[float]: ...
    def sweep(
        self,
        function: int,
        dimensions: list[NDArray[np.float64]] | None,
        arguments: list[NDArray[np.float64]],
        out: NDArray[np.float64],
        threads: int,
    ) -> None: ...
    def gaps(self, inputs: list[NDArray[np.float64]], out: NDArray[np.float64]) -> None: ...
    def effects(
        self, function: int, columns: NDArray[np.float64]
    ) -> list[tuple[str, list[int], list[float], list[float], list[list[float]], str]]: ...
    def curve(
        self,
        function: int,
        arguments: list[float],
        running: int,
        columns: list[int],
        range: tuple[float, float],
        positions: int,
        band: float | None,
        units: tuple[str, str],
    ) -> tuple[
        list[list[_Extreme]],
        list[tuple[float, float, float, float, float]],
        tuple[float, float] | None,
        list[tuple[float, float]],
        list[tuple[float, float]],
        str,
    ]: ...

class Follower:
    inputs: list[float]

    def follow(self, inputs: list[float]) -> None: ...
    def call(self, function: int, arguments: list[float]) -> list[float]: ...
