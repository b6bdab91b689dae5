"""What controllers reach beside the limits: optimal regulators with Kalman filters, for several weights."""

from itertools import product
from typing import NamedTuple

import control
import numpy as np
from numpy.typing import NDArray

from rlswaim.practice.margins import frequency_response, margins
from rlswaim.source import checks

WEIGHTS = tuple(np.geomspace(1e-6, 1e2, 5).tolist())
SMALL = 1e-3
"""Weight of every state, and noise on every state, beside those of outputs and inputs."""


class Reached(NamedTuple):
    """The least peak of the sensitivity at the engine among some controllers, and the loop that has it."""

    peak: float
    effort: float
    noise: float
    stable_controller: bool
    loop: control.StateSpace


def regulator(plant: control.StateSpace, effort: float, noise: float) -> control.StateSpace:
    """Return a linear quadratic regulator with a Kalman filter, from a plant's outputs to its inputs.

    Parameters
    ----------
    plant : control.StateSpace
    effort : float
        Weight of each input, that of each output being 1.
    noise : float
        Intensity of the noise of each output, that at each input being 1.

    Returns
    -------
    control.StateSpace
        For negative feedback.

    Raises
    ------
    ValueError
        If a weight is not positive.
    """
    effort, noise = (
        checks.positive(name, value, "regulator") for name, value in (("effort", effort), ("noise", noise))
    )
    A, B, C = plant.A, plant.B, plant.C
    every = SMALL * np.eye(plant.nstates)
    K = control.lqr(A, B, every + C.T @ C, effort * np.eye(plant.ninputs))[0]
    F = control.lqe(A, np.eye(plant.nstates), C, every + B @ B.T, noise * np.eye(plant.noutputs))[0]
    return control.ss(A - B @ K - F @ C, F, K, np.zeros((plant.ninputs, plant.noutputs)))


def least_peak_reached(plant: control.StateSpace, weights: tuple[float, ...] = WEIGHTS) -> Reached:
    """Return the least peak of |S| at the one input that regulators over a grid of weights reach.

    Parameters
    ----------
    plant : control.StateSpace
        With one input.
    weights : tuple of float
        Values of both weights of `regulator`.

    Returns
    -------
    Reached
        Among the loops that are stable; others of higher order may reach less.

    Raises
    ------
    ValueError
        If no loop is stable.
    """
    found = []
    for effort, noise in product(weights, weights):
        controller = regulator(plant, effort, noise)
        loop = control.ss(control.series(plant, controller))
        if control.feedback(loop, 1).poles().real.max() < 0:
            peak = margins(loop, points=300).peak_sensitivity
            found.append(Reached(peak, effort, noise, bool(controller.poles().real.max() < 0), loop))
    if not found:
        raise ValueError("plant in least_peak_reached: got no stable loop, wanted one that can be stabilized")
    return min(found, key=lambda one: one.peak)


def sensitivity(loop: control.StateSpace, omega: NDArray) -> NDArray:
    """Return |S| = 1/|1 + L| of a loop with one input over frequency.

    Parameters
    ----------
    loop : control.StateSpace
    omega : ndarray, shape (n,)
        In rad/s.

    Returns
    -------
    ndarray, shape (n,)
    """
    return 1 / np.abs(1 + frequency_response(loop, omega)[:, 0, 0])
