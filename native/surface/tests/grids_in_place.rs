//! Grids over files and memory: nothing is copied, and nothing that happens to the bytes harms the
//! process.
#![cfg(unix)]

use std::fs::File;
use std::path::PathBuf;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, SampleType};

/// A file that is gone when the test ends.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str, bytes: &[u8]) -> Self {
        let path = std::env::temp_dir().join(format!("{name}-{}", std::process::id()));
        std::fs::write(&path, bytes).unwrap();
        Self(path)
    }

    fn set_length(&self, length: u64) {
        File::options().write(true).open(&self.0).unwrap().set_len(length).unwrap();
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

fn layout(rows: u64, columns: u64, sample: SampleType) -> GridLayout {
    GridLayout::packed(rows, columns, 1.0, 1.0, sample, ByteOrder::Big).unwrap()
}

#[test]
fn offset_stride_scale_and_void_are_read_in_place() {
    // Two bytes of header, rows of three samples padded to eight bytes.
    let rows: [[i16; 4]; 2] = [[1, 2, -9999, 77], [4, 5, 6, 77]];
    let mut bytes = vec![0xff, 0xff];
    bytes.extend(rows.iter().flatten().flat_map(|sample| sample.to_be_bytes()));
    let layout = layout(2, 3, SampleType::I16)
        .with_offset(2)
        .and_then(|layout| layout.with_row_stride(8))
        .and_then(|layout| layout.with_values(0.25, -8000.0))
        .unwrap()
        .with_void(Some(-9999.0));
    let grid = Grid::from_vec(bytes, layout).unwrap();
    assert_eq!(grid.elevation(1, 1), Some(5.0 * 0.25 - 8000.0));
    assert_eq!(grid.elevation(2, 0), None);
    assert_eq!(grid.elevation(3, 1), None, "off the map, not the padding");
    let range = grid.range().unwrap();
    assert_eq!((range.minimum_cell, range.maximum_cell, range.voids), ((0, 0), (2, 1), 1));
}

#[test]
fn an_address_is_that_of_the_sample() {
    let bytes: Vec<u8> = (0..20).collect();
    let layout = layout(2, 3, SampleType::U16)
        .with_offset(2)
        .and_then(|layout| layout.with_row_stride(8))
        .unwrap();
    let grid = Grid::from_vec(bytes, layout.with_wrap(true)).unwrap();
    let first = grid.sample_address(0, 0).unwrap() as usize;
    for (column, row, offset) in [(0, 0, 0), (2, 0, 4), (1, 1, 10), (4, 1, 10), (-2, 1, 10)] {
        let address = grid.sample_address(column, row).unwrap();
        assert_eq!(address as usize - first, offset, "({column}, {row})");
        // SAFETY: the bytes are the grid's, which is still there.
        let found = unsafe { address.cast::<[u8; 2]>().read() };
        let expected = grid.elevation(column, row).unwrap();
        assert_eq!(f64::from(u16::from_be_bytes(found)), expected);
    }
    assert_eq!(grid.sample_address(0, 2), None);
    let island = Grid::from_vec(vec![0; 20], layout).unwrap();
    assert_eq!(island.sample_address(3, 0), None);
    assert_eq!(island.sample_address(-1, 0), None);
}

#[test]
fn infinite_and_nan_samples_are_void() {
    let samples = [1.0f32, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let bytes = samples.iter().flat_map(|sample| sample.to_be_bytes()).collect();
    let grid = Grid::from_vec(bytes, layout(2, 2, SampleType::F32)).unwrap();
    assert_eq!(grid.range().unwrap().voids, 3);
    let nothing = Grid::from_vec(vec![0; 8], layout(2, 2, SampleType::I16).with_void(Some(0.0)));
    assert_eq!(nothing.unwrap().range(), None);
}

#[test]
fn surface_elevation_lies_on_the_diagonal_that_touch_uses() {
    // Only the south-west sample is high: the north-east half of the cell is flat.
    let bytes = [0i16, 0, 8, 0].iter().flat_map(|sample| sample.to_be_bytes()).collect();
    let grid = Grid::from_vec(bytes, layout(2, 2, SampleType::I16)).unwrap();
    assert_eq!(grid.surface_elevation(&GridPoint::new(0.75, 0.25, 0.0)), Some(0.0));
    assert_eq!(grid.surface_elevation(&GridPoint::new(0.25, 0.75, 0.0)), Some(4.0));
    assert_eq!(grid.surface_elevation(&GridPoint::new(0.5, 0.5, 0.0)), Some(0.0));
    assert_eq!(grid.surface_elevation(&GridPoint::new(1.0, 1.0, 0.0)), Some(0.0));
    assert_eq!(grid.surface_elevation(&GridPoint::new(1.01, 1.0, 0.0)), None);
}

#[test]
fn short_missing_and_odd_files_are_refused_by_name() {
    let short = Scratch::new("haptic-terrain-short", &[0; 17]);
    let error = Grid::open(&short.0, layout(3, 3, SampleType::I16)).unwrap_err().to_string();
    assert!(error.contains("haptic-terrain-short") && error.contains("17 bytes"), "{error}");
    assert!(error.contains("need 18"), "{error}");
    let missing = Grid::open("no-such-file.img".as_ref(), layout(2, 2, SampleType::I16));
    assert!(missing.unwrap_err().to_string().contains("no-such-file.img"));
    let folder = Grid::open(&std::env::temp_dir(), layout(2, 2, SampleType::I16));
    assert!(folder.unwrap_err().to_string().contains("not a file"));
    assert!(Grid::from_vec(vec![0; 7], layout(2, 2, SampleType::I16)).is_err());
}

#[test]
fn a_file_cut_while_mapped_marks_its_grid_and_reads_as_zero() {
    let samples: Vec<u8> = (0..1 << 19).flat_map(|_| 7i16.to_be_bytes()).collect();
    let cut = Scratch::new("haptic-terrain-cut", &samples);
    let whole = Scratch::new("haptic-terrain-whole", &samples);
    let shape = layout(512, 1024, SampleType::I16);
    let grid = Grid::open(&cut.0, shape).unwrap();
    let other = Grid::open(&whole.0, shape).unwrap();
    assert_eq!(grid.elevation(1000, 500), Some(7.0));
    cut.set_length(4096);
    assert!(!grid.damaged(), "nothing was read yet");
    assert_eq!(grid.elevation(0, 0), Some(7.0), "what is left stays readable");
    assert_eq!(grid.elevation(1000, 500), Some(0.0));
    assert!(grid.damaged());
    assert!(!other.damaged());
    assert_eq!(other.elevation(1000, 500), Some(7.0));
}

#[test]
fn a_slot_of_the_guard_is_free_again_after_its_grid() {
    let file = Scratch::new("haptic-terrain-slots", &[0; 8]);
    let shape = layout(2, 2, SampleType::I16);
    for _ in 0..3 {
        let grids: Vec<_> = (0..200).map(|_| Grid::open(&file.0, shape).unwrap()).collect();
        assert!(grids.iter().all(|grid| !grid.damaged()));
    }
}
