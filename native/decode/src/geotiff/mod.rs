//! GeoTIFF: a raster of heights in a TIFF file, whose samples may lie in strips or tiles, packed or not.
//!
//! Format: "TIFF Revision 6.0" (Aldus, 1992), its "Technical Note 3" (floating point predictor,
//! Adobe, 2005), and BigTIFF as libtiff describes it. What the georeferencing tags mean is nothing
//! that decoding has to know: they are handed out as numbers and texts.
//!
//! The file is the enemy: every count is compared with what the file holds before anything is
//! allocated for it, and nothing is believed about a chunk of samples but its place.

mod chunks;
mod codec;
mod compression;
mod decode;
mod directory;
mod in_place;
mod input;
mod packbits;
mod picture;
mod predictor;
mod sample;
mod worker;

use crate::error::DecodeError;
use crate::source::Source;
use chunks::Chunks;
use directory::Directory;
use picture::Picture;
use std::path::Path;
use surface::ByteOrder;

pub use compression::Compression;
pub use decode::Window;
pub use in_place::InPlace;
pub use predictor::Predictor;
pub use sample::StoredSample;

/// A TIFF file whose first directory was read; its samples were not.
#[derive(Debug)]
pub struct GeoTiff {
    source: Source,
    directory: Directory,
    picture: Picture,
    chunks: Chunks,
}

impl GeoTiff {
    /// Reads the header and the first directory, and checks that every chunk of samples lies in the
    /// file.
    pub fn open(path: &Path) -> Result<Self, DecodeError> {
        let source = Source::open(path)?;
        let directory = Directory::read(&source)?;
        let picture = Picture::read(&source, &directory)?;
        let chunks = Chunks::read(&source, &directory, &picture)?;
        Ok(Self { source, directory, picture, chunks })
    }

    /// Number of rows in the file, at least 1.
    pub fn rows(&self) -> u32 {
        self.picture.rows
    }

    /// Samples of a band in a row, at least 1.
    pub fn columns(&self) -> u32 {
        self.picture.columns
    }

    /// Values for each place, at least 1; the first is what is decoded.
    pub fn bands(&self) -> u16 {
        self.picture.bands
    }

    /// Whether each band lies by itself, not sample by sample beside the others.
    pub fn is_planar(&self) -> bool {
        self.picture.is_planar
    }

    /// The number format in the file.
    pub fn stored(&self) -> StoredSample {
        self.picture.stored
    }

    /// How the samples were packed.
    pub fn compression(&self) -> Compression {
        self.picture.compression
    }

    /// What was done to the samples before they were packed.
    pub fn predictor(&self) -> Predictor {
        self.picture.predictor
    }

    /// Of every number in the file.
    pub fn byte_order(&self) -> ByteOrder {
        self.directory.byte_order()
    }

    /// Whether it is a BigTIFF, with places of 64 bits.
    pub fn is_big(&self) -> bool {
        self.directory.is_big()
    }

    /// Whether samples lie in tiles, not in strips.
    pub fn is_tiled(&self) -> bool {
        self.chunks.is_tiled()
    }

    /// Columns and rows of a tile or strip.
    pub fn chunk_size(&self) -> (u32, u32) {
        self.chunks.size()
    }

    /// The tag PhotometricInterpretation: 2 for red, green and blue, 3 for a colour table.
    pub fn photometric(&self) -> Option<u16> {
        self.picture.photometric
    }

    /// Where the first band's samples lie, if they can be used there.
    pub fn in_place(&self) -> Option<InPlace> {
        InPlace::of(&self.picture, &self.chunks, self.directory.byte_order())
    }

    /// The numbers of a tag, of whatever numeric type; `None` where the file has no such tag.
    pub fn numbers(&self, tag: u16) -> Result<Option<Vec<f64>>, DecodeError> {
        self.directory.numbers(&self.source, tag)
    }

    /// The text of a tag without the NULs at its end; bytes that are no UTF-8 are taken as Latin-1.
    pub fn text(&self, tag: u16) -> Result<Option<String>, DecodeError> {
        self.directory.text(&self.source, tag)
    }
}
