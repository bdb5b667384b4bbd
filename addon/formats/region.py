"""A rectangle of a grid's samples."""

from __future__ import annotations

from dataclasses import dataclass

from proxygraph import GridLayout

SAMPLE_BYTES = {"i16": 2, "u16": 2, "i32": 4, "f32": 4, "f64": 8}


@dataclass(frozen=True)
class Region:
    """Which samples are meant; on a grid that wraps, columns may run on beyond the last one."""

    first_column: int
    first_row: int
    columns: int
    rows: int

    @staticmethod
    def whole(columns: int, rows: int) -> Region:
        """All samples."""
        return Region(0, 0, columns, rows)

    def check_on(self, layout: GridLayout) -> None:
        """Refuse what is not on the grid.

        Raises:
            ValueError: in words.
        """
        last_column = layout.columns - 1 + (layout.columns if layout.wraps else 0)
        fits = (
            0 <= self.first_column < layout.columns
            and self.first_column + self.columns - 1 <= last_column
            and 2 <= self.columns <= layout.columns
            and self.first_row >= 0
            and self.first_row + self.rows <= layout.rows
            and self.rows >= 2
        )
        if not fits:
            raise ValueError(
                f"region: found {self.columns} columns from {self.first_column} and {self.rows} rows from "
                f"{self.first_row}, expected at least 2 of each within {layout.columns} x {layout.rows}"
            )

    def mapped(self, layout: GridLayout, cell_width: float, cell_height: float) -> GridLayout:
        """The region's samples where the whole grid's lie."""
        size = SAMPLE_BYTES[layout.sample]
        return GridLayout(
            self.rows,
            self.columns,
            cell_width=cell_width,
            cell_height=cell_height,
            sample=layout.sample,
            byte_order=layout.byte_order,
            offset=layout.offset + self.first_row * layout.row_stride + self.first_column * size,
            row_stride=layout.row_stride,
            scale=layout.scale,
            value_offset=layout.value_offset,
            void=layout.void,
            wraps=layout.wraps and self.columns == layout.columns,
        )

    def packed(self, layout: GridLayout, cell_width: float, cell_height: float) -> GridLayout:
        """The region's samples brought together, row after row from byte 0, in the same type."""
        return GridLayout(
            self.rows,
            self.columns,
            cell_width=cell_width,
            cell_height=cell_height,
            sample=layout.sample,
            byte_order=layout.byte_order,
            scale=layout.scale,
            value_offset=layout.value_offset,
            void=layout.void,
            wraps=layout.wraps and self.columns == layout.columns,
        )
