"""What usdchecker says of a file: usd-core comes without the program, but has its rules."""

from __future__ import annotations

import os
from typing import Any

from ._pxr import Usd, stage_of


def complaints(source: str | os.PathLike[str] | Any) -> list[str]:
    """Errors, failed checks and warnings of every validator that usd-core knows; none:
    usdchecker passes."""
    stage = stage_of(source)
    try:
        from pxr import UsdValidation
    except ImportError:  # before 25: the checks in Python
        return _by_compliance_checker(stage)
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return [fault.GetErrorAsString() for fault in context.Validate(stage)]


def _by_compliance_checker(stage: Usd.Stage) -> list[str]:
    from pxr import UsdUtils

    checker = UsdUtils.ComplianceChecker(skipVariants=False)
    checker.CheckCompliance(stage.GetRootLayer().realPath)
    return [*checker.GetErrors(), *checker.GetFailedChecks(), *checker.GetWarnings()]
