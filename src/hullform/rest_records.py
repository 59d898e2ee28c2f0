"""What results.json says of a ship at rest: how she floats, and still water's forces along her."""

from __future__ import annotations

from hullform.record_table import Finite, RecordTable


class FloatingRecord(RecordTable):
    """A straight waterline: draughts, trim by the stern positive, and what it carries."""

    draught_aft_m: Finite
    draught_fore_m: Finite
    draught_midships_m: Finite
    trim_m: Finite
    trim_percent_lpp: Finite
    displacement_kg: Finite
    lcb_m: Finite
    least_freeboard_m: Finite


class ExtremesRecord(RecordTable):
    """The greatest and the least value of a curve, and where they stand."""

    maximum: Finite
    maximum_x_m: Finite
    minimum: Finite
    minimum_x_m: Finite


class StillWaterRecord(RecordTable):
    """Shear force and bending moment, hogging positive, dM/dx = V; every x stands twice, once for either side.

    Without `equilibrium` they are at a waterline that does not carry the weights, and leave a remainder at the fore
    end. `closing_shear` and `closing_moment` are that remainder over the largest |V| and |M|.
    """

    equilibrium: bool
    draught_aft_m: Finite
    draught_fore_m: Finite
    shear_force_n: ExtremesRecord
    bending_moment_n_m: ExtremesRecord
    unclosed_shear_force_n: Finite
    unclosed_bending_moment_n_m: Finite
    closing_shear: Finite
    closing_moment: Finite
    x_m: list[Finite]
    weight_n_per_m: list[Finite]
    buoyancy_n_per_m: list[Finite]
    shear_force_curve_n: list[Finite]
    bending_moment_curve_n_m: list[Finite]
