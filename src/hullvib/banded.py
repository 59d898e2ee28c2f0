"""The lowest elastic modes of a free-free pencil of banded matrices: dense for few unknowns, else shift-invert."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from hullvib.errors import SolutionError

Array = NDArray[np.float64]

_DENSE = 60  # degrees of freedom up to which a dense solution is the faster one
_DENSE_RESCUE = 2000  # degrees of freedom up to which a dense solution takes seconds at most
_SHIFT = 1.0  # in EI/(m L^4): far below the first elastic eigenvalue, which is of the order of 500


def elastic_modes(stiffness: Array, mass: Array, modes: int) -> tuple[Array, Array, str]:
    """Eigenvalues (modes,), vectors (n, modes) of unit mass, and the solver's name, without the two rigid-body modes.

    stiffness and mass in lower banded form, (bandwidth + 1, n), non-dimensional. Raises SolutionError.
    """
    # few unknowns or nearly all modes: ARPACK wants more unknowns than vectors
    sparse = stiffness.shape[1] > max(_DENSE, 3 * (modes + 2))
    return (_sparse_modes if sparse else _dense_modes)(stiffness, mass, modes)


def banded(elements: Array, stride: int) -> Array:
    """Lower band of the sum of element matrices (count, k, k), each `stride` unknowns after the one before it."""
    count, size = elements.shape[0], elements.shape[1]
    band = np.zeros((size, stride * (count - 1) + size))
    for i in range(size):
        for j in range(i + 1):
            band[i - j, j : j + stride * count : stride] += elements[:, i, j]
    return band


def _dense_modes(stiffness: Array, mass: Array, modes: int) -> tuple[Array, Array, str]:
    def full(band: Array) -> Array:
        matrix = np.diag(band[0])
        for offset in range(1, len(band)):
            side = np.diag(band[offset, :-offset], -offset)
            matrix += side + side.T
        return matrix

    inertia = full(mass)
    # for 1/(lambda + shift), largest first: K + shift M is positive definite where K alone is singular
    try:
        inverse, vectors = eigh(inertia, full(stiffness) + _SHIFT * inertia, check_finite=False)
    except np.linalg.LinAlgError:
        raise SolutionError(
            "the matrices of the elements are singular to working accuracy: all mass lies at one point, or rigidities "
            "or lengths of elements are too far apart; spread the mass, or take StodolaRitz."
        ) from None
    inverse, vectors = inverse[::-1][2 : modes + 2], vectors[:, ::-1][:, 2 : modes + 2]
    if inverse[-1] <= 1e-14:
        raise _too_few_modes(int((inverse > 1e-14).sum()))
    return 1.0 / inverse - _SHIFT, vectors / np.sqrt(inverse), "dense"


def _sparse_modes(stiffness: Array, mass: Array, modes: int) -> tuple[Array, Array, str]:
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import ArpackError, eigsh

    size, offsets = stiffness.shape[1], range(len(stiffness))

    def full(band: Array) -> csc_array[np.float64]:
        below = [k for k in offsets if k > 0]
        diagonals = [band[k, : size - k] for k in (*offsets, *below)]
        rows = [np.arange(size - k) + k for k in offsets]
        columns = [np.arange(size - k) for k in offsets]
        place = (np.concatenate([*rows, *columns[1:]]), np.concatenate([*columns, *rows[1:]]))
        return csc_array((np.concatenate(diagonals), place), shape=(size, size))

    start = np.cos(np.arange(size) * 1.7)  # fixed, so that two runs give the same digits
    try:
        eigenvalues, vectors = eigsh(full(stiffness), k=modes + 2, M=full(mass), sigma=-_SHIFT, which="LM", v0=start)
    except (ArpackError, RuntimeError) as error:
        # a mass matrix of very low rank (point masses on a massless girder) leaves ARPACK without directions
        if size <= _DENSE_RESCUE:
            return _dense_modes(stiffness, mass, modes)
        raise SolutionError(f"the sparse eigenvalue solver failed ({error}); try the Ritz method.") from error
    order = np.argsort(eigenvalues)[2:]
    eigenvalues, vectors = eigenvalues[order], vectors[:, order]
    if not eigenvalues[-1] < 1e14:
        raise _too_few_modes(int((eigenvalues < 1e14).sum()))
    return eigenvalues, vectors, "sparse shift-invert"


def _too_few_modes(found: int) -> SolutionError:
    return SolutionError(f"the girder's mass has only {found} elastic modes; ask for no more than that.")
