//! Grids and their layouts.

use crate::decode::{Progress, decode_refusal};
use crate::errors::grid_error;
use crate::numbers::Whole;
use pyo3::buffer::PyUntypedBuffer;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use std::sync::Arc;
use surface::{ByteOrder, SampleType};

/// Where the samples of a row-major grid lie, and what they mean.
#[pyclass(frozen, eq, module = "proxygraph")]
#[derive(Clone, PartialEq)]
pub struct GridLayout {
    layout: surface::GridLayout,
}

const SAMPLES: [(&str, SampleType); 5] = [
    ("i16", SampleType::I16),
    ("u16", SampleType::U16),
    ("i32", SampleType::I32),
    ("f32", SampleType::F32),
    ("f64", SampleType::F64),
];
const ORDERS: [(&str, ByteOrder); 2] = [("big", ByteOrder::Big), ("little", ByteOrder::Little)];

impl GridLayout {
    /// The layout, as the other crates know it.
    pub fn plain(&self) -> surface::GridLayout {
        self.layout
    }
}

#[pymethods]
impl GridLayout {
    #[new]
    #[pyo3(signature = (rows, columns, *, cell_width, cell_height, sample="i16", byte_order="big",
        offset=Whole(0), row_stride=None, scale=1.0, value_offset=0.0, void=None, wraps=false),
        text_signature = "(rows, columns, *, cell_width, cell_height, sample='i16', \
        byte_order='big', offset=0, row_stride=None, scale=1.0, value_offset=0.0, void=None, \
        wraps=False)")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of the Python contract")]
    fn new(
        rows: Whole,
        columns: Whole,
        cell_width: f64,
        cell_height: f64,
        sample: &str,
        byte_order: &str,
        offset: Whole,
        row_stride: Option<Whole>,
        scale: f64,
        value_offset: f64,
        void: Option<f64>,
        wraps: bool,
    ) -> PyResult<Self> {
        let rows = rows.unsigned("rows").map_err(grid_error)?;
        let columns = columns.unsigned("columns").map_err(grid_error)?;
        let sample = named("sample", sample, &SAMPLES)?;
        let order = named("byte_order", byte_order, &ORDERS)?;
        let packed =
            surface::GridLayout::packed(rows, columns, cell_width, cell_height, sample, order);
        let mut layout = packed
            .and_then(|layout| layout.with_values(scale, value_offset))
            .map_err(grid_error)?
            .with_void(void)
            .with_wrap(wraps);
        let offset = offset.unsigned("offset").map_err(grid_error)?;
        layout = layout.with_offset(offset).map_err(grid_error)?;
        if let Some(stride) = row_stride {
            let stride = stride.unsigned("row_stride").map_err(grid_error)?;
            layout = layout.with_row_stride(stride).map_err(grid_error)?;
        }
        Ok(Self { layout })
    }

    #[getter]
    fn rows(&self) -> u32 {
        self.layout.rows()
    }

    #[getter]
    fn columns(&self) -> u32 {
        self.layout.columns()
    }

    #[getter]
    fn cell_width(&self) -> f64 {
        self.layout.cell_width()
    }

    #[getter]
    fn cell_height(&self) -> f64 {
        self.layout.cell_height()
    }

    #[getter]
    fn sample(&self) -> &'static str {
        sample_name(self.layout.sample())
    }

    #[getter]
    fn byte_order(&self) -> &'static str {
        byte_order_name(self.layout.byte_order())
    }

    #[getter]
    fn offset(&self) -> u64 {
        self.layout.offset()
    }

    #[getter]
    fn row_stride(&self) -> u64 {
        self.layout.row_stride()
    }

    #[getter]
    fn scale(&self) -> f64 {
        self.layout.scale()
    }

    #[getter]
    fn value_offset(&self) -> f64 {
        self.layout.value_offset()
    }

    #[getter]
    fn void(&self) -> Option<f64> {
        self.layout.void()
    }

    #[getter]
    fn wraps(&self) -> bool {
        self.layout.wraps()
    }

    #[getter]
    fn samples(&self) -> u64 {
        self.layout.samples()
    }

    #[getter]
    fn triangles(&self) -> u64 {
        self.layout.triangles()
    }

    #[getter]
    fn byte_length(&self) -> u64 {
        self.layout.byte_length()
    }

    fn __repr__(&self) -> String {
        format!(
            "GridLayout({}, {}, cell_width={}, cell_height={}, sample='{}', byte_order='{}', wraps={})",
            self.rows(),
            self.columns(),
            self.cell_width(),
            self.cell_height(),
            self.sample(),
            self.byte_order(),
            if self.wraps() { "True" } else { "False" },
        )
    }
}

/// The lowest and the highest sample of a grid.
#[pyclass(frozen, module = "proxygraph")]
pub struct GridRange {
    range: surface::GridRange,
}

#[pymethods]
impl GridRange {
    #[getter]
    fn minimum(&self) -> f64 {
        self.range.minimum
    }

    #[getter]
    fn minimum_cell(&self) -> (u32, u32) {
        self.range.minimum_cell
    }

    #[getter]
    fn maximum(&self) -> f64 {
        self.range.maximum
    }

    #[getter]
    fn maximum_cell(&self) -> (u32, u32) {
        self.range.maximum_cell
    }

    #[getter]
    fn voids(&self) -> u64 {
        self.range.voids
    }
}

/// An elevation grid whose samples stay where they lie.
#[pyclass(frozen, module = "proxygraph")]
pub struct Grid {
    grid: Arc<surface::Grid>,
}

impl Grid {
    /// A grid from a decoder.
    pub fn of(grid: surface::Grid) -> Self {
        Self { grid: Arc::new(grid) }
    }

    pub fn shared(&self) -> Arc<surface::Grid> {
        Arc::clone(&self.grid)
    }
}

#[pymethods]
impl Grid {
    #[staticmethod]
    fn open(py: Python<'_>, path: PathBuf, layout: &GridLayout) -> PyResult<Self> {
        let grid = py.detach(|| surface::Grid::open(&path, layout.layout)).map_err(grid_error)?;
        Ok(Self { grid: Arc::new(grid) })
    }

    #[staticmethod]
    fn from_buffer(buffer: &Bound<'_, PyAny>, layout: &GridLayout) -> PyResult<Self> {
        let buffer = PyUntypedBuffer::get(buffer)?;
        if !buffer.is_c_contiguous() {
            return Err(grid_error("the buffer is not C-contiguous; pass a copy that is"));
        }
        let (address, length) = (buffer.buf_ptr().cast::<u8>(), buffer.len_bytes());
        // SAFETY: the exporter keeps the memory in place until the buffer is released, which
        // happens when the grid drops it.
        let grid = unsafe {
            surface::Grid::from_foreign(address, length, Box::new(buffer), layout.layout)
        };
        Ok(Self { grid: Arc::new(grid.map_err(grid_error)?) })
    }

    #[getter]
    fn layout(&self) -> GridLayout {
        GridLayout { layout: *self.grid.layout() }
    }

    #[getter]
    fn damaged(&self) -> bool {
        self.grid.look_at_file();
        self.grid.damaged()
    }

    fn elevation(&self, column: Whole, row: Whole) -> Option<f64> {
        self.grid.elevation(column.fitting()?, row.fitting()?)
    }

    fn elevation_at(&self, east: f64, north: f64) -> Option<f64> {
        let point = self.grid.layout().grid_point([east, north, 0.0]);
        if point.is_finite() { self.grid.surface_elevation(&point) } else { None }
    }

    fn elevations<'py>(
        &self,
        py: Python<'py>,
        columns: Vec<i64>,
        rows: Vec<i64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let doubles = py.detach(|| {
            let read = |(column, row)| self.grid.elevation(column, row).unwrap_or(f64::NAN);
            let cells =
                rows.iter().flat_map(|&row| columns.iter().map(move |&column| (column, row)));
            cells.map(read).collect::<Vec<f64>>()
        });
        memoryview_of_doubles(py, &doubles)
    }

    fn range(&self, py: Python<'_>) -> Option<GridRange> {
        py.detach(|| self.grid.range()).map(|range| GridRange { range })
    }

    #[pyo3(signature = (progress=None))]
    fn filled(&self, py: Python<'_>, progress: Option<&Progress>) -> PyResult<Self> {
        let unseen = Progress::default();
        let progress = progress.unwrap_or(&unseen).shared();
        let grid = py.detach(|| ::decode::fill(&self.grid, progress)).map_err(decode_refusal)?;
        Ok(Self::of(grid))
    }
}

/// A memoryview of format `d`.
pub fn memoryview_of_doubles<'py>(py: Python<'py>, doubles: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    let bytes = PyBytes::new_with(py, size_of_val(doubles), |bytes| {
        for (place, value) in bytes.chunks_exact_mut(size_of::<f64>()).zip(doubles) {
            place.copy_from_slice(&value.to_ne_bytes());
        }
        Ok(())
    })?;
    py.import("builtins")?.getattr("memoryview")?.call1((bytes,))?.call_method1("cast", ("d",))
}

fn named<T: Copy>(field: &str, name: &str, known: &[(&'static str, T)]) -> PyResult<T> {
    match known.iter().find(|(known_name, _)| *known_name == name) {
        Some((_, value)) => Ok(*value),
        None => {
            let names: Vec<_> = known.iter().map(|(known_name, _)| *known_name).collect();
            let names = names.join(", ");
            Err(grid_error(format!("{field} is '{name}'; expected one of {names}")))
        }
    }
}

/// The byte order that the contract calls so.
pub fn byte_order_named(name: &str) -> PyResult<ByteOrder> {
    named("byte_order", name, &ORDERS)
}

/// What the contract calls a sample type.
pub fn sample_name(sample: SampleType) -> &'static str {
    name_of(sample, &SAMPLES)
}

/// What the contract calls a byte order.
pub fn byte_order_name(order: ByteOrder) -> &'static str {
    name_of(order, &ORDERS)
}

fn name_of<T: PartialEq>(value: T, known: &[(&'static str, T)]) -> &'static str {
    known.iter().find(|(_, known_value)| *known_value == value).map_or("", |(name, _)| name)
}
