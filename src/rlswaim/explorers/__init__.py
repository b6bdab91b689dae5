"""Live views: Python owns the physics, the browser evaluates the polynomials that Python sends."""

from rlswaim.explorers.multiaffine import MultiAffine, multiaffine_form
from rlswaim.explorers.rate_attitude import rate_attitude_explorer
from rlswaim.explorers.widget import Explorer

__all__ = ["Explorer", "MultiAffine", "multiaffine_form", "rate_attitude_explorer"]
