"""What an operator gives back to Blender."""

from __future__ import annotations

from typing import Literal

OperatorStatus = set[Literal["RUNNING_MODAL", "CANCELLED", "FINISHED", "PASS_THROUGH", "INTERFACE"]]
