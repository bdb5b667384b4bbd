//! One tick of a take, and its bytes.

/// Bytes in a file.
pub(crate) const BYTES: usize = 188;

/// The largest number of a feature: a vertex.
const LAST_FEATURE: u16 = 3;

/// The largest number of a mode: zoom.
const LAST_MODE: u16 = 2;

/// What a take keeps of a tick. Numbers of features and modes are those of the file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tick {
    /// Ticks done since the session was made, this one included.
    pub number: u64,
    /// Seconds on the session's clock.
    pub time: f64,
    /// Workspace metres.
    pub hand: [f64; 3],
    /// Terrain metres east, north and up.
    pub goal: [f64; 3],
    /// Terrain metres east, north and up.
    pub proxy: [f64; 3],
    /// Newtons, workspace frame, as sent to the device.
    pub force: [f64; 3],
    /// Radians about the vertical; 0 where the device does not tell.
    pub twist: f64,
    /// East, north, up, width, exaggeration and turn.
    pub window: [f64; 6],
    /// Unit vector, workspace frame; zero in free space. Floats: no direction needs more.
    pub normal: [f32; 3],
    /// A bit each; the first is the stylus button, also where a key was pressed for it.
    pub buttons: u32,
    /// 0 free, 1 face, 2 edge, 3 vertex.
    pub feature: u16,
    /// 0 normal, 1 pan, 2 zoom.
    pub mode: u16,
}

impl Tick {
    /// Appends its bytes.
    pub(crate) fn write(&self, bytes: &mut Vec<u8>) {
        bytes.extend(self.number.to_le_bytes());
        let [hand, goal, proxy, force] = [&self.hand, &self.goal, &self.proxy, &self.force];
        let doubles = std::iter::once(&self.time)
            .chain(hand)
            .chain(goal)
            .chain(proxy)
            .chain(force)
            .chain([&self.twist])
            .chain(&self.window);
        bytes.extend(doubles.flat_map(|double| double.to_le_bytes()));
        bytes.extend(self.normal.iter().flat_map(|float| float.to_le_bytes()));
        bytes.extend(self.buttons.to_le_bytes());
        bytes.extend(self.feature.to_le_bytes());
        bytes.extend(self.mode.to_le_bytes());
    }

    /// From its bytes; `None` where a feature or a mode is none.
    pub(crate) fn read(bytes: &[u8; BYTES]) -> Option<Tick> {
        let mut rest = Rest(bytes);
        let tick = Tick {
            number: u64::from_le_bytes(rest.next()),
            time: rest.double(),
            hand: rest.doubles(),
            goal: rest.doubles(),
            proxy: rest.doubles(),
            force: rest.doubles(),
            twist: rest.double(),
            window: rest.doubles(),
            normal: std::array::from_fn(|_| f32::from_le_bytes(rest.next())),
            buttons: u32::from_le_bytes(rest.next()),
            feature: u16::from_le_bytes(rest.next()),
            mode: u16::from_le_bytes(rest.next()),
        };
        (tick.feature <= LAST_FEATURE && tick.mode <= LAST_MODE).then_some(tick)
    }
}

/// What is left of a tick's bytes.
struct Rest<'a>(&'a [u8]);

impl Rest<'_> {
    fn next<const N: usize>(&mut self) -> [u8; N] {
        let (first, rest) = self.0.split_first_chunk().expect("a tick has as many bytes");
        self.0 = rest;
        *first
    }

    fn double(&mut self) -> f64 {
        f64::from_le_bytes(self.next())
    }

    fn doubles<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.double())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn any_bytes_of_a_tick_are_written_as_they_were_read(mut bytes in any::<[[u8; 47]; 4]>()) {
            // The last four bytes are a feature and a mode, of which there are few.
            let rare = [bytes[3][43] % 4, 0, bytes[3][45] % 3, 0];
            bytes[3][43..].copy_from_slice(&rare);
            let bytes: [u8; BYTES] = bytes.concat().try_into().unwrap();
            let mut written = Vec::new();
            Tick::read(&bytes).unwrap().write(&mut written);
            prop_assert_eq!(written, bytes);
        }
    }

    #[test]
    fn a_feature_or_a_mode_that_is_none_is_no_tick() {
        for tick in [Tick { feature: 4, ..Tick::default() }, Tick { mode: 3, ..Tick::default() }] {
            let mut bytes = Vec::new();
            tick.write(&mut bytes);
            assert_eq!(Tick::read(&bytes.try_into().unwrap()), None);
        }
    }
}
