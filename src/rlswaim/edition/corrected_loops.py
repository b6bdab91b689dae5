"""Where the report's slips lead: the same loop along its own printed numbers and along corrected ones.

Every function returns open loops by ``"report"`` and ``"corrected"``, for root loci on the same axes.
The pairs of Sections V and VI are those of `section_5` and `section_6`
beside `rlswaim.loops.transfer_functions`.
"""

import control
import numpy as np

from rlswaim.edition.printed_closures import final_design, printed_closure_2
from rlswaim.loops import closures
from rlswaim.loops.rigid_body_design import RigidBody, rigid_body
from rlswaim.loops.transfer_functions import transfer
from rlswaim.source.tables import printed
from rlswaim.vehicle.coupling import partition
from rlswaim.vehicle.equations import PerturbationEquations

Loops = dict[str, control.TransferFunction]


def coupling_loops(eqs: PerturbationEquations) -> Loops:
    """Return coupling over uncoupled part of Eq. 42: the gain is the strength of the coupling, 1 in flight.

    The report compares Eq. 51, not over U, with Eq. 50, over U, as if both had one scale.
    """
    p, parts = printed("III"), partition(eqs)
    uncoupled = [0.0, *(p[f"eq50-s{k}"] for k in (1, 2, 3, 4)), 1.0]
    coupling = [0.0, *(p[f"eq51-s{k}"] for k in (1, 2, 3))]
    return {
        "report": transfer(coupling, uncoupled),
        "corrected": transfer(parts.coupling, parts.uncoupled),
    }


def _rigid_loop(body: RigidBody, K_C: float, K_R: float) -> control.TransferFunction:
    top = K_C * np.convolve([1.0, K_R], [body.g_0, body.g_1])
    return transfer(top, np.convolve([K_C, 1.0], [0.0, body.c_0, body.c_1, 1.0]))


def rigid_loops(eqs: PerturbationEquations) -> Loops:
    """Return the rigid body's attitude loop for K_A = 1: Eq. 61 as printed, and all of it over U."""
    p = printed("IV")
    as_printed = RigidBody(**{name: p[f"eq61-{name}"] for name in ("c_0", "c_1", "g_0", "g_1")})
    bodies = {"report": as_printed, "corrected": rigid_body(eqs)}
    return {name: _rigid_loop(body, p["fig8-K_C"], p["eq75-K_R"]) for name, body in bodies.items()}


def closure_2_loops(eqs: PerturbationEquations) -> Loops:
    """Return closure 2's open loop, closed at gain 1: Eq. 136 as printed, and with theta/delta_r."""
    return {
        "report": printed_closure_2(),
        "corrected": closures.closure_2_open_loop(eqs, *final_design()),
    }
