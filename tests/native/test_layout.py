"""Layouts: what they work out, and how they refuse."""

from __future__ import annotations

from typing import Any

import pytest
from proxygraph import GridError, GridLayout

FIELDS: dict[str, Any] = {"rows": 3, "columns": 4, "cell_width": 2.0, "cell_height": 5.0}


@pytest.mark.parametrize(
    ("field", "value", "expected"),
    [
        ("rows", 1, "2"),
        ("rows", 0, "2"),
        ("rows", -3, "whole number from 0"),
        ("rows", 2**31 + 1, "2147483648"),
        ("columns", 1, "2"),
        ("columns", -1, "whole number from 0"),
        ("columns", 2**64, "whole number from 0"),
        ("cell_width", 0.0, "positive"),
        ("cell_width", -1.5, "positive"),
        ("cell_width", float("nan"), "positive"),
        ("cell_height", float("inf"), "positive"),
        ("sample", "i8", "i16, u16, i32, f32, f64"),
        ("byte_order", "middle", "big, little"),
        ("offset", -1, "whole number from 0"),
        ("row_stride", 7, "takes 8"),
        ("row_stride", -8, "whole number from 0"),
        ("scale", 0.0, "other than 0"),
        ("scale", float("nan"), "finite"),
        ("value_offset", float("inf"), "finite"),
    ],
)
def test_a_bad_field_is_named_with_what_was_found_and_expected(
    field: str, value: float | str, expected: str
) -> None:
    with pytest.raises(GridError) as caught:
        GridLayout(**{**FIELDS, field: value})
    text = str(caught.value)
    assert field in text
    found = text.split(";")[0].lower()
    assert str(value).removesuffix(".0") in found
    assert expected in text


@pytest.mark.parametrize(
    "fields", [{"offset": 2**63}, {"row_stride": 2**62}, {"rows": 2**31, "columns": 2**31, "sample": "f64"}]
)
def test_grids_that_no_address_reaches_are_refused(fields: dict[str, Any]) -> None:
    with pytest.raises(GridError, match="no address"):
        GridLayout(**{**FIELDS, **fields})


@pytest.mark.parametrize("field", ["rows", "columns", "cell_width"])
def test_what_is_not_a_number_is_a_type_error(field: str) -> None:
    with pytest.raises(TypeError, match=field):
        GridLayout(**{**FIELDS, field: "many"})


@pytest.mark.parametrize(("rows", "found"), [(2**200, "above 2^127"), (-(2**200), "below -2^127")])
def test_numbers_beyond_every_type_are_named_too(rows: int, found: str) -> None:
    with pytest.raises(GridError, match=r"rows is a number ") as caught:
        GridLayout(**{**FIELDS, "rows": rows})
    assert found in str(caught.value)


def test_counts_and_bytes() -> None:
    layout = GridLayout(**FIELDS, offset=10, row_stride=20)
    assert (layout.samples, layout.triangles) == (12, 12)
    assert layout.byte_length == 10 + 2 * 20 + 8
    assert GridLayout(**FIELDS, wraps=True).triangles == 16
    assert GridLayout(**FIELDS, sample="f64").row_stride == 32


def test_a_layout_gives_back_what_it_was_given() -> None:
    given: dict[str, Any] = {
        **FIELDS,
        "sample": "i32",
        "byte_order": "little",
        "offset": 6,
        "row_stride": 18,
        "scale": 0.25,
        "value_offset": -8000.0,
        "void": -9999.0,
        "wraps": True,
    }
    layout = GridLayout(**given)
    assert {field: getattr(layout, field) for field in given} == given


def test_layouts_are_equal_by_value_and_immutable() -> None:
    assert GridLayout(**FIELDS) == GridLayout(**FIELDS)
    assert GridLayout(**FIELDS) != GridLayout(**FIELDS, wraps=True)
    with pytest.raises(AttributeError):
        GridLayout(**FIELDS).rows = 5  # type: ignore[misc]
