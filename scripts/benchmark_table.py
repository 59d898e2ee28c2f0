"""Measures the solver's accuracy against time, beside other packages, and writes docs/benchmarks.md.

usage: python scripts/benchmark_table.py            write docs/benchmarks.md
       python scripts/benchmark_table.py --ratios   print the ratios as JSON, for tests/benchmarks
Set OPENBLAS_NUM_THREADS=1 first. Packages of the `bench` extra that are missing are left out of the table.
"""

from __future__ import annotations

import json
import os
import platform
import sys
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path
from time import perf_counter

import numpy as np
import scipy
from numpy.typing import NDArray
from scipy.linalg import lapack

from hullvib import FiniteElements, Girder, GirderStack, Modes, Ritz, StodolaRitz, bracket, solve, solve_many

Array = NDArray[np.float64]
Call = Callable[[], object]

LENGTH, RIGIDITY, MEAN_MASS = 262.0, 52.118e12, 284962.0
# the saw-tooth hull, 20-digit answers of modes 1 to 6 in rad/s from another computation, rounded to doubles
ANSWERS = np.array(
    [4.9991976900179876, 11.993742931176827, 21.490464361706317, 34.180751878304377, 50.339321490990351,
     70.079276652104245]
)  # fmt: skip
ROUNDS = 5


def saw_tooth() -> Girder:
    """Case C: 20 segments, mass jumping up to threefold, EI of lines with two jumps."""
    weights = np.array([3, 6, 4, 12, 5, 13, 6, 15, 5, 14, 7, 16, 6, 15, 5, 12, 4, 9, 3, 5])
    edges = np.arange(21) * (LENGTH / 20)
    return Girder.from_tables(
        mass=(np.repeat(edges, 2)[1:-1], np.repeat(weights / weights.mean() * MEAN_MASS, 2)),
        rigidity=(
            LENGTH * np.array([0, 0.2, 0.2, 0.5, 0.75, 0.75, 1]),
            RIGIDITY * np.array([0.25, 0.65, 0.95, 1.1, 1.0, 0.6, 0.15]),
        ),
    )


def pool(count: int, pieces: int = 20) -> list[Girder]:
    """Different girders, each with breakpoints of its own."""
    rng = np.random.default_rng(2)
    girders = []
    for _ in range(count):
        edges = np.concatenate([[0.0], np.cumsum(1.0 + 0.3 * rng.random(pieces))])
        x = np.repeat(edges * (LENGTH / edges[-1]), 2)[1:-1]
        mass, rigidity = 1e5 * (1 + 2 * rng.random(2 * pieces)), 3e13 * (1 + rng.random(2 * pieces))
        girders.append(Girder(x, mass, rigidity))
    return girders


def best_times(calls: dict[str, Call], repeats: dict[str, int]) -> dict[str, float]:
    """Seconds of one call: the best of five rounds, in which the calls take turns."""
    best = dict.fromkeys(calls, np.inf)
    for call in calls.values():
        call()
    for _ in range(ROUNDS):
        for name, call in calls.items():
            count = repeats.get(name, 1)
            start = perf_counter()
            for _ in range(count):
                call()
            best[name] = min(best[name], (perf_counter() - start) / count)
    return best


def floor_call() -> Call:
    rng = np.random.default_rng(0)
    a = rng.standard_normal((12, 12))
    stiffness, mass = a + a.T, a @ a.T + np.eye(12)
    return lambda: lapack.dsygv(stiffness, mass)


def turns(items: list[Girder] | list[Modes], call: Callable[[object], object]) -> Call:
    def cycle() -> Iterator[object]:
        while True:
            yield from items

    source = cycle()
    return lambda: call(next(source))


def ratios() -> dict[str, float]:
    """The figures that tests/benchmarks hold against their limits."""
    girders = pool(200)
    solved = [solve(girder, StodolaRitz(12, 2), modes=6) for girder in girders]
    calls: dict[str, Call] = {
        "floor": floor_call(),
        "solve": turns(girders, lambda girder: solve(girder, StodolaRitz(12, 2), modes=6)),
        "bracket": turns(solved, lambda modes: bracket(modes, modes=5)),
    }
    repeats = {"floor": 2000, "solve": 200, "bracket": 100}
    peers = {name: call for name, call in peer_calls(saw_tooth()).items() if name.startswith("scikit-fem")}
    calls |= peers
    repeats |= dict.fromkeys(peers, 5)
    times = best_times(calls, repeats)
    found = {"solve": times["solve"] / times["floor"], "bracket": times["bracket"] / times["floor"]}
    for name, call in peers.items():
        found["scikit_fem_time"] = times[name] / times["solve"]
        ours = np.abs(solve(saw_tooth(), modes=6).angular_frequencies / ANSWERS - 1.0)
        theirs = np.abs(np.asarray(call()) / ANSWERS - 1.0)
        # ours is round-off in mode 1
        found["scikit_fem_error"] = float((theirs / np.maximum(ours, 1e-15)).min())
    return found | breakpoint_ratio() | stacked_ratios()


def stacked_ratios(count: int = 10_000) -> dict[str, float]:
    rng = np.random.default_rng(3)
    shape = (count, 20, 2)
    stack = GirderStack(np.linspace(0, LENGTH, 21), 2e5 * (1 + rng.random(shape)), 3e13 * (1 + rng.random(shape)))
    matrices = rng.standard_normal((count, 12, 12))
    matrices = matrices + matrices.transpose(0, 2, 1)
    times = best_times(
        {
            "floor": lambda: np.linalg.eigh(matrices),
            "many_ritz": lambda: solve_many(stack, Ritz(12), modes=5),
            "many_stodola": lambda: solve_many(stack, StodolaRitz(12, 1), modes=5),
        },
        {},
    )
    return {name: times[name] / times["floor"] for name in ("many_ritz", "many_stodola")}


def breakpoint_ratio() -> dict[str, float]:
    x = np.linspace(0, LENGTH, 10_000)
    girder = Girder(x, 2e5 * (1.5 + np.sin(x / 7)), 3e13 * (1.2 + np.sin(x / 40)))
    angles = np.random.default_rng(4).random((12, 20_000))
    times = best_times(
        {
            "floor": lambda: (np.sin(angles), np.cos(angles), np.exp(angles), np.exp(angles)),
            "solve": lambda: solve(girder, StodolaRitz(12, 2), modes=6),
        },
        {"floor": 5, "solve": 3},
    )
    return {"breakpoints": times["solve"] / times["floor"]}


def peer_calls(girder: Girder) -> dict[str, Call]:
    """Frequencies by other packages, (6,) rad/s; assembly is part of the call."""
    calls: dict[str, Call] = {}
    for build in (scikit_fem, pycba):
        try:
            calls |= build(girder)
        except ImportError:
            print(f"{build.__name__} is not installed; left out", file=sys.stderr)
    return calls


def scikit_fem(girder: Girder) -> dict[str, Call]:
    import skfem
    from scipy.sparse.linalg import eigsh
    from skfem.helpers import dd

    @skfem.BilinearForm
    def bending(u, v, w):  # type: ignore[no-untyped-def]
        return w.rigidity * dd(u)[0, 0] * dd(v)[0, 0]

    @skfem.BilinearForm
    def inertia(u, v, w):  # type: ignore[no-untyped-def]
        return w.mass * u * v

    def run(elements: int) -> Array:
        mesh = skfem.MeshLine(np.linspace(0, LENGTH, elements + 1))
        basis = skfem.Basis(mesh, skfem.ElementLineHermite(), intorder=8)
        x = np.asarray(basis.global_coordinates())[0]
        flat = x.reshape(-1)
        rigidity, mass = girder.flexural_rigidity(flat).reshape(x.shape), girder.mass_per_length(flat).reshape(x.shape)
        stiffness, mass_matrix = skfem.asm(bending, basis, rigidity=rigidity), skfem.asm(inertia, basis, mass=mass)
        values = eigsh(stiffness, k=8, M=mass_matrix, sigma=-1.0, return_eigenvectors=False)
        return np.sqrt(np.sort(values)[2:])

    label = f"scikit-fem {version('scikit-fem')}"
    return {f"{label}, {n} elements": (lambda n=n: run(n)) for n in (100,)}


def pycba(girder: Girder) -> dict[str, Call]:
    from pycba import BeamAnalysis

    def run(elements: int) -> Array:
        width = LENGTH / elements
        middle = (np.arange(elements) + 0.5) * width
        supports = np.zeros(2 * elements + 2)
        beam = BeamAnalysis(np.full(elements, width), girder.flexural_rigidity(middle), supports)
        result = beam.modal(girder.mass_per_length(middle), n_modes=8, nseg=1)
        return np.asarray(result.omega)[2:8]

    label = f"PyCBA {version('pycba')}"
    return {f"{label}, {n} elements": (lambda n=n: run(n)) for n in (100,)}


def table() -> str:
    girder = saw_tooth()
    calls: dict[str, Call] = {
        "one 12 x 12 LAPACK dsygv, the floor": floor_call(),
        "hullvib Ritz(12)": lambda: solve(girder, Ritz(12), modes=6).angular_frequencies,
        "hullvib StodolaRitz(12, steps=1)": lambda: solve(girder, StodolaRitz(12, 1), modes=6).angular_frequencies,
        "hullvib StodolaRitz(12, steps=2)": lambda: solve(girder, StodolaRitz(12, 2), modes=6).angular_frequencies,
        "hullvib FiniteElements(100)": lambda: solve(girder, FiniteElements(100), modes=6).angular_frequencies,
        **peer_calls(girder),
    }
    usable: dict[str, Call] = {}
    for name, call in calls.items():
        try:
            call()
        except Exception as error:  # another package's failure is a row of the table
            print(f"{name}: {type(error).__name__}: {error}", file=sys.stderr)
        else:
            usable[name] = call
    times = best_times(usable, dict.fromkeys(usable, 5) | {next(iter(usable)): 500})
    floor = times[next(iter(usable))]
    rows = ["| method | error of mode 1 | mode 3 | mode 6 | time, ms | floors |", "|---|---|---|---|---|---|"]
    for name, call in usable.items():
        answer = call()
        errors = ["-"] * 3
        if isinstance(answer, np.ndarray):
            relative = np.abs(answer / ANSWERS - 1.0)
            errors = [f"{relative[mode]:.0e}" for mode in (0, 2, 5)]
        milliseconds = 1e3 * times[name]
        rows.append(f"| {name} | {' | '.join(errors)} | {milliseconds:.3g} | {times[name] / floor:.3g} |")
    return "\n".join(rows)


def page() -> str:
    found = ratios()
    processor = platform.processor() or platform.machine()
    limits = {
        "solve": ("one `solve`, N = 12, two steps, 20 pieces, 6 modes, in LAPACK calls", "at most 30"),
        "bracket": ("`bracket` of 5 modes on top of it, in LAPACK calls", "at most 400"),
        "many_ritz": ("10,000 stacked girders, `Ritz(12)`, in stacked `eigh` of 10,000 12 x 12", "at most 3"),
        "many_stodola": ("the same, `StodolaRitz(12, steps=1)`", "at most 12"),
        "breakpoints": ("10,000 breakpoints, in sin, cos and two exp of 12 x 20,000", "at most 6"),
        "scikit_fem_time": ("time of scikit-fem, 100 elements, in `solve`s", "at least 10"),
        "scikit_fem_error": ("its error in ours, the least of modes 1 to 6", "at least 100"),
    }
    rows = [f"| {text} | {found[key]:.3g} | {goal} |" for key, (text, goal) in limits.items() if key in found]
    return "\n".join(
        [
            "# Benchmarks",
            "",
            "Written by `scripts/benchmark_table.py`; run it again on your machine, and compare ratios, not times.",
            f"Python {platform.python_version()}, numpy {np.__version__}, scipy {scipy.__version__}, {processor}, "
            f"{os.environ.get('OPENBLAS_NUM_THREADS', 'default')} BLAS thread(s), one process, best of {ROUNDS} "
            "interleaved rounds.",
            "",
            "## The saw-tooth hull",
            "",
            "262 m, 20 segments, mass jumping up to threefold between neighbours, EI of lines with two jumps. Errors "
            "are relative, against 20-digit answers; six modes; assembly is part of every time.",
            "",
            table(),
            "",
            "Packages with prismatic elements average EI and m over each element, which limits them to h^2.",
            "",
            "## Ratios",
            "",
            "| what | measured | promised |",
            "|---|---|---|",
            *rows,
            "",
        ]
    )


def main() -> None:
    if "--ratios" in sys.argv[1:]:
        print(json.dumps(ratios()))
        return
    target = Path(__file__).resolve().parents[1] / "docs" / "benchmarks.md"
    target.write_text(page(), encoding="utf-8")
    print(f"wrote {target}", file=sys.stderr)


if __name__ == "__main__":
    main()
