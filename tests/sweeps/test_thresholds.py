"""Thresholds of sweeps decide: inputs on either side have different outcomes."""

from types import SimpleNamespace

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.spec.keys import Number
from polhode.sweeps import answers, columns, distributions, plan, running, store
from polhode.sweeps.plan import SweepTable

TABLE = {"inputs": {"spin.rate": 1}, "outputs": ["energy"]}


@pytest.mark.parametrize("name, most", [("samples", plan.LIMITS.max_samples), ("chunk", plan.LIMITS.max_chunk)])
def test_tables_are_refused_beyond_their_sizes(name, most):
    assert getattr(SweepTable.model_validate(TABLE | {name: most}), name) == most
    with pytest.raises(ValueError, match=name):
        SweepTable.model_validate(TABLE | {name: most + 1})


def test_crossed_grids_are_refused_beyond_the_largest_sweep(tmp_path, monkeypatch):
    path = tmp_path / "case.toml"
    path.write_text('[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n[spin]\nabout = 2\nrate = "1 rpm"\n'
                    '[sweep]\noutputs = ["energy"]\n[sweep.inputs]\n'
                    '"spin.tilt" = { grid = { from = "0 deg", to = "9 deg", count = 10 } }\n')  # fmt: skip
    for most in (10, 9):
        monkeypatch.setattr(plan, "LIMITS", plan.LIMITS._replace(max_samples=most))
        if most == 10:
            assert plan.read_plan(path).design.count == 10
        else:
            with pytest.raises(InvalidInput, match="9"):
                plan.read_plan(path)


def test_grids_are_refused_beyond_their_length(tmp_path, monkeypatch):
    monkeypatch.setattr(distributions, "LIMITS", distributions.LIMITS._replace(max_grid_values=5))
    for count in (5, 6):
        asked = {"from": "0 rad", "to": "1 rad", "count": count}
        if count == 5:
            assert distributions.Grid.read(asked, distributions.Reader(Number("rad")), tmp_path).count == count
        else:
            with pytest.raises(ValueError, match="needs a count from 2 to 5"):
                distributions.Grid.read(asked, distributions.Reader(Number("rad")), tmp_path)


def test_short_sweeps_are_computed_by_one_process(monkeypatch):
    monkeypatch.setattr(running, "available_cores", lambda: 7)
    for factor, workers in ((0.99, 1), (1.01, 7)):
        assert running.Sweep.usual_workers(SimpleNamespace(), factor * running.LIMITS.min_work) == workers


def test_a_store_needs_more_room_than_its_size(tmp_path, monkeypatch):
    for factor in (1.01, 0.99):
        free = factor * store.LIMITS.min_free_ratio * 10_000
        monkeypatch.setattr("shutil.disk_usage", lambda path, free=free: SimpleNamespace(free=free))
        if factor > 1.0:
            store.check_room(tmp_path, 10_000)
        else:
            with pytest.raises(InvalidInput, match="the disk has"):
                store.check_room(tmp_path, 10_000)


def test_words_are_outputs_and_sentences_are_not():
    most = columns.LIMITS.max_word
    column = columns.Column("regime", text=True)
    assert columns.fit_to_column(column, "w" * most) == "w" * most
    with pytest.raises(InvalidInput, match="of another form"):
        columns.fit_to_column(column, "w" * (most + 1))
    assert columns.answer_column("regime", {"regime": "w" * most}, {}).text
    with pytest.raises(InvalidInput, match="is a sentence"):
        columns.answer_column("regime", {"regime": "w" * (most + 1)}, {})


def test_quantiles_are_of_all_values_up_to_a_number_of_samples(monkeypatch, any_type):
    values = np.arange(10.0)
    for most in (10, 9):
        monkeypatch.setattr(answers, "LIMITS", answers.LIMITS._replace(max_exact_samples=most))
        design = SimpleNamespace(count=10)
        report = SimpleNamespace(sweep=SimpleNamespace(plan=SimpleNamespace(keep="all", design=design)),
                                 store=SimpleNamespace(read=lambda name: values))  # fmt: skip
        one = SimpleNamespace(count=10, quantiles=lambda levels: ["of knots"])
        exact = answers.SweepReport._quantiles(report, columns.Column("energy"), 0, one)
        assert (exact == ["of knots"]) == (most < 10)
