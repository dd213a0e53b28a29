"""The fixed-step cases: their states are exact, thresholds separate the orders, refusals do not end a run."""

import json
import re
import shutil
import subprocess

import numpy as np
import pytest

from judging.simulated_engines import equations, midpoint, rk4, semi_implicit
from oracle import fixed_step_cases as oracle
from oracle.taylor import integrated_state
from polhode.errors import InvalidInput
from polhode.judging import fixed_step_cases, run_fixed_steps
from polhode.rotation import angle_between

EPS = 2.0**-52
COMPILER = shutil.which("cc") or shutil.which("gcc")
METHODS = {1: semi_implicit, 2: midpoint, 4: rk4}


@pytest.mark.long
def test_the_files_are_what_the_oracle_says():
    found = [oracle.as_dict(case) for case in oracle.cases()]
    written = json.loads(oracle.TABLE.read_text("utf-8"))["cases"]
    for new, old in zip(found, written, strict=True):
        # thresholds are sums in float32, which another BLAS may order differently
        assert {**new, "thresholds": 0} == {**old, "thresholds": 0}
    assert oracle.header_text(written) == oracle.HEADER.read_text("utf-8")


@pytest.mark.parametrize("number", [0, 4, 11])
def test_taylor_series_give_the_same_states(number):
    case, written = oracle.cases()[number], fixed_step_cases()[number]
    for n, q, L in zip(written.steps[:3], written.attitudes, written.momenta, strict=False):
        attitude, momentum = oracle.states_of(case, n, integrated_state)
        attitude, momentum = (np.array([float(x.mid()) for x in part]) for part in (attitude, momentum))
        assert angle_between(attitude, q) < 4 * EPS
        assert np.abs(momentum - L).max() <= 4 * EPS * np.linalg.norm(L)


def test_inertias_are_full_and_numbers_those_of_float32():
    for case in fixed_step_cases():
        assert np.array_equal(case.inertia, case.inertia.T)
        assert np.abs(case.inertia - np.diag(np.diag(case.inertia))).max() > 1e-3 * np.abs(case.inertia).max()
        for given in (case.inertia, case.attitude, case.angular_velocity, case.dt):
            assert np.array_equal(given, np.float32(given).astype(float))


@pytest.mark.long_cases("4")
@pytest.mark.parametrize("order", METHODS)
def test_a_method_passes_by_its_own_order(order):
    results = run_fixed_steps(lambda inertia: METHODS[order](equations(inertia)), order)
    assert results.passed, str(results)


@pytest.mark.parametrize("order, stricter", [(1, 2), (2, 4)])
def test_a_method_does_not_pass_by_a_higher_order(order, stricter):
    results = run_fixed_steps(lambda inertia: METHODS[order](equations(inertia)), stricter)
    assert sum(not one.passed for one in results.errors) > len(results.errors) // 2


@pytest.mark.long
def test_mistakes_do_not_pass():
    for mistake in ({"gyroscopic": 0.0}, {"gyroscopic": -1.0}, {"factor": 2.0}, {"in_space": True}):
        results = run_fixed_steps(lambda inertia, mistake=mistake: rk4(equations(inertia, **mistake)), 1)
        assert sum(one.passed for one in results.errors) <= 1, (mistake, str(results))
    diagonal = run_fixed_steps(lambda inertia: rk4(equations(np.diag(np.diag(inertia)))), 1)
    assert not any(one.passed for one in diagonal.errors)


def test_a_refused_case_is_listed_and_the_others_are_run():
    def make(inertia):
        if np.trace(inertia) > 1e5:
            raise RuntimeError("too large for me")
        return rk4(equations(inertia))

    results = run_fixed_steps(make, 4)
    assert results.refused == (("large and slow", "RuntimeError: too large for me"),)
    assert len(results.errors) == len(fixed_step_cases()) - 1 and all(one.passed for one in results.errors)
    assert not results.passed and "refused" in str(results)
    with pytest.raises(InvalidInput, match="`order`"):
        run_fixed_steps(make, 3)


PROGRAM = r"""
#include <stdio.h>
#include "polhode_cases.h"
int main(void) {
    for (int k = 0; k < POLHODE_CASE_COUNT; k++) {
        const polhode_case *c = &polhode_cases[k];
        printf("%s|%.9g %.9g %.17g %.17g %.17g %d\n", c->name, c->inertia[0][1], c->dt, c->attitudes[3][1],
               c->momenta[2][0], c->attitude_thresholds[2][3], polhode_case_steps[3]);
    }
    return 0;
}
"""


@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
@pytest.mark.parametrize("standard", ["c99", "c++"])
def test_the_header_has_the_same_numbers(tmp_path, standard):
    source = tmp_path / ("main.cpp" if standard == "c++" else "main.c")
    source.write_text(PROGRAM)
    language = ["-x", "c++"] if standard == "c++" else ["-std=c99"]
    subprocess.run([COMPILER, *language, "-Wall", "-Wextra", "-Werror", "-pedantic", "-I", oracle.HEADER.parent, source,
                    "-o", tmp_path / "main"], check=True, timeout=120)  # fmt: skip
    done = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True, timeout=60)
    for line, case in zip(done.stdout.splitlines(), fixed_step_cases(), strict=True):
        name, _, numbers = line.partition("|")
        inertia, dt, q, L, limit, steps = map(float, re.split(r" ", numbers))
        assert (name, np.float32(inertia), dt, steps) == (case.name, np.float32(case.inertia[0, 1]), case.dt, 640)
        assert (q, L, limit) == (case.attitudes[3, 1], case.momenta[2, 0], case.attitude_thresholds[4][3])
