//! Damaged GeoTIFF files, for as long as one likes.
//!
//! ```text
//! cargo run --release -p decode --example fuzz_geotiff -- --seconds 600
//! cargo run --release -p decode --example fuzz_geotiff -- --seed 1234
//! ```
//!
//! A case is made from its seed alone: a small valid file of any kind, damaged in some places (bytes anywhere,
//! or numbers in its directory that become absurd), or cut. It is opened, its tags are read, and all of it and a
//! window are decoded. A panic is a finding; so is a case that takes longer than ten seconds, or that
//! allocates more than its file justifies. `--seed` runs one case again. Exits with 1 if anything was found.

#[path = "../tests/common/mod.rs"]
mod common;

use common::random::Random;
use common::tiff_bytes::TiffBytes;
use decode::geotiff::{GeoTiff, Window};
use decode::{DecodeError, Progress};
use std::alloc::{GlobalAlloc, Layout, System};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use surface::{ByteOrder, GridLayout};

/// What a case may take before it is taken to hang.
const PATIENCE: Duration = Duration::from_secs(10);

/// Findings shown before the fuzzing ends.
const MOST_FINDINGS: usize = 20;

/// Bytes that opening may take beside 64 times the file: decoders have tables of their own.
const ROOM_TO_OPEN: usize = 1 << 20;

/// Larger rasters are not decoded: the fuzzing would be about filling memory.
const MOST_DECODED: u64 = 1 << 24;

/// Tells how much memory was ever in use.
struct Watched;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static MOST_IN_USE: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is handed to the system's allocator as it came.
unsafe impl GlobalAlloc for Watched {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = IN_USE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST_IN_USE.fetch_max(now, Ordering::Relaxed);
        // SAFETY: the caller's promise is handed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, address: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promise is handed on.
        unsafe { System.dealloc(address, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Watched = Watched;

/// How cases ended.
#[derive(Default)]
struct Tally {
    refused: u64,
    undecodable: u64,
    decoded: u64,
}

fn main() -> ExitCode {
    let path = std::env::temp_dir().join(format!("fuzz-geotiff-{}.tif", std::process::id()));
    let mut tally = Tally::default();
    if let Some(seed) = argument("--seed") {
        println!("{:?}", run(seed, &path, &mut tally));
        let _ = std::fs::remove_file(path);
        return ExitCode::SUCCESS;
    }
    // Panics are told with their seed.
    std::panic::set_hook(Box::new(|_| ()));
    let seconds = Duration::from_secs(argument("--seconds").unwrap_or(60));
    let first = argument("--from").unwrap_or(0);
    let current = Arc::new(AtomicU64::new(first));
    watch(Arc::clone(&current));
    let start = Instant::now();
    let mut findings = 0;
    let mut seed = first;
    while start.elapsed() < seconds && findings < MOST_FINDINGS {
        current.store(seed, Ordering::Relaxed);
        if let Err(finding) = run(seed, &path, &mut tally) {
            findings += 1;
            println!("seed {seed}: {finding}");
        }
        seed += 1;
    }
    let _ = std::fs::remove_file(path);
    println!(
        "{} cases: {} refused when opened, {} when decoded, {} decoded; {findings} findings",
        seed - first,
        tally.refused,
        tally.undecodable,
        tally.decoded
    );
    if findings == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn argument(name: &str) -> Option<u64> {
    let mut arguments = std::env::args().skip_while(|argument| argument != name);
    arguments.next()?;
    arguments.next().map(|text| text.parse().expect("a whole number"))
}

/// Ends the program where a case does not end.
fn watch(current: Arc<AtomicU64>) {
    std::thread::spawn(move || {
        let mut last = (u64::MAX, Instant::now());
        loop {
            std::thread::sleep(Duration::from_millis(500));
            let seed = current.load(Ordering::Relaxed);
            if seed != last.0 {
                last = (seed, Instant::now());
            } else if last.1.elapsed() > PATIENCE {
                println!("seed {seed}: does not end");
                std::process::exit(1);
            }
        }
    });
}

fn run(seed: u64, path: &Path, tally: &mut Tally) -> Result<(), String> {
    let mut random = Random(seed);
    let file = damaged(&mut random);
    std::fs::write(path, &file).map_err(|error| error.to_string())?;
    let result = catch_unwind(AssertUnwindSafe(|| try_file(path, file.len(), &mut random, tally)));
    result.unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        Err(format!("panic: {}", text.unwrap_or_else(|| "without words".to_owned())))
    })
}

/// A valid file of any kind, then damaged or cut; a few stay whole.
fn damaged(random: &mut Random) -> Vec<u8> {
    let kind = TiffBytes {
        order: random.one(&[ByteOrder::Big, ByteOrder::Little]),
        is_big: random.below(3) == 0,
        columns: 1 + random.below(40),
        rows: 1 + random.below(40),
        format: random.one(&[(1, 8), (2, 8), (1, 16), (2, 16), (1, 32), (2, 32), (3, 32), (3, 64)]),
        bands: random.one(&[1, 1, 1, 3]),
        compression: random.one(&[1, 5, 8, 32946, 32773]),
        predictor: random.one(&[1, 2, 3]),
        tile: random.one(&[None, Some((16, 16)), Some((7, 5))]),
        strip_rows: 1 + random.below(12),
        tags: Vec::new(),
    };
    let roughness = random.one(&[1, 3, 1 << 20]);
    let (mut file, directory) =
        kind.bytes(|column, row| (column / 3 + row * 2).wrapping_mul(roughness));
    match random.below(8) {
        0 => {}
        1 => file.truncate(random.below(file.len() as u64) as usize),
        2..=4 => spoil(&mut file, 0, random),
        _ => spoil(&mut file, directory, random),
    }
    file
}

/// Changes some bytes from `first` on, or makes some numbers there absurd.
fn spoil(file: &mut [u8], first: usize, random: &mut Random) {
    const ABSURD: [u64; 8] = [0, 1, 2, 0xff, 0x7fff_ffff, 0x8000_0000, u64::MAX, 1 << 40];
    for _ in 0..1 + random.below(5) {
        let place = first + random.below((file.len() - first) as u64) as usize;
        if random.below(2) == 0 {
            file[place] = random.bits() as u8;
            continue;
        }
        let size = random.one(&[2, 4, 8]).min(file.len() - place);
        let number = random.one(&ABSURD).wrapping_add(random.below(3));
        let bytes = if random.below(2) == 0 { number.to_le_bytes() } else { number.to_be_bytes() };
        file[place..place + size].copy_from_slice(&bytes[..size]);
    }
}

fn try_file(
    path: &Path,
    length: usize,
    random: &mut Random,
    tally: &mut Tally,
) -> Result<(), String> {
    let before = IN_USE.load(Ordering::Relaxed);
    MOST_IN_USE.store(before, Ordering::Relaxed);
    let opened = GeoTiff::open(path);
    let used = MOST_IN_USE.load(Ordering::Relaxed) - before;
    if used > 64 * length + ROOM_TO_OPEN {
        return Err(format!("opening a file of {length} bytes took {used}"));
    }
    let Ok(tiff) = opened else {
        tally.refused += 1;
        return Ok(());
    };
    for tag in [256, 273, 339, 33550, 33922, 34264, 34735, 34736, 34737, 42112, 42113] {
        let _ = (tiff.numbers(tag), tiff.text(tag));
    }
    let _ = (tiff.in_place(), tiff.chunk_size(), tiff.photometric());
    let whole = decode(&tiff, tiff.columns(), tiff.rows(), 0, 0, false);
    let columns = 2 + random.below(u64::from(tiff.columns())) as u32;
    let rows = 2 + random.below(u64::from(tiff.rows())) as u32;
    let first_column = random.below(u64::from(tiff.columns()) + 1) as u32;
    let first_row = random.below(u64::from(tiff.rows()) + 1) as u32;
    let window = decode(&tiff, columns, rows, first_column, first_row, random.below(2) == 0);
    match (whole, window) {
        (Some(Ok(())), _) | (_, Some(Ok(()))) => tally.decoded += 1,
        _ => tally.undecodable += 1,
    }
    Ok(())
}

/// Decodes a window; `None` where no grid has such a size.
fn decode(
    tiff: &GeoTiff,
    columns: u32,
    rows: u32,
    first_column: u32,
    first_row: u32,
    south_up: bool,
) -> Option<Result<(), DecodeError>> {
    let sample = tiff.stored().decoded();
    let layout =
        GridLayout::packed(rows.into(), columns.into(), 1.0, 1.0, sample, ByteOrder::Little)
            .ok()?;
    if layout.byte_length() > MOST_DECODED {
        return None;
    }
    let window = Window { first_column, first_row, south_up, fill: -9999.0 };
    Some(tiff.decode(layout, &window, None, &Progress::new()).map(|grid| {
        grid.elevation(i64::from(columns) - 1, i64::from(rows) - 1);
    }))
}
