"""Traces of powers of matrices, which Casimirs of matrix algebras are, against sums of powers of eigenvalues."""

import numpy as np
import pytest

from polhode import algebra as lie

FACTORS = {lie.SO: 1.0, lie.SL: 1.0, lie.Sp: 1.0, lie.SU: 1j, lie.U: 1j}  # of μ in the named traces


@pytest.mark.parametrize("algebra", [lie.SO(2), lie.SO(3), lie.SO(7), lie.SL(2), lie.SL(5), lie.Sp(1), lie.Sp(3),
                                     lie.SU(2), lie.SU(5), lie.U(1), lie.U(2), lie.U(6)], ids=repr)  # fmt: skip
def test_traces_are_those_that_the_names_say(algebra):
    mu = algebra.from_dual_vector(np.random.default_rng(0).normal(size=(3, algebra.dim)))
    eigenvalues = np.linalg.eigvals(FACTORS[type(algebra)] * np.asarray(mu))
    sizes = np.abs(eigenvalues).max(axis=-1)
    casimirs = np.asarray(algebra.casimirs(mu))
    assert casimirs.shape == (3, len(algebra.casimir_names))
    for k, name in enumerate(algebra.casimir_names):
        if name.startswith("Pf"):
            continue
        power = 1 if name.endswith("μ") else 2 if name.endswith("²") else int(name.rpartition("^")[2])
        wanted = np.sum(eigenvalues**power, axis=-1).real * (-0.5 if name.startswith("−½") else 1.0)
        assert np.abs(casimirs[:, k] - wanted).max() < 1e-13 * algebra.n * sizes.max() ** power, name
