"""The checks of usdchecker: usd-core has its rules, but not the program."""

from __future__ import annotations

import os
from typing import Any

from ._pxr import Usd, stage_of


def complaints(source: str | os.PathLike[str] | Any) -> list[str]:
    """Errors, failed checks and warnings of all validators of usd-core; empty if
    usdchecker would pass."""
    stage = stage_of(source)
    try:
        from pxr import UsdValidation
    except ImportError:  # usd-core before 25
        return _by_compliance_checker(stage)
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return [fault.GetErrorAsString() for fault in context.Validate(stage)]


def _by_compliance_checker(stage: Usd.Stage) -> list[str]:
    from pxr import UsdUtils

    checker = UsdUtils.ComplianceChecker(skipVariants=False)
    checker.CheckCompliance(stage.GetRootLayer().realPath)
    return [*checker.GetErrors(), *checker.GetFailedChecks(), *checker.GetWarnings()]
