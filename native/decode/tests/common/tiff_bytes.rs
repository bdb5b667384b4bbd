//! Small TIFF files, made in memory ("TIFF Revision 6.0").

use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;
use surface::ByteOrder;
use weezl::BitOrder;
use weezl::encode::Encoder;

/// A tag, its type, and its values.
pub type Tag = (u16, u16, Vec<u64>);

/// What a file is made of; `Default` is 6 rows of 5 signed 16-bit samples in strips of 2 rows.
#[derive(Clone, Debug)]
pub struct TiffBytes {
    pub order: ByteOrder,
    pub is_big: bool,
    pub columns: u64,
    pub rows: u64,
    /// SampleFormat and BitsPerSample.
    pub format: (u64, u64),
    pub bands: u64,
    pub compression: u64,
    pub predictor: u64,
    /// Columns and rows of a tile; strips of `strip_rows` where there is none.
    pub tile: Option<(u64, u64)>,
    pub strip_rows: u64,
    /// Tags to add, or to have instead.
    pub tags: Vec<Tag>,
}

impl Default for TiffBytes {
    fn default() -> Self {
        Self {
            order: ByteOrder::Little,
            is_big: false,
            columns: 5,
            rows: 6,
            format: (2, 16),
            bands: 1,
            compression: 1,
            predictor: 1,
            tile: None,
            strip_rows: 2,
            tags: Vec::new(),
        }
    }
}

impl TiffBytes {
    /// The file, and where its directory begins. `sample` gives the low bits of a sample by column and row;
    /// predictors are stated, not applied.
    pub fn bytes(&self, sample: impl Fn(u64, u64) -> u64) -> (Vec<u8>, usize) {
        let mut file = vec![0; if self.is_big { 16 } else { 8 }];
        let (mut offsets, mut lengths) = (Vec::new(), Vec::new());
        for (column, row, columns, rows) in self.chunks() {
            let packed = self.pack(&self.raw(column, row, columns, rows, &sample));
            offsets.push(file.len() as u64);
            lengths.push(packed.len() as u64);
            file.extend(packed);
        }
        let tags = self.tags(offsets, lengths);
        let directory = self.write_tags(&mut file, &tags);
        self.write_header(&mut file, directory as u64);
        (file, directory)
    }

    fn chunks(&self) -> Vec<(u64, u64, u64, u64)> {
        let (columns, rows) = self.tile.unwrap_or((self.columns, self.strip_rows));
        let mut chunks = Vec::new();
        for row in (0..self.rows).step_by(rows as usize) {
            for column in (0..self.columns).step_by(columns as usize) {
                let rows = if self.tile.is_some() { rows } else { rows.min(self.rows - row) };
                chunks.push((column, row, columns, rows));
            }
        }
        chunks
    }

    fn raw(
        &self,
        first_column: u64,
        first_row: u64,
        columns: u64,
        rows: u64,
        sample: impl Fn(u64, u64) -> u64,
    ) -> Vec<u8> {
        let mut raw = Vec::new();
        for row in first_row..first_row + rows {
            for column in first_column..first_column + columns {
                for band in 0..self.bands {
                    self.put(&mut raw, sample(column, row).wrapping_add(band), self.format.1 / 8);
                }
            }
        }
        raw
    }

    fn pack(&self, raw: &[u8]) -> Vec<u8> {
        match self.compression {
            5 => Encoder::with_tiff_size_switch(BitOrder::Msb, 8).encode(raw).unwrap(),
            8 | 32946 => {
                let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
                encoder.write_all(raw).unwrap();
                encoder.finish().unwrap()
            }
            32773 => raw.chunks(100).flat_map(pack_bits).collect(),
            _ => raw.to_vec(),
        }
    }

    fn tags(&self, offsets: Vec<u64>, lengths: Vec<u64>) -> Vec<Tag> {
        let mut tags: Vec<Tag> = vec![
            (256, 4, vec![self.columns]),
            (257, 4, vec![self.rows]),
            (258, 3, vec![self.format.1; self.bands as usize]),
            (259, 3, vec![self.compression]),
            (262, 3, vec![1]),
            (277, 3, vec![self.bands]),
            (317, 3, vec![self.predictor]),
            (339, 3, vec![self.format.0; self.bands as usize]),
            (33550, 12, [30.0_f64, 20.0, 0.0].map(f64::to_bits).to_vec()),
            (42113, 2, b"-9999\0".map(u64::from).to_vec()),
        ];
        match self.tile {
            Some((columns, rows)) => tags.extend([
                (322, 4, vec![columns]),
                (323, 4, vec![rows]),
                (324, 4, offsets),
                (325, 4, lengths),
            ]),
            None => {
                tags.extend([(273, 4, offsets), (278, 4, vec![self.strip_rows]), (279, 4, lengths)])
            }
        }
        tags.retain(|(tag, _, _)| self.tags.iter().all(|(other, _, _)| other != tag));
        tags.extend(self.tags.iter().cloned());
        tags.sort_by_key(|(tag, _, _)| *tag);
        tags
    }

    /// Writes values that do not fit into entries, and then the directory; gives where that begins.
    fn write_tags(&self, file: &mut Vec<u8>, tags: &[Tag]) -> usize {
        let room = if self.is_big { 8 } else { 4 };
        let mut entries = Vec::new();
        for (tag, kind, values) in tags {
            let size = match kind {
                1 | 2 | 7 => 1,
                3 => 2,
                4 => 4,
                _ => 8,
            };
            let mut raw = Vec::new();
            for value in values {
                self.put(&mut raw, *value, size);
            }
            self.put(&mut entries, u64::from(*tag), 2);
            self.put(&mut entries, u64::from(*kind), 2);
            self.put(&mut entries, values.len() as u64, room);
            if raw.len() <= room as usize {
                raw.resize(room as usize, 0);
                entries.extend(raw);
            } else {
                self.put(&mut entries, file.len() as u64, room);
                file.extend(raw);
            }
        }
        let start = file.len();
        self.put(file, tags.len() as u64, if self.is_big { 8 } else { 2 });
        file.extend(entries);
        self.put(file, 0, room);
        start
    }

    fn write_header(&self, file: &mut [u8], directory: u64) {
        let mut header = match self.order {
            ByteOrder::Big => b"MM".to_vec(),
            ByteOrder::Little => b"II".to_vec(),
        };
        if self.is_big {
            for (value, size) in [(43, 2), (8, 2), (0, 2), (directory, 8)] {
                self.put(&mut header, value, size);
            }
        } else {
            self.put(&mut header, 42, 2);
            self.put(&mut header, directory, 4);
        }
        file[..header.len()].copy_from_slice(&header);
    }

    fn put(&self, bytes: &mut Vec<u8>, value: u64, size: u64) {
        let size = size as usize;
        match self.order {
            ByteOrder::Big => bytes.extend(&value.to_be_bytes()[8 - size..]),
            ByteOrder::Little => bytes.extend(&value.to_le_bytes()[..size]),
        }
    }
}

/// A run of one byte where all are equal, else the bytes as they are.
fn pack_bits(bytes: &[u8]) -> Vec<u8> {
    let is_run = bytes.len() > 1 && bytes.iter().all(|byte| *byte == bytes[0]);
    if is_run {
        return vec![(257 - bytes.len()) as u8, bytes[0]];
    }
    [&[(bytes.len() - 1) as u8], bytes].concat()
}
