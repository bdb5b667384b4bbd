//! Rows of many numbers as Python sees them: a column of doubles for each number, by its name.

use crate::grid::memoryview_of_doubles;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// A column's name and how its value is read from a row.
pub type Column<Row> = (&'static str, fn(&Row) -> f64);

/// The names, in their order.
pub fn names<Row>(py: Python<'_>, columns: &[Column<Row>]) -> PyResult<Py<PyTuple>> {
    Ok(PyTuple::new(py, columns.iter().map(|(name, _)| *name))?.unbind())
}

/// One value a row, as a `memoryview` of doubles.
///
/// # Errors
///
/// `KeyError` for a name that is none of them; it says that `owner` has no such column.
pub fn column<'py, 'row, Row: 'row>(
    py: Python<'py>,
    owner: &str,
    columns: &[Column<Row>],
    rows: impl Iterator<Item = &'row Row>,
    name: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let Some((_, value)) = columns.iter().find(|(known, _)| *known == name) else {
        return Err(PyKeyError::new_err(format!("'{name}' is not one of {owner}.columns")));
    };
    let values: Vec<f64> = rows.map(value).collect();
    memoryview_of_doubles(py, &values)
}
