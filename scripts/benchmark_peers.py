"""Other packages on the cases of benchmark_table.py, a function each; ImportError where the package is not installed.

Each returns the package's name with its version, and a function that takes a girder and nodes (n + 1,) in m, assembles
and solves, and returns the frequencies of the first six elastic modes in rad/s. Elements are cut at the nodes; those of
PyCBA, pyfe3d and OpenSees are prismatic, with the girder's values at mid-length.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib.metadata import version

import numpy as np
from numpy.typing import NDArray

from hullvib import Girder

Array = NDArray[np.float64]
Run = Callable[[Girder, Array], Array]
RIGID, ELASTIC = 2, 6
ALL = RIGID + ELASTIC
# between the rigid-body modes, which are singular without it, and the elastic ones
SHIFT = -1.0


def scikit_fem() -> tuple[str, Run]:
    import skfem
    from scipy.sparse import diags_array
    from scipy.sparse.linalg import eigsh
    from skfem.helpers import dd

    @skfem.BilinearForm
    def bending(u, v, w):  # type: ignore[no-untyped-def]
        return w.rigidity * dd(u)[0, 0] * dd(v)[0, 0]

    @skfem.BilinearForm
    def inertia(u, v, w):  # type: ignore[no-untyped-def]
        return w.mass * u * v

    def run(girder: Girder, nodes: Array) -> Array:
        basis = skfem.Basis(skfem.MeshLine(nodes), skfem.ElementLineHermite(), intorder=8)
        x = np.asarray(basis.global_coordinates())[0]
        flat = x.reshape(-1)
        rigidity, mass = girder.flexural_rigidity(flat).reshape(x.shape), girder.mass_per_length(flat).reshape(x.shape)
        stiffness, mass_matrix = skfem.asm(bending, basis, rigidity=rigidity), skfem.asm(inertia, basis, mass=mass)
        if girder.point_masses:
            points = np.zeros(basis.N)
            points[basis.nodal_dofs[0]] = point_masses_at(girder, nodes)
            mass_matrix = mass_matrix + diags_array(points)
        values = eigsh(stiffness, k=ALL, M=mass_matrix, sigma=SHIFT, return_eigenvectors=False)
        return np.sqrt(np.sort(values)[RIGID:])

    return f"scikit-fem {version('scikit-fem')}", run


def pycba() -> tuple[str, Run]:
    from pycba import BeamAnalysis

    def run(girder: Girder, nodes: Array) -> Array:
        widths, rigidity, mass = prisms(girder, nodes)
        # it knows no point masses: each is spread over the element beside its node
        at_nodes = point_masses_at(girder, nodes)
        mass = mass + at_nodes[:-1] / widths
        mass[-1] += at_nodes[-1] / widths[-1]
        beam = BeamAnalysis(widths, rigidity, np.zeros(2 * len(nodes)))
        return np.asarray(beam.modal(mass, n_modes=ALL, nseg=1).omega)[RIGID:]

    return f"PyCBA {version('pycba')}", run


def pyfe3d() -> tuple[str, Run]:
    from pyfe3d import DOF, INT, BeamC, BeamCData, BeamCProbe
    from pyfe3d.beamprop import BeamProp
    from scipy.sparse import coo_array, diags_array
    from scipy.sparse.linalg import eigsh

    entries = BeamCData().KC0_SPARSE_SIZE

    def run(girder: Girder, nodes: Array) -> Array:
        widths, rigidity, mass = prisms(girder, nodes)
        places = np.zeros((len(nodes), 3))
        places[:, 0] = nodes
        flat_places = places.ravel()
        rows, columns = np.zeros((2, entries * len(widths)), dtype=INT)
        stiffness_values, mass_values = np.zeros((2, entries * len(widths)))
        beam, section = BeamC(BeamCProbe()), BeamProp()
        section.A = section.E = section.GJ = 1.0
        for element, width in enumerate(widths.tolist()):
            beam.c1, beam.c2 = DOF * element, DOF * (element + 1)
            beam.init_k_KC0 = beam.init_k_M = entries * element
            beam.update_rotation_matrix(0.0, 1.0, 0.0, flat_places)
            beam.update_probe_xe(flat_places)
            section.Iyy = section.Izz = rigidity[element]
            section.intrho = mass[element]
            # its element is Timoshenko's: 12 EI / G A L^2 = 1e-9 leaves no shear
            section.G12 = section.G13 = 12e9 * rigidity[element] / width**2
            beam.update_KC0(rows, columns, stiffness_values, section)
            beam.update_M(rows, columns, mass_values, section)
        size = DOF * len(nodes)
        # vertical displacement and rotation in the plane, of six a node
        kept = (DOF * np.arange(len(nodes))[:, None] + [1, 5]).ravel()
        stiffness = coo_array((stiffness_values, (rows, columns)), shape=(size, size)).tocsc()[kept][:, kept]
        mass_matrix = coo_array((mass_values, (rows, columns)), shape=(size, size)).tocsc()[kept][:, kept]
        if girder.point_masses:
            points = np.zeros(2 * len(nodes))
            points[::2] = point_masses_at(girder, nodes)
            mass_matrix = mass_matrix + diags_array(points)
        values = eigsh(stiffness, k=ALL, M=mass_matrix, sigma=SHIFT, return_eigenvectors=False)
        return np.sqrt(np.sort(values)[RIGID:])

    return f"pyfe3d {version('pyfe3d')}", run


def openseespy() -> tuple[str, Run]:
    try:
        import openseespy.opensees as ops
    except RuntimeError as error:
        # what it raises where it is installed and a library of the system is missing
        raise ImportError("it needs libblas.so.3 and liblapack.so.3 (apt: libblas3, liblapack3)") from error

    def run(girder: Girder, nodes: Array) -> Array:
        _, rigidity, mass = prisms(girder, nodes)
        ops.wipe()
        ops.model("basic", "-ndm", 2, "-ndf", 3)
        for node, x in enumerate(nodes.tolist()):
            ops.node(node, x, 0.0)
            ops.fix(node, 1, 0, 0)
        for node, point in enumerate(point_masses_at(girder, nodes).tolist()):
            if point > 0.0:
                ops.mass(node, 0.0, point, 0.0)
        ops.geomTransf("Linear", 1)
        for element, (stiff, heavy) in enumerate(zip(rigidity.tolist(), mass.tolist(), strict=True)):
            section = (1.0, 1.0, stiff)
            ops.element("elasticBeamColumn", element, element, element + 1, *section, 1, "-mass", heavy, "-cMass")
        values = np.array(ops.eigen(ALL))
        return np.sqrt(np.sort(values)[RIGID:])

    return f"openseespy {version('openseespy')}", run


PEERS = (scikit_fem, pycba, pyfe3d, openseespy)


def installed() -> dict[str, Run]:
    """The packages at hand by name; says on standard error which are not."""
    found = {}
    for peer in PEERS:
        try:
            name, run = peer()
        except ImportError as error:
            print(f"{peer.__name__} is left out: {error}", file=sys.stderr)
        else:
            found[name] = run
    return found


def prisms(girder: Girder, nodes: Array) -> tuple[Array, Array, Array]:
    """Lengths (m), EI (N m^2) and mass per length (kg/m) of prismatic elements between nodes, each (n,)."""
    middle = (nodes[:-1] + nodes[1:]) / 2
    return np.diff(nodes), girder.flexural_rigidity(middle), girder.mass_per_length(middle)


def point_masses_at(girder: Girder, nodes: Array) -> Array:
    """The girder's point masses in kg, each at the node next to it, (n + 1,)."""
    at_nodes = np.zeros(len(nodes))
    for point in girder.point_masses:
        at_nodes[np.abs(nodes - point.x_m).argmin()] += point.mass_kg
    return at_nodes
