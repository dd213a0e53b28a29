"""Certificates as files for the prover Rocq: the equations as formulas, data for a verified checker, the theorem."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from importlib import resources
from pathlib import Path

from flint import fmpq, fmpq_mpoly

from polhode._base.rational._polynomials import quadratic_form, rate, terms_of
from polhode._base.rational.numbers import READINGS
from polhode.certificates._confinement import Confinement, Squares
from polhode.certificates._equations import Equations
from polhode.certificates._growth import Drift, Growth
from polhode.certificates.rational import RationalCertificate, require_rational
from polhode.errors import InvalidInput, shown

THEORY = "checker.v"
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\.v")
TRUE = "true"


def write_proof(certificate: RationalCertificate, path: str | Path) -> Path:
    """Write a Rocq file that proves the verdict, and beside it ``checker.v``, on which it rests.

    ``coqc -Q . Polhode checker.v`` and then ``coqc -Q . Polhode FILE.v`` in that folder check both; they need Coq
    8.16 or Rocq, and no other library.

    Args:
        certificate: as ``certificate.as_rational()`` of a verdict gives it.
        path: of the file, ending in .v, a name that starts with a letter.

    Returns:
        The path.

    Raises:
        InvalidInput: for another name, or a certificate that proves nothing.
    """
    require_rational(certificate)
    path = Path(path)
    if not NAME.fullmatch(path.name) or path.name == THEORY:
        raise InvalidInput(f"a proof's file must be named like top_1.v, other than {THEORY}, as the prover takes the "
                           f"name for a module; got {shown(path.name)}.")
    certificate.check()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.with_name(THEORY).write_text(theory(), "utf-8")
        path.write_text(proof_text(certificate, path.stem), "utf-8")
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be written ({error.strerror}). Choose another folder.") from None
    return path


def theory() -> str:
    """Return the theory on which each certificate rests."""
    return (resources.files("polhode.proving.verdicts") / THEORY).read_text("utf-8")


def proof_text(certificate: RationalCertificate, name: str) -> str:
    """Return the file's text; ``name`` is that of the file, without its ending."""
    equations, proof = certificate.equations, certificate.proof
    parts = [_header(certificate, name), _readable(equations), _data(equations)]
    if isinstance(proof, Confinement):
        parts.append(_confinement_data(equations, proof))
        if equations.flow:
            parts += [_turns(equations), _turning_theorem(equations)]
        else:
            parts.append(_confinement_theorem(equations))
    else:
        data = _growth_data(proof) if isinstance(proof, Growth) else _drift_data(proof)
        parts += [data, _leaving_theorem(equations, "growing" if isinstance(proof, Growth) else "drifting")]
    return "\n".join(parts)


def _header(certificate: RationalCertificate, name: str) -> str:
    point = ", ".join(map(str, certificate.equations.point))
    moved = certificate.equations.moved
    near = f"\nThis exact equilibrium is {float(moved):.1e} from the point that was asked about.\n" if moved else ""
    verdict = "stable on its own leaf, else undecided" if certificate.equations.within else certificate.verdict
    return f"""(* {certificate.equations.system}: ({point}) is {verdict}.
{near}
{certificate.statement[0].upper()}{certificate.statement[1:]}:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, {READINGS[certificate.equations.read_as]}.
Written by polhode; checked by `coqc -Q . Polhode {THEORY}` and `coqc -Q . Polhode {name}.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.
"""


def _readable(equations: Equations) -> str:
    """Return the equations and the distance from the point as formulas."""
    n = equations.size
    names = " ".join(_x(n))
    lines = ["(* the equations: the rate of change of each coordinate *)"]
    for k, f in enumerate(equations.field):
        lines.append(_wrap(f"Definition f{k + 1} ({names} : R) : R := {_formula(f)}."))
    squares = " + ".join(f"(x{k + 1} - {_real(z)}) * (x{k + 1} - {_real(z)})" for k, z in enumerate(equations.point))
    lines += ["(* the square of the distance from the point *)",
              _wrap(f"Definition distance2 ({names} : R) : R := {squares}."), ""]
    return "\n".join(lines)


def _data(equations: Equations) -> str:
    """Return equations and point as data, and lemmas that they equal the formulas."""
    n = equations.size
    rows = ";\n  ".join(_poly(f) for f in equations.field)
    lines = ["(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)",
             f"Definition field : list poly := [\n  {rows}].",
             f"Definition point : list Q := {_numbers(equations.point)}.",
             "Definition zf := equation field.\nDefinition zp := entry_of point."]  # fmt: skip
    at = " ".join(f"(x {k}%nat)" for k in range(n))
    for k in range(n):
        lines += [f"Lemma reads{k + 1} x : eval x (zf {k}) = f{k + 1} {at}.",
                  f"Proof. unfold zf, field, f{k + 1}. read_data. Qed."]
    lines += [f"Lemma reads_distance x : off {n} zp x = distance2 {at}.",
              "Proof. unfold zp, point, distance2. read_data. Qed.", ""]
    return "\n".join(lines)


def _confinement_data(equations: Equations, proof: Confinement) -> str:
    names = [k for k in equations.conserved if k in proof.weights or k in proof.squares]
    lines = ["(* what is conserved: " + "; ".join(f"c{k + 1} = {_plain(name)}" for k, name in enumerate(names)) + " *)"]
    polynomials = [_poly(equations.conserved[name]) for name in names]
    lines += [_wrap(f"Definition c{k + 1} : poly := {text}.") for k, text in enumerate(polynomials)]
    parts = [f"scale {_q(proof.weights[name])} c{k + 1}" for k, name in enumerate(names) if name in proof.weights]
    lines.append("Definition square (p : poly) (level : Q) : poly := "
                 "times (add p (constant (- level))) (add p (constant (- level))).")
    parts += [f"scale {_q(proof.squares[name])} (square c{k + 1} {_q(equations.levels[name])})"
              for k, name in enumerate(names) if name in proof.squares]
    lines += [_wrap("Definition G : poly := " + _sum(parts) + "."),
              f"Definition margin : Q := {_q(proof.margin)}.\nDefinition radius : Q := {_q(proof.radius)}.",
              f"Definition forms : list (Q * list Q) := {_squares(proof.forms)}."]
    if equations.flow:
        lines.append(f"Definition slice : Q := {_q(proof.slice)}.")
    return "\n".join([*lines, ""])


def _turns(equations: Equations) -> str:
    """Return the symmetry as formulas and as data."""
    n, flow = equations.size, equations.flow
    twice = [rate(x, flow) for x in flow]
    names, at = " ".join(_x(n)), " ".join(f"(x {k}%nat)" for k in range(n))
    lines = [f"(* turned points: those on the orbit of the flow of {_plain(equations.flow_name)} *)"]
    for k, (once, again) in enumerate(zip(flow, twice, strict=True)):
        formula = f"x{k + 1} + sin a * ({_formula(once)}) + (1 - cos a) * ({_formula(again)})"
        lines.append(_wrap(f"Definition turn{k + 1} (a {names} : R) : R := {formula}."))
    for name, polynomials in (("turning", flow), ("turning_twice", twice)):
        rows = ";\n  ".join(map(_poly, polynomials))
        lines.append(f"Definition {name} : list poly := [\n  {rows}].")
    for k in range(n):
        lines += [
            f"Lemma twice{k + 1} : is_zero (add (X2 turning {k}) (scale (-1) (equation turning_twice {k}))) = {TRUE}.",
            "Proof. vm_cast_no_check (eq_refl true). Qed.",
            f"Lemma reads_turn{k + 1} a x : turn turning a x {k} = turn{k + 1} a {at}.",
            f"Proof. unfold turn. rewrite (eval_same _ _ x twice{k + 1}).",
            f"  unfold X1, turning, turning_twice, turn{k + 1}. read_data. Qed.",
        ]
    return "\n".join([*lines, ""])


def _turning_theorem(equations: Equations) -> str:
    n = equations.size
    x, paths = _x(n), "; ".join(_x(n))
    images = " ".join(f"(turn{k + 1} a {_at(n, 't')})" for k in range(n))
    reads = ", ".join(f"reads_turn{k + 1}" for k in range(n))
    return f"""Lemma symmetry : check_symmetry {n} turning = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma minimum : check_extremum {n} zp G (let w := shift zp (across {n} zp turning) in scale slice (times w w))
  forms margin radius = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept_by_turns : is_zero (rate (X1 turning) G) = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem orbit_is_stable : forall eps, 0 < eps -> exists del, 0 < del /\\
  forall ({" ".join(x)} : R -> R) (T : R),
{_solutions(n)}
  distance2 {_at(n, "0")} < del ->
  forall t, 0 <= t <= T -> exists a : R,
  distance2 {images} < eps.
Proof.
  intros eps pe.
  destruct (confined_up_to_turns {n} zf zp turning symmetry G slice forms margin radius minimum kept kept_by_turns
    eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros {" ".join(x)} T {_hypotheses(n)} near t ht.
  assert (k : exists a, off {n} zp (turn turning a (path [{paths}] t)) < eps).
  2: {{ destruct k as (a & k). exists a. rewrite reads_distance, {reads} in k. exact k. }}
  apply (h (path [{paths}]) T);
    [| intros; apply path_inside; simpl; lia | rewrite reads_distance; exact near | exact ht].
{_solves(n)}
Qed.
Print Assumptions orbit_is_stable.
"""


def _confinement_theorem(equations: Equations) -> str:
    n = equations.size
    x, paths = _x(n), "; ".join(_x(n))
    name = "equilibrium_is_stable_on_its_leaf" if equations.within else "equilibrium_is_stable"
    return f"""Lemma minimum : check_extremum {n} zp G [] forms margin radius = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = {TRUE}.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem {name} : forall eps, 0 < eps -> exists del, 0 < del /\\
  forall ({" ".join(x)} : R -> R) (T : R),
{_solutions(n)}
  distance2 {_at(n, "0")} < del ->
  forall t, 0 <= t <= T -> distance2 {_at(n, "t")} < eps.
Proof.
  intros eps pe. destruct (confined {n} zf zp G forms margin radius minimum kept eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros {" ".join(x)} T {_hypotheses(n)} near t ht.
  assert (k : off {n} zp (path [{paths}] t) < eps); [|rewrite reads_distance in k; exact k].
  apply (h (path [{paths}]) T);
    [| intros; apply path_inside; simpl; lia | rewrite reads_distance; exact near | exact ht].
{_solves(n)}
Qed.
Print Assumptions {name}.
"""


def _growth_data(proof: Growth) -> str:
    return "\n".join([
        f"(* V grows: its rate of change is at least {2 * proof.rate} V near the point *)",
        _wrap(f"Definition V : poly := {_poly(quadratic_form(proof.form))}."),
        f"Definition direction : list Q := {_numbers(proof.direction)}.",
        f"Definition gamma : Q := {_q(proof.rate)}.\nDefinition margin : Q := {_q(proof.margin)}.",
        f"Definition radius : Q := {_q(proof.radius)}.",
        f"Definition forms : list (Q * list Q) := {_squares(proof.forms)}.",
        f"Lemma checked : check_growth {len(proof.form)} zf zp V direction radius gamma margin forms = {TRUE}.",
        "Proof. vm_cast_no_check (eq_refl true). Qed.", "",
    ])


def _drift_data(proof: Drift) -> str:
    return "\n".join([
        "(* V drifts: its rate of change is K q, with K conserved *)",
        _wrap(f"Definition V : poly := {_poly(quadratic_form(proof.form))}."),
        _wrap(f"Definition K : poly := {_poly(proof.conserved)}."),
        _wrap(f"Definition q : poly := {_poly(proof.factor)}."),
        f"Definition direction : list Q := {_numbers(proof.direction)}.",
        f"Definition radius : Q := {_q(proof.radius)}.",
        f"Lemma checked : check_drift {len(proof.form)} zf zp V direction radius K q = {TRUE}.",
        "Proof. vm_cast_no_check (eq_refl true). Qed.", "",
    ])


def _leaving_theorem(equations: Equations, theorem: str) -> str:
    n = equations.size
    x, paths, starts = _x(n), "; ".join(_x(n)), [f"p{k + 1}" for k in range(n)]
    given = {"growing": "V direction radius gamma margin forms", "drifting": "V direction radius K q"}[theorem]
    begins = " -> ".join(f"x{k + 1} 0 = p{k + 1}" for k in range(n))
    names = _hypotheses(n) + "".join(f" b{k + 1}" for k in range(n))
    return f"""Theorem equilibrium_is_unstable : exists eps, 0 < eps /\\ forall del, 0 < del ->
  exists {" ".join(starts)} : R, distance2 {" ".join(starts)} < del /\\ exists last : R,
  forall ({" ".join(x)} : R -> R) (T : R),
{_solutions(n)}
  {begins} ->
  (forall t, 0 <= t <= T -> distance2 {_at(n, "t")} <= eps) -> T <= last.
Proof.
  destruct ({theorem} {n} zf zp {given} checked) as (eps & pe & h).
  exists eps; split; [exact pe|]. intros del pd. destruct (h del pd) as (p & ins & near & last & k).
  exists {", ".join(f"(p {j}%nat)" for j in range(n))}. rewrite reads_distance in near.
  split; [exact near|]. exists last.
  intros {" ".join(x)} T {names} stays.
  apply (k (path [{paths}]) T).
  - {_solves(n).strip()}
  - intros; apply path_inside; simpl; lia.
  - intros {_cases(n)}; [{"|".join(f"exact b{j + 1}" for j in range(n))}|].
    rewrite path_beyond by (simpl; lia). rewrite ins by lia. unfold zp, entry_of. rewrite nth_overflow by (simpl; lia).
    rewrite Q2R_0; reflexivity.
  - intros t ht. rewrite reads_distance. exact (stays t ht).
Qed.
Print Assumptions equilibrium_is_unstable.
"""


def _solutions(n: int) -> str:
    """Return the hypotheses that functions solve the equations."""
    return "\n".join(f"  (forall t, 0 <= t <= T -> derivable_pt_lim x{k + 1} t (f{k + 1} {_at(n, 't')})) ->"
                     for k in range(n))


def _solves(n: int) -> str:
    steps = "\n".join(f"  {{ rewrite reads{k + 1}; exact (s{k + 1} r hr). }}" for k in range(n))
    return f"  intros {_cases(n)} r hr.\n{steps}\n  apply still_beyond; simpl; lia."


def _cases(n: int) -> str:
    """Return the pattern that splits 0, …, n − 1 from what is beyond."""
    pattern = "i"
    for _ in range(n):
        pattern = f"[|{pattern}]"
    return pattern


def _x(n: int) -> list[str]:
    return [f"x{k + 1}" for k in range(n)]


def _at(n: int, t: str) -> str:
    return " ".join(f"(x{k + 1} {t})" for k in range(n))


def _hypotheses(n: int) -> str:
    return " ".join(f"s{k + 1}" for k in range(n))


def _formula(p: fmpq_mpoly) -> str:
    terms = []
    for m, c in terms_of(p):
        factors = [f"x{k + 1}" for k, e in enumerate(m) for _ in range(e)]
        terms.append(" * ".join(factors if c == 1 and factors else [_real(c), *factors]))
    return " + ".join(terms) or "0"


def _real(x: fmpq) -> str:
    return f"({x.p})" if x.q == 1 else f"({x.p} / {x.q})"


def _q(x: fmpq) -> str:
    return f"({x.p}#{x.q})"


def _poly(p: fmpq_mpoly) -> str:
    return "[" + "; ".join(f"({_q(c)}, [{'; '.join(str(k) for k, e in enumerate(m) for _ in range(e))}]%nat)"
                           for m, c in terms_of(p)) + "]"


def _numbers(row: Sequence[fmpq]) -> str:
    return "[" + "; ".join(map(_q, row)) + "]"


def _squares(forms: Squares) -> str:
    return "[" + ";\n  ".join(f"({_q(d)}, {_numbers(row)})" for d, row in forms) + "]"


def _sum(parts: Sequence[str]) -> str:
    if not parts:
        return "[]"
    return parts[0] if len(parts) == 1 else f"add ({parts[0]}) ({_sum(parts[1:])})"


def _plain(name: str) -> str:
    """Return a name that is safe in a comment."""
    return name.replace("(*", "( *").replace("*)", "* )").replace('"', "'")


def _wrap(text: str) -> str:
    """Break a long definition after commas and sums."""
    lines, line = [], ""
    width = 116
    for word in _words(text):
        if line and len(line) + 1 + len(word) > width:
            lines.append(line)
            line = "  " + word
        else:
            line = f"{line} {word}" if line else word
    return "\n".join([*lines, line])


def _words(text: str) -> Iterable[str]:
    return text.split(" ")
