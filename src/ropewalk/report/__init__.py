"""The student report, claim by claim: what it says, what the simulator does, what theory says."""

from ropewalk.report.outcome import Claim, Number, Outcome, Part, Verdict
from ropewalk.report.page import write_report
from ropewalk.report.registry import CLAIMS, claim

__all__ = ["CLAIMS", "Claim", "Number", "Outcome", "Part", "Verdict", "claim", "write_report"]
