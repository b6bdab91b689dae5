"""An executable, critical edition of R. L. Swaim, *Active Control of Booster Elasticity* (1964)."""

from rlswaim.edition.ledger import ledger
from rlswaim.edition.search import searches
from rlswaim.explorers.own_loop import explore
from rlswaim.loops.systems import dual_actuation, rate_attitude, single_sensor, two_sensor
from rlswaim.practice.greensite import greensite
from rlswaim.rootlocus.locus import RootLocus, parameter_locus, root_locus
from rlswaim.vehicle.booster import Booster, FlightCondition, Surface, swaim_booster
from rlswaim.vehicle.equations import PerturbationEquations, perturbation_equations, printed_equations
from rlswaim.vehicle.other_data import with_other_data
from rlswaim.vehicle.own_vehicle import read_booster

__all__ = [
    "Booster",
    "FlightCondition",
    "PerturbationEquations",
    "RootLocus",
    "Surface",
    "dual_actuation",
    "explore",
    "greensite",
    "ledger",
    "parameter_locus",
    "perturbation_equations",
    "printed_equations",
    "rate_attitude",
    "read_booster",
    "root_locus",
    "searches",
    "single_sensor",
    "swaim_booster",
    "two_sensor",
    "with_other_data",
]
