//! GeoTIFF files that the tests write: what is read of them, and what is refused.

mod common;

use common::random::Random;
use common::tiff_bytes::TiffBytes;
use decode::geotiff::{GeoTiff, Window};
use decode::{DecodeError, Progress};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};
use surface::{ByteOrder, Grid, GridLayout};

/// A file that is removed at the end of its test.
struct Kept(PathBuf);

impl Drop for Kept {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

fn keep(bytes: &[u8]) -> Kept {
    static NUMBER: AtomicU32 = AtomicU32::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let name = format!("decode-geotiff-{}-{number}.tif", std::process::id());
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, bytes).unwrap();
    Kept(path)
}

/// The sample of a place: small enough for 8 bits, different from its neighbours.
fn sample(column: u64, row: u64) -> u64 {
    (column * 3 + row * 7) % 100
}

fn open(file: &TiffBytes) -> (Kept, GeoTiff) {
    let kept = keep(&file.bytes(sample).0);
    let tiff = GeoTiff::open(&kept.0).unwrap();
    (kept, tiff)
}

fn refusal(file: &TiffBytes) -> DecodeError {
    GeoTiff::open(&keep(&file.bytes(sample).0).0).unwrap_err()
}

fn field(error: &DecodeError) -> &str {
    match error {
        DecodeError::Wrong { field, .. } => field,
        other => panic!("{other}"),
    }
}

fn layout(tiff: &GeoTiff, columns: u32, rows: u32) -> GridLayout {
    let stored = tiff.stored().decoded();
    GridLayout::packed(rows.into(), columns.into(), 1.0, 1.0, stored, ByteOrder::Little).unwrap()
}

fn window(first_column: u32, first_row: u32) -> Window {
    Window { first_column, first_row, south_up: false, fill: 0.0 }
}

fn decode_whole(tiff: &GeoTiff) -> Result<Grid, DecodeError> {
    tiff.decode(layout(tiff, tiff.columns(), tiff.rows()), &window(0, 0), None, &Progress::new())
}

/// What the stored bits of a sample mean in a format of whole numbers, or of floating point ones.
fn height(format: (u64, u64), bits: u64) -> f64 {
    match format {
        (3, 32) => f64::from(f32::from_bits(bits as u32)),
        (3, _) => f64::from_bits(bits),
        _ => bits as f64,
    }
}

#[test]
fn whole_numbers_of_every_kind_come_out_as_they_went_in() {
    for compression in [1, 5, 8, 32946, 32773] {
        for tile in [None, Some((4, 4)), Some((16, 16))] {
            for (order, is_big) in [(ByteOrder::Big, true), (ByteOrder::Little, false)] {
                for format in [(1, 8), (2, 8), (1, 16), (2, 16), (1, 32), (2, 32), (3, 32), (3, 64)]
                {
                    for bands in [1, 3] {
                        let file = TiffBytes {
                            order,
                            is_big,
                            format,
                            bands,
                            compression,
                            tile,
                            columns: 9,
                            rows: 7,
                            ..Default::default()
                        };
                        let (_kept, tiff) = open(&file);
                        let grid = decode_whole(&tiff).unwrap();
                        for row in 0..7 {
                            for column in 0..9 {
                                let expected = height(format, sample(column, row));
                                let found = grid.elevation(column as i64, row as i64);
                                assert_eq!(found, Some(expected), "{file:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn every_window_is_the_same_part_of_the_whole() {
    let mut random = Random(5);
    let file = TiffBytes {
        columns: 37,
        rows: 29,
        compression: 8,
        tile: Some((8, 6)),
        ..Default::default()
    };
    let (_kept, tiff) = open(&file);
    for _ in 0..300 {
        let columns = 2 + random.below(36) as u32;
        let rows = 2 + random.below(28) as u32;
        let first_column = random.below(37) as u32;
        let first_row = random.below(u64::from(30 - rows)) as u32;
        let south_up = random.one(&[false, true]);
        let window = Window { first_column, first_row, south_up, fill: 0.0 };
        let grid =
            tiff.decode(layout(&tiff, columns, rows), &window, None, &Progress::new()).unwrap();
        for row in 0..rows {
            for column in 0..columns {
                let file_row = if south_up { 28 - first_row - row } else { first_row + row };
                let file_column = (first_column + column) % 37;
                let expected = sample(file_column.into(), file_row.into()) as f64;
                assert_eq!(grid.elevation(column.into(), row.into()), Some(expected));
            }
        }
    }
}

#[test]
fn plain_strips_are_used_in_place_and_others_are_not() {
    let (_kept, tiff) = open(&TiffBytes { order: ByteOrder::Big, ..Default::default() });
    let place = tiff.in_place().unwrap();
    assert_eq!((place.offset, place.row_stride), (8, 10));
    assert_eq!(place.byte_order, ByteOrder::Big);
    for other in [
        TiffBytes { compression: 8, ..Default::default() },
        TiffBytes { bands: 2, ..Default::default() },
        TiffBytes { tile: Some((4, 4)), ..Default::default() },
        TiffBytes { format: (1, 8), ..Default::default() },
        TiffBytes { tags: vec![(273, 4, vec![8, 48, 28])], ..Default::default() },
    ] {
        assert_eq!(open(&other).1.in_place(), None, "{other:?}");
    }
}

#[test]
fn strips_without_lengths_are_read_where_nothing_else_can_be_meant() {
    let plain = TiffBytes { tags: vec![(279, 4, vec![0, 0, 0])], ..Default::default() };
    assert_eq!(decode_whole(&open(&plain).1).unwrap().elevation(0, 0), Some(0.0));
    let (mut bytes, directory) =
        TiffBytes { compression: 8, strip_rows: 6, ..Default::default() }.bytes(sample);
    let entry = bytes[directory..].windows(2).position(|tag| tag == 279_u16.to_le_bytes()).unwrap();
    bytes[directory + entry] = 0xff; // another tag
    let kept = keep(&bytes);
    let tiff = GeoTiff::open(&kept.0).unwrap();
    assert_eq!(decode_whole(&tiff).unwrap().elevation(4, 5), Some(sample(4, 5) as f64));
}

#[test]
fn chunks_that_were_left_out_have_the_fill_value() {
    let file = TiffBytes {
        tags: vec![(273, 4, vec![8, 0, 48]), (279, 4, vec![20, 0, 20])],
        ..Default::default()
    };
    let (_kept, tiff) = open(&file);
    assert_eq!(tiff.in_place(), None);
    let window = Window { fill: -9999.0, ..window(0, 0) };
    let grid = tiff.decode(layout(&tiff, 5, 6), &window, None, &Progress::new()).unwrap();
    assert_eq!(grid.elevation(1, 1), Some(sample(1, 1) as f64));
    assert_eq!(grid.elevation(1, 2), Some(-9999.0));
    assert_eq!(grid.elevation(1, 5), Some(sample(1, 5) as f64));
}

#[test]
fn sizes_beyond_what_the_file_can_hold_are_refused_before_anything_is_allocated() {
    for compression in [1, 5, 8, 32773] {
        let huge = u64::from(u32::MAX);
        let file = TiffBytes {
            compression,
            tags: vec![(256, 4, vec![huge]), (257, 4, vec![huge]), (278, 4, vec![huge])],
            ..Default::default()
        };
        assert_eq!(field(&refusal(&file)), "row of samples", "{compression}");
        let high = TiffBytes {
            compression,
            tags: vec![(257, 4, vec![huge]), (278, 4, vec![huge])],
            ..Default::default()
        };
        assert!(field(&refusal(&high)).starts_with("strip 0"), "{compression}");
    }
    let many_strips = TiffBytes { tags: vec![(257, 4, vec![1 << 31])], ..Default::default() };
    assert_eq!(field(&refusal(&many_strips)), "StripOffsets");
}

#[test]
fn rows_that_would_fill_the_memory_are_refused() {
    let file =
        TiffBytes { tile: Some((4, 4)), tags: vec![(322, 4, vec![1 << 31])], ..Default::default() };
    assert_eq!(field(&refusal(&file)), "row of samples");
}

#[test]
fn a_raster_of_chunks_that_are_all_left_out_may_not_fill_the_memory() {
    let side = 1 << 20;
    let file = TiffBytes {
        tags: vec![
            (256, 4, vec![side]),
            (257, 4, vec![side]),
            (278, 4, vec![side]),
            (273, 4, vec![0]),
            (279, 4, vec![0]),
        ],
        ..Default::default()
    };
    let (_kept, tiff) = open(&file);
    assert_eq!(field(&decode_whole(&tiff).err().unwrap()), "ImageLength and ImageWidth");
}

#[test]
fn tags_are_given_as_they_are_and_never_from_outside_of_the_file() {
    let file = TiffBytes {
        tags: vec![
            (34735, 3, vec![1, 1, 0, 0]),
            (34737, 2, b"Mars|\0".map(u64::from).to_vec()),
            (50000, 5, vec![6 << 32 | 3]),
        ],
        ..Default::default()
    };
    let (_kept, tiff) = open(&file);
    assert_eq!(tiff.numbers(33550).unwrap(), Some(vec![30.0, 20.0, 0.0]));
    assert_eq!(tiff.numbers(34735).unwrap(), Some(vec![1.0, 1.0, 0.0, 0.0]));
    assert_eq!(tiff.text(34737).unwrap().as_deref(), Some("Mars|"));
    assert_eq!(tiff.numbers(50000).unwrap(), Some(vec![0.5]));
    assert_eq!(tiff.numbers(4711).unwrap(), None);
    assert_eq!(field(&tiff.text(33550).unwrap_err()), "ModelPixelScale");
    assert_eq!(field(&tiff.numbers(34737).unwrap_err()), "GeoAsciiParams");
}

#[test]
fn a_cancelled_decoding_ends_and_leaves_no_cache() {
    let (_kept, tiff) = open(&TiffBytes { compression: 8, ..Default::default() });
    let cache = std::env::temp_dir().join(format!("decode-cancelled-{}", std::process::id()));
    let progress = Progress::new();
    progress.cancel();
    let result = tiff.decode(layout(&tiff, 5, 6), &window(0, 0), Some(&cache), &progress);
    assert!(matches!(result, Err(DecodeError::Cancelled)));
    assert!(!cache.exists());
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    for compression in [1, 5, 8, 32773] {
        for is_big in [false, true] {
            let (whole, _) = TiffBytes { compression, is_big, ..Default::default() }.bytes(sample);
            // The last bytes are the place of the next directory, which nobody needs.
            for length in 0..whole.len() - if is_big { 8 } else { 4 } {
                let kept = keep(&whole[..length]);
                assert!(GeoTiff::open(&kept.0).is_err(), "{length} of {}", whole.len());
            }
        }
    }
}

#[test]
fn data_that_end_too_early_are_refused_and_named() {
    for compression in [5, 8, 32773] {
        let file = TiffBytes { compression, strip_rows: 6, ..Default::default() };
        let (bytes, _) = file.bytes(sample);
        let (_kept, tiff) = open(&file);
        let length = tiff.numbers(279).unwrap().unwrap()[0] as u64;
        assert!(length > 12 && bytes.len() > 60);
        let cut = TiffBytes { tags: vec![(279, 4, vec![length / 2])], ..file };
        let (_kept, tiff) = open(&cut);
        let error = decode_whole(&tiff).err().unwrap();
        assert_eq!(field(&error), "strip 0 (rows 0 to 5)");
        assert!(error.to_string().contains("too early"), "{error}");
    }
}
