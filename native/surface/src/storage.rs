//! The bytes of a grid: a mapped file, or memory that somebody else keeps.

use crate::guard::{Guard, TooMany};
use std::fs::File;
use std::io;

/// Whatever must stay alive for foreign bytes to stay valid.
pub type KeepAlive = Box<dyn std::any::Any + Send + Sync>;

/// Bytes that are only ever read through raw pointers: they may change under us.
pub(crate) struct Storage {
    address: *const u8,
    length: usize,
    owner: Owner,
}

enum Owner {
    // Fields drop in this order: the guard ends before the pages go.
    Mapped { guard: Guard, mapping: memmap2::Mmap, _file: File },
    Foreign { _kept: KeepAlive },
}

// SAFETY: the bytes are only read, through raw pointers and as plain integers, so any thread may do it.
unsafe impl Send for Storage {}
// SAFETY: as above.
unsafe impl Sync for Storage {}

impl Storage {
    /// Maps the whole file read-only, without reading ahead: a hand jumps about.
    pub(crate) fn map(file: File) -> io::Result<Self> {
        // SAFETY: the mapping is never handed out as a slice; that its bytes may change or vanish
        // is what the raw reads and the guard are for.
        let mapping = unsafe { memmap2::Mmap::map(&file)? };
        let (address, length) = (mapping.as_ptr(), mapping.len());
        let guard = Guard::new(address, length, &file).map_err(|TooMany| {
            let most = crate::guard::MOST_MAPPINGS;
            io::Error::other(format!("{most} grids are mapped already; free one first"))
        })?;
        let storage =
            Self { address, length, owner: Owner::Mapped { guard, mapping, _file: file } };
        storage.expect_sequential_reads(false);
        Ok(storage)
    }

    /// Uses bytes that `kept` keeps valid.
    ///
    /// # Safety
    /// `address` must stay readable for `length` bytes until `kept` is dropped.
    pub(crate) unsafe fn foreign(address: *const u8, length: usize, kept: KeepAlive) -> Self {
        Self { address, length, owner: Owner::Foreign { _kept: kept } }
    }

    pub(crate) fn address(&self) -> *const u8 {
        self.address
    }

    pub(crate) fn length(&self) -> usize {
        self.length
    }

    /// Whether part of a mapped file vanished while in use.
    pub(crate) fn damaged(&self) -> bool {
        match &self.owner {
            Owner::Mapped { guard, .. } => guard.damaged(),
            Owner::Foreign { .. } => false,
        }
    }

    /// Notices a mapped file that was cut, also where no read has met the cut yet. A system call.
    pub(crate) fn look_at_file(&self) {
        if let Owner::Mapped { guard, .. } = &self.owner {
            guard.look_at_file();
        }
    }

    /// Tells the system whether reads will be in order (a scan) or anywhere (touch). A hint only:
    /// where it cannot be given, reads are as right as before.
    pub(crate) fn expect_sequential_reads(&self, sequential: bool) {
        #[cfg(unix)]
        if let Owner::Mapped { mapping, .. } = &self.owner {
            let advice =
                if sequential { memmap2::Advice::Sequential } else { memmap2::Advice::Random };
            let _ = mapping.advise(advice);
        }
        #[cfg(not(unix))]
        let _ = sequential;
    }
}
