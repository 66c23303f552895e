"""Many runs of one scenario: designed, run on threads or a cluster, kept in Zarr."""

from typing import TYPE_CHECKING

from ..lazy import lazily

if TYPE_CHECKING:
    from .run import run_ensemble

__all__ = ["run_ensemble"]
__getattr__, __dir__ = lazily(__name__, {"run_ensemble": "run"})
