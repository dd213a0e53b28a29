"""``polhode report SPEC --proof DIR``: each verdict of a report as a file that the prover Rocq checks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from polhode.analysis.certificate import Certificate
from polhode.errors import InvalidInput
from polhode.formats.paths import write_together
from polhode.proving.verdicts.rocq import THEORY, write_proof
from polhode.reports.answer import Table
from polhode.reports.report import Report


def write_proofs(report: Report, folder: Path) -> tuple[list[str], list[str]]:
    """Write a proof of each verdict of a report that has one.

    Returns:
        The files, that of the theory among them, and a note for each verdict without a proof, with the reason.

    Raises:
        InvalidInput: for a report without verdicts, and where files cannot be written.
    """
    certificates = list(_certificates(report))
    if not certificates:
        raise InvalidInput(f"--proof: a report of kind {report.kind} has no verdicts to prove. Leave it out.")
    notes = []
    with write_together(folder) as draft:
        for name, certificate in certificates:
            try:
                rational = certificate.as_rational()
                write_proof(rational, draft / f"{name}.v")
                if moved := rational.equations.moved:
                    notes.append(f"{name}: proved of an exact equilibrium, {float(moved):.1e} from the report's point.")
            except InvalidInput as error:
                notes.append(f"{name}: no proof is written; {error}")
        files = sorted(path.name for path in draft.iterdir())
    proofs = [name for name in files if name != THEORY]
    if proofs:
        commands = " && ".join(f"coqc -Q . Polhode {name}" for name in (THEORY, proofs[0]))
        notes.append(f"Rocq, or Coq from 8.16 on, checks a proof by `{commands}` in {folder}.")
    return [str(folder / name) for name in (THEORY, *proofs) if name in files], notes


def _certificates(report: Report) -> Iterator[tuple[str, Certificate]]:
    """Yield the certificates of a report with names for their files."""
    for part in report.answers:
        if isinstance(part, Table):
            for number, row in enumerate(part.rows, start=1):
                if isinstance(row.get("certificate"), Certificate):
                    key = str(row[part.key]) if part.key else str(number)
                    yield _as_name(f"{part.name or 'verdict'}_{key}"), row["certificate"]
        else:
            for answer in part.answers:
                if isinstance(answer.value, Certificate):
                    yield _as_name(answer.name.removesuffix(".certificate")), answer.value


def _as_name(text: str) -> str:
    """Return a text as the name of a module: letters, digits and underscores."""
    return re.sub(r"\W", "_", text, flags=re.ASCII).strip("_") or "verdict"
