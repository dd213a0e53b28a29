"""Constants from lines: recovered within their covariance, derivatives, blends, and what lines do not say."""

import tracemalloc

import numpy as np
import pytest
from scipy.stats import kstest

from polhode.errors import InvalidInput
from polhode.spectra import MeasuredLines, Rotor, fit_rotor, spin_matrices
from polhode.spectra._derivatives import LevelModel
from spectra.molecules import MHZ, SULFUR_DIOXIDE, WATER, rotor

S_NAMES = ["A", "B", "C", "D_J", "D_JK", "D_K", "d1", "d2", "H_J", "H_JK", "H_KJ", "H_K", "h1", "h2", "h3"]
A_NAMES = ["A", "B", "C", "Delta_J", "Delta_JK", "Delta_K", "delta_J", "delta_K"]
# a bent molecule whose every sextic constant moves lines of J = 20
BENT = rotor(
    (310583.57, 270367.68, 141820.03),
    {"D_J": 19.3, "D_JK": -69.0, "D_K": 120.6, "d1": -10.6, "d2": -0.8, "H_J": 8e-3, "H_JK": -6.3e-2, "H_KJ": 6e-3,
     "H_K": 7.6e-2, "h1": 4e-3, "h2": 8e-4, "h3": 3e-4},
    "S", "Ir", dipole=(1e-30, 3e-30, 0.0),
)  # fmt: skip


def measured(truth, j_max, error, some=None, below=2e12):
    """Lines of a rotor."""
    result = truth.lines(j_max)
    kept = np.flatnonzero(result.frequency < below)
    if some is not None:
        kept = np.sort(np.random.default_rng(7).permutation(kept)[:some])
    return MeasuredLines(result.upper[kept], result.lower[kept], result.frequency[kept], np.full(len(kept), error))


def scattered(lines, seed):
    """Lines off by their errors."""
    return lines._replace(frequency=np.random.default_rng(seed).normal(lines.frequency, lines.error))


def shifted(truth, names, seed=1):
    """The rotor without its distortion, and A, B, C a little off."""
    off = 1.0 + 1e-5 * np.random.default_rng(seed).normal(size=3)
    kept = {name: value for name, value in truth.distortion.items() if name not in names}
    return Rotor(np.multiply(truth.constants, off), kept, *kinds(truth))


def kinds(truth):
    return [kind.name if kind else None for kind in (truth.reduction, truth.representation)]


def truth_of(truth, names):
    return np.array([*truth.constants, *(truth.distortion[name] for name in names[3:])])


def test_fifteen_constants_come_back_without_noise():
    fit = fit_rotor(shifted(BENT, S_NAMES), measured(BENT, 12, 1e4, some=400), S_NAMES)
    assert np.abs((fit.values - truth_of(BENT, S_NAMES)) / fit.sigma).max() < 1e-3
    assert fit.rms < 1e-3 and fit.leverage.sum() == pytest.approx(15.0, rel=1e-9)


@pytest.mark.parametrize("error", [1e-4, 1e4])
def test_a_start_far_away_in_errors_of_the_lines(error):
    """Levels of J ≤ 2 in closed form; steps of a few errors of 0.1 mHz would seem to lead nowhere."""
    A, B, C = true = np.array([27e9, 14.5e9, 9.3e9])
    second = 2 * (A + B + C) - 2 * np.sqrt((B - C) ** 2 + (A - C) * (A - B))  # of 2_02
    ends = [((1, 1, 1), (0, 0, 0), A + C), ((1, 1, 0), (1, 0, 1), A - C), ((2, 0, 2), (1, 1, 1), second - A - C)]
    upper, lower, frequency = (np.array(part) for part in zip(*ends, strict=True))
    fit = fit_rotor(Rotor(true * [1.001, 0.999, 1.0]), MeasuredLines(upper, lower, frequency, np.full(3, error)))
    assert np.abs((fit.values - true) / fit.sigma).max() < 5.0
    assert fit.rms < 1.0


def deviations(truth, names, lines, runs):
    """Deviations of fits from the truth as χ² (runs,) and over σ (runs, p)."""
    whole, single = [], []
    for seed in range(runs):
        fit = fit_rotor(truth, scattered(lines, seed), names)
        off = (fit.values - truth_of(truth, names)) / fit.sigma
        whole.append(off @ np.linalg.solve(fit.correlation, off))
        single.append(off)
    return np.array(whole), np.array(single)


def check_coverage(truth, names, lines, runs, least, most):
    whole, single = deviations(truth, names, lines, runs)
    covered = np.mean(np.abs(single) < 1.959964, axis=0)
    assert least <= covered.mean() <= most
    assert kstest(whole, "chi2", args=(len(names),)).pvalue > 1e-3
    return covered


@pytest.mark.long
def test_errors_cover_the_truth():
    check_coverage(SULFUR_DIOXIDE, A_NAMES, measured(SULFUR_DIOXIDE, 5, 5e4), 25, 0.90, 0.99)


@pytest.mark.sweep
@pytest.mark.parametrize(("truth", "names"), [(BENT, S_NAMES), (WATER, A_NAMES)], ids=["S", "A"])
def test_coverage_in_two_hundred_runs(truth, names):
    covered = check_coverage(truth, names, measured(truth, 8, 1e5, 150, 5e12), 200, 0.92, 0.98)
    assert (covered > 0.9).all() and (covered < 0.995).all()


def operators(J, x, y, z, reduction):
    """∂H/∂p as products of dense matrices of J, in I^r: x, y, z are b, c, a."""
    j, one, zz, up, down = J * (J + 1.0), np.eye(len(x)), z @ z, x + 1j * y, x - 1j * y
    square = x @ x - y @ y
    both = [np.linalg.matrix_power(up, n) + np.linalg.matrix_power(down, n) for n in (0, 2, 4, 6)]
    result = {"A": zz, "B": x @ x, "C": y @ y}
    quartic = [-j * j * one, -j * zz, -zz @ zz]
    if reduction == "A":
        return result | dict(zip(A_NAMES[3:6], quartic, strict=True)) | {
            "delta_J": -2.0 * j * square, "delta_K": -(zz @ square + square @ zz)}  # fmt: skip
    sextic = [j**3 * one, j * j * zz, j * zz @ zz, zz @ zz @ zz]
    return result | dict(zip(S_NAMES[3:6], quartic, strict=True)) | dict(zip(S_NAMES[8:12], sextic, strict=True)) | {
        "d1": j * both[1], "d2": both[2], "h1": j * j * both[1], "h2": j * both[2], "h3": both[3]}  # fmt: skip


@pytest.mark.parametrize(("truth", "names"), [(BENT, S_NAMES), (WATER, A_NAMES)], ids=["S", "A"])
def test_derivatives_are_those_of_dense_matrices(truth, names):
    """⟨v|∂H/∂p|v⟩ of dense eigenvectors, which know nothing of Wang's basis and its bands."""
    J = 6
    dense = operators(J, *spin_matrices(J), truth.reduction.name)
    values = truth_of(truth, names)
    energy, vectors = np.linalg.eigh(sum(value * dense[name] for name, value in zip(names, values, strict=True)))
    wanted = np.array([np.einsum("ik,ij,jk->k", vectors.conj(), dense[name], vectors).real for name in names]).T
    levels = truth.levels_of(J)
    result, slope = LevelModel(truth, names, np.column_stack([levels.J, levels.Ka, levels.Kc]))(values)
    order = np.argsort(result)
    assert result[order] == pytest.approx(energy, rel=1e-12)
    assert slope[order] == pytest.approx(wanted, rel=1e-7, abs=1e-7 * np.abs(wanted).max(axis=0).min())


def test_a_blend_is_the_weighted_mean_of_its_members():
    lines = measured(W_HZ, 4, 1e4)
    weight = np.ones(len(lines.frequency))
    weight[3:5] = 3.0, 1.0
    frequency = lines.frequency.copy()
    frequency[3:5] = 0.75 * frequency[3] + 0.25 * frequency[4]
    blended = lines._replace(frequency=frequency, weight=weight)
    fit = fit_rotor(shifted(W_HZ, []), blended, ["A", "B", "C"])
    assert fit.values == pytest.approx(W_HZ.constants, rel=1e-13)
    assert len(fit.residual) == len(frequency) - 1 and fit.observation[3] == fit.observation[4] == 3
    unequal = fit_rotor(shifted(W_HZ, []), blended._replace(weight=None), ["A", "B", "C"])
    assert unequal.rms > 1e3  # the mean with equal weights is another frequency


def test_a_wrong_line_is_found():
    lines = scattered(measured(SULFUR_DIOXIDE, 8, 5e4, 60), 3)
    lines.frequency[17] += 3e6
    fit = fit_rotor(SULFUR_DIOXIDE, lines, A_NAMES)
    assert fit.worst(1).tolist() == [17] and abs(fit.standardized[17]) > 20.0
    assert fit.rms > 3.0


def test_sigma_leverage_and_prediction_are_those_of_plain_linear_algebra():
    """Of a symmetric top ν = 2B(J+1) − 4 D_J (J+1)³ at K_a = 0, with ∂ν/∂B = 2(J + 1), as C goes with B."""
    top, J = Rotor((27e9, 9e9, 9e9), {"D_J": 3e3}, "S", "Ir", dipole=(1e-30, 0.0, 0.0)), np.arange(6)
    zero = np.zeros_like(J)
    upper, lower = np.column_stack([J + 1, zero, J + 1]), np.column_stack([J, zero, J])
    slope = np.column_stack([2.0 * (J + 1.0), -4.0 * (J + 1.0) ** 3])
    noise = 1e4 * np.random.default_rng(5).normal(size=6)
    lines = MeasuredLines(upper, lower, (18e9 + 1e5) * (J + 1.0) - 12e3 * (J + 1.0) ** 3 + noise, np.full(6, 1e4))
    fit = fit_rotor(top, lines, ["B", "D_J"])
    covariance = np.linalg.inv(slope.T @ slope) * 1e8
    wanted = np.linalg.lstsq(slope, noise)[0]
    assert fit.sigma == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-4)
    assert fit.values - [9e9 + 5e4, 3e3] == pytest.approx(wanted, rel=1e-3)
    assert fit.correlation[0, 1] == pytest.approx(covariance[0, 1] / np.sqrt(covariance[0, 0] * covariance[1, 1]),
                                                  rel=1e-4)  # fmt: skip
    assert fit.leverage == pytest.approx(np.diag(slope @ np.linalg.pinv(slope)), rel=1e-4)
    frequency, sigma = fit.predict(upper, lower)
    assert frequency == pytest.approx(fit.calculated, rel=1e-14)
    assert sigma / 1e4 == pytest.approx(np.sqrt(fit.leverage), rel=1e-9)


METHYL_CYANIDE = {"D_J": 3.8e3, "D_JK": 177e3}  # Hz


@pytest.mark.long_after(2)
@pytest.mark.parametrize(("constants", "dipole", "free"), [
    ((158099e6, 9198.9e6, 9198.9e6), (1e-29, 0.0, 0.0), "B"), ((158099e6, 9198.9e6, 9198.9e6), (1e-29, 0.0, 0.0), "C"),
    ((298192e6, 298192e6, 186726e6), (0.0, 0.0, 5e-30), "A"), ((298192e6, 298192e6, 186726e6), (0.0, 0.0, 5e-30), "B"),
])  # fmt: skip
def test_a_symmetric_top_stays_one(constants, dipole, free):
    """B = C of methyl cyanide, A = B of ammonia: with B alone free the fit moved it alone, by twice the change."""
    representation = "Ir" if dipole[0] else "IIIr"
    truth = Rotor(constants, METHYL_CYANIDE, "S", representation, dipole)
    lines = truth.lines(8)
    observed = MeasuredLines(lines.upper, lines.lower, lines.frequency, np.full(len(lines.frequency), 1e3))
    moved = [x - 0.9e6 if constants.count(x) == 2 else x for x in constants]
    start = Rotor(moved, {"D_J": 3e3, "D_JK": 170e3}, "S", representation)
    fit = fit_rotor(start, observed, [free, "D_J", "D_JK"])
    assert fit.rotor.equal == truth.equal and fit.rms < 1e-3
    assert fit.rotor.constants == pytest.approx(constants, rel=1e-11)
    assert fit.rotor.distortion == pytest.approx(METHYL_CYANIDE, rel=1e-6)
    both = fit_rotor(start, observed, [*truth.equal, "D_J", "D_JK"])  # are one constant
    assert both.names == (truth.equal[0], "D_J", "D_JK") and both.rotor.constants == fit.rotor.constants
    plain = fit_rotor(start, observed)  # what changes no line stays
    assert plain.names == both.names and plain.rotor.constants == fit.rotor.constants


def test_the_third_constant_of_a_symmetric_top_is_named_as_undetermined():
    truth = Rotor((158099e6, 9198.9e6, 9198.9e6), METHYL_CYANIDE, "S", "Ir", (1e-29, 0.0, 0.0))
    lines = truth.lines(8)
    observed = MeasuredLines(lines.upper, lines.lower, lines.frequency, np.full(len(lines.frequency), 1e3))
    with pytest.raises(InvalidInput, match="free constant A is not determined"):
        fit_rotor(truth, observed, ["A", "B", "D_J", "D_JK"])


def test_memory_grows_with_lines_and_not_with_their_square():
    """3,000 lines took a square matrix of 72 MB; 1e5 would have taken 74 GiB."""
    some = measured(W_HZ, 4, 1e4)
    times = 3000 // len(some.frequency) + 1
    many = MeasuredLines(np.tile(some.upper, (times, 1)), np.tile(some.lower, (times, 1)),
                         np.tile(some.frequency, times), np.tile(some.error, times))  # fmt: skip
    tracemalloc.start()
    fit = fit_rotor(shifted(W_HZ, []), many, ["A", "B", "C"])
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 20e6
    assert fit.values == pytest.approx(W_HZ.constants, rel=1e-12) and fit.leverage.sum() == pytest.approx(3.0)


def test_constants_that_lines_do_not_determine_are_named():
    """Lines 0_00–1_01 … of K_a = 0 in a symmetric top do not say what A is, nor which of B and C is which."""
    top = Rotor((27e9, 9e9, 9e9), {"D_J": 3e3}, "S", "Ir", dipole=(1e-30, 0.0, 0.0))
    J = np.arange(4)
    zero = np.zeros_like(J)
    lines = MeasuredLines(np.column_stack([J + 1, zero, J + 1]), np.column_stack([J, zero, J]), 18e9 * (J + 1.0),
                          np.full(4, 1e4))  # fmt: skip
    for free, said in (
        (["A", "D_J"], "free constant A is not determined by these 4 observations; fix it, or add lines"),
        (["B", "D_K", "D_J"], "constant D_K is not"),
    ):  # fmt: skip
        with pytest.raises(InvalidInput, match=said):
            fit_rotor(top, lines, free)
    one = MeasuredLines(np.array([[1, 0, 1]]), np.array([[0, 0, 0]]), np.array([23e9]), np.array([1e3]))
    with pytest.raises(InvalidInput, match=r"B, C are not determined by these 1 observations"):
        fit_rotor(W_HZ, one, ["B", "C"])
    alone = fit_rotor(W_HZ, one._replace(frequency=np.array([23.5e9])), ["B"])
    assert alone.rotor.constants[1] == pytest.approx(14.27e9, rel=1e-12)
    with pytest.raises(InvalidInput, match="order A ≥ B ≥ C"):
        fit_rotor(W_HZ, one._replace(frequency=np.array([15e9])), ["B"])
    assert alone.leverage == pytest.approx([1.0]) and np.isnan(alone.standardized).all()


W_HZ = Rotor((27.31e9, 14.17e9, 9.23e9), dipole=(0.0, 1e-30, 0.0))
LINES = measured(W_HZ, 2, 1e4)


@pytest.mark.parametrize(("change", "free", "said"), [
    ({}, [], "must be a list"), ({}, ["A", "A"], "once"), ({}, ["D_J"], "`reduction`"), ({}, "A", "must be a list"),
    ({"error": 0.0 * LINES.error}, ["A"], r"lines\.error.*positive.*line 1"),
    ({"frequency": LINES.frequency * np.nan}, ["A"], r"lines\.frequency.*finite"),
    ({"frequency": LINES.frequency[:-1]}, ["A"], "one number for each line"),
    ({"weight": -1.0 + 0.0 * LINES.error}, ["A"], r"lines\.weight"),
    ({"upper": LINES.upper + 1}, ["A"], r"Ka \+ Kc = J"), ({"upper": LINES.lower}, ["A"], "between two levels"),
    ({"upper": LINES.upper[:, :2]}, ["A"], r"\(n, 3\)"),
])  # fmt: skip
def test_what_is_refused(change, free, said):
    with pytest.raises(InvalidInput, match=said):
        fit_rotor(W_HZ, LINES._replace(**change), free)


def test_a_linear_molecule_and_reduction_specific_names_are_refused():
    with pytest.raises(InvalidInput, match="polyfit"):
        fit_rotor(Rotor((np.inf, 1e9, 1e9)), LINES, ["B"])
    with pytest.raises(InvalidInput, match="Delta_J"):
        fit_rotor(WATER, measured(WATER, 2, 1.0 * MHZ), ["D_J"])


@pytest.mark.parametrize("known", [True, False], ids=["its own constants", "half the distortion"])
def test_lines_of_another_model_give_no_errors(known):
    """Lines of a molecule of half the distortion, fitted by A, B, C: σ was of some kHz, and values were far off."""
    true = SULFUR_DIOXIDE if known else Rotor(
        SULFUR_DIOXIDE.constants, {name: 0.5 * value for name, value in SULFUR_DIOXIDE.distortion.items()},
        SULFUR_DIOXIDE.reduction.name, SULFUR_DIOXIDE.representation.name, SULFUR_DIOXIDE.dipole,
    )  # fmt: skip
    lines = scattered(measured(true, 8, 5e4, 60), 3)
    fit = fit_rotor(SULFUR_DIOXIDE, lines, ["A", "B", "C"])
    frequency, sigma = fit.predict(lines.upper, lines.lower)
    assert np.isfinite(frequency).all() and np.isfinite(fit.values).all() and np.isfinite(fit.standardized).all()
    assert fit.determined == known == (fit.rms < 2.0) == fit.noise.is_noise
    for errors in (fit.sigma, fit.correlation, fit.covariance, sigma):
        assert np.isfinite(errors).all() == known and np.isnan(errors).all() != known
