"""The solver's times in three sizes, and their ratios to floors that are measured in the same run.

The limits are the promises of docs/benchmarks.md: best of five interleaved rounds, one BLAS thread (in a process of its
own with that setting), a pool of 200 different girders so that a memory of one girder does not help. A busy machine
breaks them, so they are held where scripts/bench times (--benchmark-enable) and skipped in any other run.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import benchmark_peers
import numpy as np
import pytest
from benchmark_table import LENGTH, SAW_TOOTH_ANSWERS, saw_tooth

from hullvib import FiniteElements, Girder, Ritz, StodolaRitz, solve

pytestmark = pytest.mark.benchmarks
SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "benchmark_table.py"


def hull(pieces: int) -> Girder:
    """A girder of linear pieces with smooth variation and a jump of mass at every tenth breakpoint."""
    x = np.linspace(0.0, 262.0, pieces + 1)
    jumps = np.arange(10, pieces, 10)
    x = np.insert(x, jumps, x[jumps])
    mass = 2e5 * (1.0 + 0.4 * np.cos(np.arange(len(x))))
    return Girder(x, mass, 5e13 * (0.1 + np.sin(np.pi * x / 262.0)))


@pytest.mark.parametrize("pieces", [20, 100, 400])
@pytest.mark.parametrize("method", [StodolaRitz(12), Ritz(12), FiniteElements(100)], ids=["stodola", "ritz", "fem"])
def test_solution(benchmark, method, pieces):
    girder = hull(pieces)
    modes = benchmark(solve, girder, method, 5)
    assert modes.node_counts.tolist() == [2, 3, 4, 5, 6]


@pytest.mark.parametrize("peer", benchmark_peers.PEERS)
def test_another_package_is_given_the_same_beam(peer):
    try:
        _, run = peer()
    except ImportError as error:
        pytest.skip(f"a package of the bench extra is not at hand: {error}")
    found = run(saw_tooth(), np.linspace(0.0, LENGTH, 101))
    # 20 prismatic elements err by up to 2e-3, as h^2, hence 100 by a 25th of it; a wrong girder errs by 1e-2 and more
    assert found == pytest.approx(SAW_TOOTH_ANSWERS, rel=2e-4)


@pytest.fixture(scope="module")
def timed(pytestconfig):
    if not pytestconfig.getoption("benchmark_enable"):
        pytest.skip("times are held against limits by scripts/bench alone")


@pytest.fixture(scope="module")
def ratios(timed):
    threads = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    run = subprocess.run(
        [sys.executable, str(SCRIPT), "--ratios"], capture_output=True, text=True, check=True, env=os.environ | threads
    )
    return json.loads(run.stdout)


def test_one_solution(ratios):
    assert ratios["solve"] <= 30


def test_a_bracket_on_top_of_a_solution(ratios):
    assert ratios["bracket"] <= 400


def test_ten_thousand_stacked_girders(ratios):
    assert ratios["many_ritz"] <= 3
    assert ratios["many_stodola"] <= 12


def test_ten_thousand_breakpoints(ratios):
    assert ratios["breakpoints"] <= 6


def test_scikit_fem(ratios):
    if "scikit_fem_time" not in ratios:
        pytest.skip("scikit-fem, of the bench extra, is not installed")
    assert ratios["scikit_fem_time"] >= 10
    assert ratios["scikit_fem_error"] >= 100


@pytest.fixture(scope="module")
def imports(tmp_path_factory):
    """Five times: seconds of `import hullvib` after numpy and scipy.linalg, packages loaded, parts of scipy.sparse."""
    code = (
        "import json, sys, numpy, scipy.linalg, numpy.polynomial.legendre, time;"
        "before = set(sys.modules); start = time.perf_counter(); import hullvib; took = time.perf_counter() - start;"
        "packages = sorted({name.partition('.')[0] for name in set(sys.modules) - before});"
        "print(json.dumps([took, packages, sorted(m for m in sys.modules if m.startswith('scipy.sparse'))]))"
    )
    # compiled once, as after any installation
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(tmp_path_factory.mktemp("compiled"))
    command = [sys.executable, "-c", code]
    return [
        json.loads(subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout)
        for _ in range(5)
    ]


def test_import_loads_numpy_and_scipy_linalg_alone(imports):
    for _, packages, sparse in imports:
        assert set(packages) - sys.stdlib_module_names == {"hullvib"}
        assert not sparse


def test_import_is_quick(timed, imports):
    # standard-library modules that only hullvib needs count as its own
    assert min(seconds for seconds, _, _ in imports) <= 0.05
