"""Ratios of the solver's times, each against a floor that is measured in the same run, best of five interleaved rounds.

The limits are the promises of docs/benchmarks.md. A pool of 200 different girders keeps a memory of one girder from
helping. They hold for one BLAS thread, so the measuring runs in a process of its own with that setting.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.benchmarks
SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "benchmark_table.py"


@pytest.fixture(scope="module")
def ratios():
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
        pytest.skip("scikit-fem is not installed: pip install the bench extra")
    assert ratios["scikit_fem_time"] >= 10
    assert ratios["scikit_fem_error"] >= 100


def test_import_loads_numpy_and_scipy_linalg_alone_and_is_quick(tmp_path):
    code = (
        "import sys, numpy, scipy.linalg, numpy.polynomial.legendre, time;"
        "before = set(sys.modules); start = time.perf_counter(); import hullvib;"
        "print(time.perf_counter() - start, *sorted({m.partition('.')[0] for m in set(sys.modules) - before}));"
        "print(*sorted(m for m in sys.modules if m.startswith('scipy.sparse')))"
    )
    # compiled once, as after any installation
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(tmp_path)
    seconds = []
    for _ in range(5):
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment)
        first, sparse = run.stdout.splitlines()
        own, *loaded = first.split()
        seconds.append(float(own))
        assert not sparse
        standard = set(loaded) - sys.stdlib_module_names
        assert standard == {"hullvib"}
    # standard-library modules that only hullvib needs count as its own
    assert min(seconds) <= 0.05
