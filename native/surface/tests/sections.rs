//! Sections: their joints lie on the surface, on edges of the lattice, and on the straight line.

use proptest::prelude::*;
use surface::section::Section;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Heightfield, SampleType, readers};

const ROWS: u64 = 24;
const COLUMNS: u64 = 40;

/// Rough ground.
fn grid(wraps: bool) -> Grid {
    let samples = (0..ROWS * COLUMNS).map(|k| ((k * k * 7919 + k * 104_729) % 997) as i16 - 498);
    let bytes = samples.flat_map(i16::to_be_bytes).collect();
    let (sample, order) = (SampleType::I16, ByteOrder::Big);
    let layout = GridLayout::packed(ROWS, COLUMNS, 1.0, 1.0, sample, order).unwrap();
    Grid::from_vec(bytes, layout.with_wrap(wraps)).unwrap()
}

fn on_surface(grid: &Grid, columns: f64, rows: f64) -> GridPoint {
    let under = GridPoint::new(columns, rows, 0.0);
    GridPoint { elevation: grid.surface_elevation(&under).unwrap(), ..under }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn joints_are_the_places_where_the_line_crosses_the_lattice(
        from in prop::array::uniform2(0.0f64..1.0),
        to in prop::array::uniform2(0.0f64..1.0),
        wraps: bool,
        turns in 0i64..3,
    ) {
        let grid = grid(wraps);
        // On a planet, also over the seam and far around.
        let (first, width) = if wraps { (turns as f64 * 40.0, 60.0) } else { (0.0, 39.0) };
        let place = |[x, y]: [f64; 2]| (first + width * x, 23.0 * y);
        let ((x0, y0), (x1, y1)) = (place(from), place(to));
        prop_assume!((x1 - x0).abs().max((y1 - y0).abs()) >= 1.0);
        let (start, end) = (on_surface(&grid, x0, y0), on_surface(&grid, x1, y1));
        let field = Heightfield::<readers::I16Big>::new(&grid);
        let section = Section::new(&field, &start, &end);
        let longer = (x1 - x0).abs().max((y1 - y0).abs());
        prop_assert!((section.length() - longer).abs() < 1e-9);

        // Joint by joint: after each of them the section is followed again, one joint further.
        let mut before = 0.0;
        for wanted in 1.. {
            let pass = |(seen, _, _): (u32, f64, f64), at: f64, height: f64| {
                (seen < wanted).then_some((seen + 1, at, height))
            };
            let (reached, _) = section.follow(u32::MAX, (0, 0.0, 0.0), pass);
            let Some((joint, (seen, at, height))) = reached else { break };
            if seen < wanted {
                // As many as lines that are crossed: columns, rows and diagonals.
                let crossed = |a: f64, b: f64| (a.floor() - b.floor()).abs();
                let lines = crossed(x0, x1) + crossed(y0, y1) + crossed(x0 - y0, x1 - y1);
                prop_assert_eq!(f64::from(seen), lines);
                break;
            }
            prop_assert!(at > before - 1e-12 && at < longer, "{at} after {before}");
            before = at;
            let (x, y) = (x0 + (x1 - x0) * at / longer, y0 + (y1 - y0) * at / longer);
            let place = section.place(joint);
            let (u, v) = match place.k {
                0 => (place.along, 0.0),
                1 => (place.along, place.along),
                _ => (0.0, place.along),
            };
            let (column, row) = (place.column as f64 + u, place.row as f64 + v);
            prop_assert!((column - x).abs() < 1e-9 && (row - y).abs() < 1e-9, "{place:?}");
            let surface = grid.surface_elevation(&GridPoint::new(x, y, 0.0)).unwrap();
            prop_assert!((height - surface).abs() < 1e-6, "{height} on {surface}");
        }
    }
}

#[test]
fn a_section_through_a_hole_ends_before_it() {
    let mut samples = vec![0i16; (ROWS * COLUMNS) as usize];
    samples[12 * COLUMNS as usize + 20] = -9999;
    let bytes = samples.into_iter().flat_map(i16::to_be_bytes).collect();
    let (sample, order) = (SampleType::I16, ByteOrder::Big);
    let layout = GridLayout::packed(ROWS, COLUMNS, 1.0, 1.0, sample, order).unwrap();
    let grid = Grid::from_vec(bytes, layout.with_void(Some(-9999.0))).unwrap();
    let (start, end) = (GridPoint::new(10.5, 12.3, 0.0), GridPoint::new(30.5, 12.3, 0.0));
    let field = Heightfield::<readers::I16Big>::new(&grid);
    let section = Section::new(&field, &start, &end);
    let pass = |_, at: f64, height: f64| (height == 0.0).then_some(at);
    let (reached, _) = section.follow(u32::MAX, 0.0, pass);
    let (_, at) = reached.unwrap();
    assert!(at > 8.0 && at <= 9.5, "{at}");
}
