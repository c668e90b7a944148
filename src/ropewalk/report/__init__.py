"""The student report, claim by claim: what it says, what the simulator does, what theory says."""

from ropewalk.report.claims import CLAIMS, claim
from ropewalk.report.outcome import Claim, Number, Outcome, Part, Verdict
from ropewalk.report.page import write_report

__all__ = ["CLAIMS", "Claim", "Number", "Outcome", "Part", "Verdict", "claim", "write_report"]
