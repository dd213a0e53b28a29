"""Proofs: derivations by symbols, enclosures in balls, verdicts as files for provers.

It answers what follows from a bracket, each step checked (``derive``), which bounds on a motion can be proved
(``certify``), and why a verdict on stability holds (``write_proof`` for Rocq, ``check_by_z3``). Sources: Marsden and
Ratiu (1999), Johansson on ball arithmetic (2017). From the core it takes systems and their brackets (``systems``,
``algebra``, ``poisson``), closed forms (``exact``), traced rates (``taylor``) and ``certificates``.
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
