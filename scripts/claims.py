# SPDX-License-Identifier: MIT
"""A published number beside the emulator's, and the verdict on it.

    verdict             when
    inconsistent        other numbers of the same paper give something else (`implied`)
    not emulated        there is nothing to measure; `because` says why
    reproduced          the measured value lies within the tolerance of the published one
    differs             it does not; `because` says why

The verdict follows from the numbers alone; `because` is only text.
"""

from dataclasses import dataclass
from typing import Any, Callable

from measuring import EmulatorError

REPRODUCED, DIFFERS, INCONSISTENT, NOT_EMULATED, FAILED = VERDICTS = (
    "reproduced", "differs", "the paper is inconsistent", "not emulated", "could not be measured")


@dataclass(frozen=True)
class Tolerance:
    """So many per cent of the published value, or so much in its unit."""

    percent: float = 0
    margin: float = 0

    def accepts(self, value, published):
        if isinstance(published, str) or isinstance(value, str):
            return value == published
        low, high = published if isinstance(published, tuple) else (published, published)
        return (low is None or value >= low - self.of(low)) and (high is None or value <= high + self.of(high))

    def of(self, published):
        return max(self.margin, abs(published) * self.percent / 100) + 1e-9 * abs(published)

    def __str__(self):
        return f"{self.percent:g} %" if self.percent else f"{self.margin:g}" if self.margin else "exact"


EXACT = Tolerance()


@dataclass(frozen=True)
class Claim:
    """`published` is a number, a text, or a range (low, high) of which one end may be None. `measure` gets a CachedEmulator and returns a number
    or a text. `implied` is what other numbers of the paper give for the same thing, a value or a range; `implied_by` says which numbers, `slack`
    how far they may be off (else `tolerance`). `because` explains a difference, `note` is shown whatever the verdict."""

    source: str
    what: str
    published: Any
    measure: Callable | None = None
    unit: str = ""
    tolerance: Tolerance = EXACT
    because: str = ""
    implied: Any = None
    implied_by: str = ""
    slack: Tolerance | None = None
    note: str = ""


@dataclass(frozen=True)
class Finding:
    claim: Claim
    measured: Any
    verdict: str
    because: str


def contradicts_itself(claim):
    if claim.implied is None:
        return False
    slack = claim.slack or claim.tolerance
    if isinstance(claim.implied, tuple):
        return not slack.accepts(claim.published, claim.implied)
    return not slack.accepts(claim.implied, claim.published)


def verdict_on(claim, measured):
    if contradicts_itself(claim):
        return INCONSISTENT
    if measured is None:
        return NOT_EMULATED
    return REPRODUCED if claim.tolerance.accepts(measured, claim.published) else DIFFERS


def reason(claim, verdict):
    parts = [claim.note] if claim.note else []
    if verdict == INCONSISTENT:
        parts.append(f"{claim.implied_by}: {shown(claim.implied)}.")
    if claim.because and verdict != REPRODUCED:
        parts.append(claim.because)
    elif verdict == DIFFERS:
        parts.append("Unexplained.")
    return " ".join(parts)


def examine(claim, emulator):
    """Measures and judges. A run that fails is a finding, too."""
    try:
        measured = claim.measure(emulator) if claim.measure else None
    except EmulatorError as error:
        return Finding(claim, None, FAILED, str(error))
    verdict = verdict_on(claim, measured)
    return Finding(claim, measured, verdict, reason(claim, verdict))


def shown(value):
    """A number as it was typed, or to six digits; a range in words."""
    if value is None:
        return "-"
    if isinstance(value, tuple):
        low, high = value
        return f"at least {shown(low)}" if high is None else f"at most {shown(high)}" if low is None else f"{shown(low)} to {shown(high)}"
    if isinstance(value, float):
        typed = f"{value:.8g}"
        return f"{value:,.0f}" if abs(value) >= 1e5 else typed if float(typed) == value else f"{value:.6g}"
    return f"{value:,}" if isinstance(value, int) and abs(value) >= 10000 else str(value)
