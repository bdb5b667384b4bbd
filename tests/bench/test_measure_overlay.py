"""The bench of the overlay counts every frame."""

from __future__ import annotations

import numpy as np
import pytest

from tests.bench.measure_overlay import figures


def test_figures_are_of_all_frames() -> None:
    wall = np.array([50.0, *[0.5] * 197, 2.0, 2.0])
    told = figures(wall, wall / 2.0)
    assert told["overlay_draw_frames"] == 200
    assert told["overlay_draw_ms_first"] == 50.0
    assert told["overlay_draw_ms_median"] == 0.5
    assert told["overlay_draw_ms_p99"] == pytest.approx(2.0)
    assert told["overlay_draw_processor_ms_p99"] == pytest.approx(1.0)
