"""Limits of specs: on either side of each, a text, a key or a body is taken or refused."""

import pytest

from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput
from polhode.spec import assembly, export, keys, known_inertia, parsing, part_overlaps, reach, remarks, surfaces, units
from polhode.spec.models import BodyTable, PartTable, SpinTable


def test_a_label_of_200_characters_is_the_longest():
    most = export.LIMITS.max_characters
    assert export._label("x" * most) == "x" * most
    with pytest.raises(ValueError, match=f"at most {most} characters"):
        export._label("x" * (most + 1))
    assert len(export._in_ascii("x" * (most + 1))) == most


def test_a_place_in_a_key_has_nine_digits_at_most():
    assert keys.is_place("9" * keys.LIMITS.max_digits) and not keys.is_place("9" * (keys.LIMITS.max_digits + 1))


def test_tables_and_keys_of_a_spec_have_bounds(tmp_path):
    def read(text):
        path = tmp_path / "spec.toml"
        path.write_text(text)
        return parsing.read_tables(path)

    depth, dots = parsing.LIMITS.max_depth, parsing.LIMITS.max_dots
    assert read("a = " + "[" * (depth - 1) + "]" * (depth - 1))
    with pytest.raises(FormatError, match=f"more than {depth} deep"):
        read("a = " + "[" * (depth + 1) + "]" * (depth + 1))
    with pytest.raises(FormatError, match=f"more than {depth} deep"):
        read(".".join("a" * dots) + " = 1")  # as many names as are parsed are too deep
    with pytest.raises(FormatError, match=f"more than {dots} names"):
        read(".".join("a" * (dots + 2)) + " = 1")


def test_a_quantity_has_a_hundred_characters_and_powers_up_to_nine():
    most = units.LIMITS.max_characters
    assert units.parse_quantity("1" + "0" * (most - 4) + " m", "m") == 10.0 ** (most - 4)
    with pytest.raises(ValueError, match=f"at most {most} characters"):
        units.parse_quantity("1" + "0" * (most - 2) + " m", "m")
    assert units.parse_quantity("1 m^9", "m^9") == 1.0
    with pytest.raises(ValueError, match="beyond 9"):
        units.parse_quantity("1 m^10", "m^10")


def test_numbers_of_newer_kinds_are_within_reach():
    largest = reach.LIMITS.largest
    reach.check_reach("--mass", largest, 1.0 / largest, 0.0)
    for number in (1.01 * largest, 0.99 / largest):
        with pytest.raises(InvalidInput, match="--mass must be zero or"):
            reach.check_reach("--mass", number)


@pytest.mark.parametrize("spread, common", [(0.5, 1000.0), (2.0, None)])
def test_parts_have_one_density_up_to_decimal_digits(spread, common):
    parts = [PartTable(shape="box", size=["1 m"] * 3, density="1000 kg/m^3")] * 2
    higher = 1000.0 * (1.0 + spread * assembly.LIMITS.relative_spread)
    built = {k: assembly.BuiltPart(None, density, ()) for k, density in enumerate((1000.0, higher))}
    assert assembly._common_density(parts, built) == common


@pytest.mark.parametrize("asymmetry, taken", [(0.5, True), (2.0, False)])
def test_a_tensor_is_symmetric_up_to_rounding(asymmetry, taken):
    off = asymmetry * known_inertia.LIMITS.max_asymmetry * 3.0
    rows = [[2.0, off, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 3.0]]
    table = BodyTable(mass="1 kg", inertia=[[f"{x!r} kg*m^2" for x in row] for row in rows])
    if taken:
        assert known_inertia.build_known(table).body.inertia[0, 1] == 0.5 * off
    else:
        with pytest.raises(InvalidInput, match="symmetric"):
            known_inertia.build_known(table)


@pytest.mark.parametrize("share, reported", [(0.5, False), (2.0, True)])
def test_an_overlap_is_reported_from_a_twentieth_of_a_part_on(share, reported, tmp_path):
    depth = share * part_overlaps.LIMITS.min_share
    box = {"shape": "box", "size": ["1 m"] * 3, "density": "1000 kg/m^3"}
    parts = [PartTable(**box), PartTable(**box, at=[f"{1.0 - depth} m", "0 m", "0 m"])]
    assert bool(part_overlaps.notes_on_places(parts, None, tmp_path)) == reported


@pytest.mark.parametrize("factor, quantum", [(0.9, True), (1.1, False)])
def test_a_temperature_is_high_for_rotation_from_five_quanta_on(factor, quantum):
    from polhode.analysis.thermal import rotational_temperature

    body = Body.from_moments((1e-46, 1e-46, 2e-46))
    at = factor * remarks.LIMITS.min_classical * float(rotational_temperature(body.principal_moments).max())
    text = remarks.remarks_on(body, SpinTable(temperature=f"{at} K"))[-1]
    assert ("Quantum theory counts here" in text) == quantum


def test_a_body_of_too_many_pieces_is_not_drawn(monkeypatch, tmp_path):
    box = {"shape": "box", "size": ["1 m"] * 3, "mass": "1 kg"}
    table = BodyTable(part=[box | {"at": [f"{2 * k} m", "0 m", "0 m"]} for k in range(3)])
    monkeypatch.setattr(surfaces, "LIMITS", surfaces.DrawingLimits(max_pieces=3))
    assert surfaces.surface_of_body(table, tmp_path) is not None
    monkeypatch.setattr(surfaces, "LIMITS", surfaces.DrawingLimits(max_pieces=2))
    with pytest.raises(InvalidInput, match="2, which"):
        surfaces.surface_of_body(table, tmp_path)
