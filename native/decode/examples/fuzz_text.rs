//! Mutates text grids, and raw samples' places, and looks for panics, hangs and grids out of nothing.
//!
//! `cargo run --release --package decode --example fuzz_text -- --seconds 600 [--seed N]`
//!
//! Every case is a small valid file with some damage: bits, bytes, numbers, lines, or an end at any place,
//! the ends of records among them. Errors are as good as grids; a panic, a case of more than two seconds or a
//! grid of far more bytes than the file is a finding.

use decode::esri_ascii::EsriAscii;
use decode::usgs_dem::UsgsDem;
use decode::{DecodeError, Progress, RawSample, RawSamples};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};
use surface::{ByteOrder, GridLayout};

/// Longer is a hang: these files have some kilobytes.
const LONGEST: Duration = Duration::from_secs(2);

/// Bytes that a grid may have at the most, and for each byte of its file.
const ALWAYS: u64 = 16 << 20;
const FOR_A_BYTE: u64 = 512;

/// Bytes that mean something to one of the formats, or to none.
const SPOILT: &[u8] = b" -+.,0159\n\rDeEnx\"\0\xff";

fn main() {
    let (mut seconds, mut seed) = (10, 1);
    let mut arguments = std::env::args().skip(1);
    while let (Some(name), Some(value)) = (arguments.next(), arguments.next()) {
        let number = value.parse().unwrap_or_else(|_| panic!("{name} {value} is no number"));
        match name.as_str() {
            "--seconds" => seconds = number,
            "--seed" => seed = number,
            _ => panic!("{name} is none of --seconds and --seed"),
        }
    }
    let folder = std::env::temp_dir().join(format!("fuzz-text-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the cases");
    std::panic::set_hook(Box::new(|_| {}));
    let ending = Instant::now() + Duration::from_secs(seconds);
    let mut tally = Tally::default();
    let mut chance = Chance(seed);
    while Instant::now() < ending {
        let case = Case::of(&mut chance);
        tally.run(&folder.join("case"), &case);
    }
    std::fs::remove_dir_all(&folder).expect("the folder of the cases");
    println!(
        "{} cases: {} grids, {} errors, {} findings",
        tally.cases, tally.grids, tally.errors, tally.findings
    );
    std::process::exit(i32::from(tally.findings > 0));
}

/// What came of it.
#[derive(Default)]
struct Tally {
    cases: u64,
    grids: u64,
    errors: u64,
    findings: u64,
}

impl Tally {
    fn run(&mut self, path: &Path, case: &Case) {
        // Some systems write a file that is cut and filled anew to the disk at once.
        let _ = std::fs::remove_file(path);
        std::fs::write(path, &case.bytes).expect("a case is written");
        self.cases += 1;
        let start = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| case.read(path)));
        let finding = match outcome {
            Err(_) => Some("panic"),
            Ok(_) if start.elapsed() > LONGEST => Some("hang"),
            Ok(Ok(bytes)) if bytes > ALWAYS.max(case.bytes.len() as u64 * FOR_A_BYTE) => {
                Some("a grid out of nothing")
            }
            Ok(Ok(_)) => {
                self.grids += 1;
                None
            }
            Ok(Err(_)) => {
                self.errors += 1;
                None
            }
        };
        if let Some(finding) = finding {
            self.findings += 1;
            let kept = std::env::temp_dir().join(format!("finding-{}", self.findings));
            std::fs::write(&kept, &case.bytes).expect("a finding is kept");
            println!("{finding}: {:?}, kept as {}", case.kind, kept.display());
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Dem,
    Esri,
    Raw(RawSamples, u32, u32),
}

struct Case {
    kind: Kind,
    bytes: Vec<u8>,
}

impl Case {
    fn of(chance: &mut Chance) -> Self {
        let (kind, mut bytes) = match chance.below(5) {
            0 | 1 => (Kind::Dem, dem(chance)),
            2 | 3 => (Kind::Esri, esri(chance)),
            _ => raw(chance),
        };
        for _ in 0..chance.below(4) {
            damage(&mut bytes, chance);
        }
        Self { kind, bytes }
    }

    /// Reads it as the add-on does; bytes of the grid.
    fn read(&self, path: &Path) -> Result<u64, DecodeError> {
        let progress = Progress::new();
        let layout = |columns: u32, rows: u32, sample| {
            let (columns, rows) = (u64::from(columns), u64::from(rows));
            GridLayout::packed(rows, columns, 30.0, 30.0, sample, ByteOrder::Little)
                .map_err(|error| DecodeError::Grid(error.into()))
        };
        let grid = match self.kind {
            Kind::Dem => {
                let dem = UsgsDem::open(path, &progress)?;
                let layout = layout(dem.columns(), dem.rows(), dem.stored().sample)?;
                let layout = layout.with_void(Some(dem.stored().void));
                dem.decode(layout, 0, 0, &progress, None)?
            }
            Kind::Esri => {
                let esri = EsriAscii::open(path)?;
                let stored = esri.heights(&progress)?.stored;
                let layout = layout(esri.header().columns, esri.header().rows, stored.sample)?;
                esri.decode(layout.with_void(Some(stored.void)), 0, 0, &progress, None)?
            }
            Kind::Raw(samples, column, row) => {
                let layout = layout(4, 3, samples.sample.decoded())?;
                samples.decode(path, layout, column, row, &progress, None)?
            }
        };
        let bytes = grid.layout().byte_length();
        if grid.layout().samples() < 1 << 20 {
            decode::fill(&grid, &progress)?;
        }
        Ok(bytes)
    }
}

/// A DEM of a few profiles, in one of the forms that there are.
fn dem(chance: &mut Chance) -> Vec<u8> {
    let line = ["", "\n", "\r\n"][chance.below(3)];
    let header_bytes = [864, 893, 918, 1024][chance.below(4)];
    let profiles = 2 + chance.below(5);
    let (system, unit, step) = if chance.below(3) == 0 { (0, 3, "3") } else { (1, 2, "30") };
    let mut header = vec![b' '; 1024];
    let mut put = |first: usize, text: String| {
        header[first - 1..first - 1 + text.len()].copy_from_slice(text.as_bytes());
    };
    put(1, "A quadrangle that was made up".to_owned());
    put(157, format!("{system:6}{:6}", 10));
    put(529, format!("{unit:6}{:6}", 1 + chance.below(2)));
    put(
        817,
        format!("{step:>12}{step:>12}{:>12}", ["1.0", "0.1", "0.100000D+01"][chance.below(3)]),
    );
    put(853, format!("{:6}{profiles:6}", 1));
    if header_bytes > 892 {
        put(889, format!("{:2}{:2}", 2, chance.below(5)));
    }
    header.truncate(header_bytes);
    let mut bytes = header;
    bytes.extend(line.bytes());
    for profile in 0..profiles {
        let heights =
            [1 + chance.below(20), 140 + chance.below(12), 310 + chance.below(20)][chance.below(3)];
        let datum = if chance.below(4) == 0 { 12.5 } else { 0.0 };
        let mut record = format!(
            "{:6}{:6}{heights:6}{:6}{:>24}{:>24}{datum:>24}{:>24}{:>24}",
            1,
            profile + 1,
            1,
            format!("{:.5}D+03", 500.0 + 0.03 * profile as f64),
            format!("{}.0", 4_000_000 + 30 * chance.below(5)),
            "0.0",
            "1.0",
        );
        for number in 0..heights {
            if record.len() >= 1024 - 5 {
                finish_record(&mut bytes, &mut record, line);
            }
            let height = [-32767, -32000, number as i64, -5, 99_999][chance.below(5)];
            record += &format!("{height:6}");
        }
        finish_record(&mut bytes, &mut record, line);
    }
    bytes
}

fn finish_record(bytes: &mut Vec<u8>, record: &mut String, line: &str) {
    if line.is_empty() {
        bytes.extend(format!("{record:1024}").bytes());
    } else {
        bytes.extend(record.bytes().chain(line.bytes()));
    }
    record.clear();
}

/// An Esri ASCII grid.
fn esri(chance: &mut Chance) -> Vec<u8> {
    let (columns, rows) = (2 + chance.below(20), 2 + chance.below(20));
    let line = ["\n", "\r\n", "\r"][chance.below(3)];
    let corner = ["xllcorner", "XLLCENTER"][chance.below(2)];
    let mut text = format!(
        "ncols {columns}{line}NROWS {rows}{line}{corner} 1.5{line}yllcorner -2{line}cellsize 0.5{line}"
    );
    if chance.below(2) == 0 {
        text +=
            &format!("NODATA_value {}{line}", ["-9999", "nan", "-3.4e38", "0"][chance.below(4)]);
    }
    for _ in 0..rows {
        for _ in 0..columns {
            let words = ["1", "-9999", "12.25", "0.1", "nan", "1e5", "70000", "123456789012", ".5"];
            text += words[chance.below(words.len())];
            text.push(' ');
        }
        text += line;
    }
    text.into_bytes()
}

/// Raw samples in any place, most of them in the file.
fn raw(chance: &mut Chance) -> (Kind, Vec<u8>) {
    let types = [
        RawSample::I8,
        RawSample::U8,
        RawSample::I16,
        RawSample::U32,
        RawSample::U64,
        RawSample::F32,
        RawSample::F64,
    ];
    let sample = types[chance.below(types.len())];
    let odd = |chance: &mut Chance, usual: u64| match chance.below(12) {
        0 => u64::MAX >> chance.below(64),
        1 => 0,
        _ => usual,
    };
    let samples = RawSamples {
        rows: odd(chance, 8) as u32,
        columns: odd(chance, 9) as u32,
        sample,
        byte_order: [ByteOrder::Big, ByteOrder::Little][chance.below(2)],
        offset: odd(chance, 3),
        pixel_stride: odd(chance, 10),
        row_stride: odd(chance, 100),
        south_first: chance.below(2) == 0,
        wraps: chance.below(2) == 0,
    };
    let (column, row) = (odd(chance, 7) as u32, odd(chance, 2) as u32);
    let bytes = (0..900).map(|_| chance.below(256) as u8).collect();
    (Kind::Raw(samples, column, row), bytes)
}

/// Spoils something.
fn damage(bytes: &mut Vec<u8>, chance: &mut Chance) {
    let Some(last) = bytes.len().checked_sub(1) else { return };
    let place = chance.below(last + 1);
    // The beginning is where the facts are.
    let place = if chance.below(2) == 0 { place.min(chance.below(1300)) } else { place };
    match chance.below(9) {
        0 => bytes[place] ^= 1 << chance.below(8),
        1 => bytes[place] = SPOILT[chance.below(SPOILT.len())],
        2 => bytes.truncate(place),
        3 => bytes.truncate(place / 1024 * 1024),
        4 => {
            let numbers: [&[u8]; 8] = [
                b"999999", b"-32767", b"1e300 ", b"nan   ", b"      ", b"-1    ", b"1D+99 ",
                b"000000",
            ];
            let number = numbers[chance.below(numbers.len())];
            let end = (place + number.len()).min(bytes.len());
            bytes[place..end].copy_from_slice(&number[..end - place]);
        }
        5 => {
            let end = (place + chance.below(200)).min(bytes.len());
            bytes.drain(place..end);
        }
        6 => {
            let end = (place + chance.below(200)).min(bytes.len());
            let piece = bytes[place..end].to_vec();
            bytes.splice(place..place, piece);
        }
        7 => bytes.insert(place, b'\n'),
        _ => {
            let end = (place + 24).min(bytes.len());
            bytes[place..end].fill(b"9 \n"[chance.below(3)]);
        }
    }
}

/// The same numbers for the same seed (Marsaglia's xorshift).
struct Chance(u64);

impl Chance {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}
