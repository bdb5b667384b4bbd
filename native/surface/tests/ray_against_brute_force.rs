//! Rays against every triangle of the map, one by one.

use proptest::prelude::*;
use surface::ray::{RayEnd, Side, Start, cast};
use surface::readers::F64Little;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Heightfield, SampleType};

const SIZE: usize = 12;

fn grid(heights: &[f64], wraps: bool) -> Grid {
    let bytes = heights.iter().flat_map(|height| height.to_le_bytes()).collect();
    let size = SIZE as u64;
    let (sample, order) = (SampleType::F64, ByteOrder::Little);
    let layout = GridLayout::packed(size, size, 1.0, 1.0, sample, order).unwrap();
    Grid::from_vec(bytes, layout.with_wrap(wraps)).unwrap()
}

/// The first place where the segment goes down through a triangle, as a share of the segment.
fn brute_force(heights: &[f64], wraps: bool, from: [f64; 3], to: [f64; 3]) -> Option<f64> {
    let cells = if wraps { -40..40 } else { 0..SIZE as i64 - 1 };
    let sample = |column: i64, row: i64| {
        let stored = column.rem_euclid(SIZE as i64) as usize;
        [column as f64, row as f64, heights[row as usize * SIZE + stored]]
    };
    let mut first: Option<f64> = None;
    for column in cells {
        for row in 0..SIZE as i64 - 1 {
            let north_west = sample(column, row);
            let south_east = sample(column + 1, row + 1);
            for third in [sample(column + 1, row), sample(column, row + 1)] {
                if let Some(t) = goes_down_through([north_west, south_east, third], from, to)
                    && first.is_none_or(|first| t < first)
                {
                    first = Some(t);
                }
            }
        }
    }
    first
}

fn goes_down_through([a, b, c]: [[f64; 3]; 3], from: [f64; 3], to: [f64; 3]) -> Option<f64> {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let (ab, ac) = (minus(b, a), minus(c, a));
    let mut normal = [
        ab[1] * ac[2] - ab[2] * ac[1],
        ab[2] * ac[0] - ab[0] * ac[2],
        ab[0] * ac[1] - ab[1] * ac[0],
    ];
    if normal[2] < 0.0 {
        normal = normal.map(|part| -part);
    }
    let over = |p: [f64; 3]| {
        let d = minus(p, a);
        d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2]
    };
    let (start, end) = (over(from), over(to));
    if !(start >= 0.0 && end < 0.0) {
        return None;
    }
    let t = start / (start - end);
    let at = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
    // Inside by signed areas over the ground.
    let side =
        |p: [f64; 3], q: [f64; 3]| (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]);
    let sides = [side(a, b), side(b, c), side(c, a)];
    let inside = sides.iter().all(|s| *s >= -1e-12) || sides.iter().all(|s| *s <= 1e-12);
    inside.then_some(t)
}

fn heights() -> impl Strategy<Value = Vec<f64>> {
    let sample = prop_oneof![9 => -3.0..3.0f64, 1 => Just(f64::NAN)];
    prop::collection::vec(sample, SIZE * SIZE)
}

fn over_the_map(wraps: bool) -> std::ops::Range<f64> {
    if wraps { -25.0..25.0 } else { -3.0..14.0 }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_ray_from_above_meets_what_brute_force_meets(
        heights in heights(),
        (wraps, x0, x1) in any::<bool>().prop_flat_map(|wraps| (Just(wraps), over_the_map(wraps), over_the_map(wraps))),
        y0 in -3.0..14.0f64,
        y1 in -3.0..14.0f64,
        z0 in 3.0..9.0f64,
        z1 in -9.0..4.0f64,
    ) {
        let grid = grid(&heights, wraps);
        let field = Heightfield::<F64Little>::new(&grid);
        let (from, to) = (GridPoint::new(x0, y0, z0), GridPoint::new(x1, y1, z1));
        let ray = cast(&field, &from, Start::Space(Side::Unknown), &to, u32::MAX);
        let expected = brute_force(&heights, wraps, [x0, y0, z0], [x1, y1, z1]);
        match (ray.end, expected) {
            (RayEnd::Hit(triangle, point), Some(t)) => {
                prop_assert!((point.columns() - (x0 + t * (x1 - x0))).abs() < 1e-9);
                prop_assert!((point.rows() - (y0 + t * (y1 - y0))).abs() < 1e-9);
                prop_assert!((point.elevation - (z0 + t * (z1 - z0))).abs() < 1e-9);
                prop_assert!(field.is_present(&triangle));
            }
            (RayEnd::Clear(_), None) => {}
            (end, expected) => prop_assert!(false, "{end:?} but brute force {expected:?}"),
        }
    }

    #[test]
    fn a_ray_with_few_steps_reaches_the_same_end_in_several_goes(
        heights in heights(),
        (x0, x1) in (over_the_map(true), over_the_map(true)),
        (y0, y1) in (0.0..11.0f64, 0.0..11.0f64),
        z1 in -9.0..4.0f64,
        most_cells in 1u32..5,
    ) {
        let grid = grid(&heights, true);
        let field = Heightfield::<F64Little>::new(&grid);
        let to = GridPoint::new(x1, y1, z1);
        let mut from = GridPoint::new(x0, y0, 9.0);
        let mut side = Side::Unknown;
        let whole = cast(&field, &from, Start::Space(side), &to, u32::MAX);
        for _ in 0..200 {
            let part = cast(&field, &from, Start::Space(side), &to, most_cells);
            prop_assert!(part.cells <= most_cells);
            match (part.end, whole.end) {
                (RayEnd::OutOfSteps(point, kept), _) => (from, side) = (point, kept),
                (RayEnd::Hit(_, a), RayEnd::Hit(_, b)) => {
                    prop_assert!((a.columns() - b.columns()).abs() < 1e-9);
                    prop_assert!((a.rows() - b.rows()).abs() < 1e-9);
                    return Ok(());
                }
                (RayEnd::Clear(_), RayEnd::Clear(_)) => return Ok(()),
                (part, whole) => prop_assert!(false, "{part:?} but at once {whole:?}"),
            }
        }
        prop_assert!(false, "it never ended");
    }

    /// However a path is cut, a ray that is above stays above or hits: it never slips through.
    #[test]
    fn no_ray_slips_through_along_samples_edges_and_diagonals(
        heights in prop::collection::vec((-3i32..3).prop_map(f64::from), SIZE * SIZE),
        path in prop::collection::vec((0u8..=22, 0u8..=22, -8i32..12), 2..40),
    ) {
        let grid = grid(&heights, false);
        let field = Heightfield::<F64Little>::new(&grid);
        // Halves of cells: every vertex, edge and diagonal is met exactly.
        let points: Vec<_> = path.iter()
            .map(|&(x, y, z)| GridPoint::new(f64::from(x) / 2.0, f64::from(y) / 2.0, f64::from(z) / 2.0))
            .collect();
        let mut from = GridPoint { elevation: 9.0, ..points[0] };
        let mut side = Side::Above;
        for to in points {
            match cast(&field, &from, Start::Space(side), &to, u32::MAX).end {
                RayEnd::Hit(..) => (from, side) = (GridPoint { elevation: 9.0, ..to }, Side::Above),
                RayEnd::Clear(now) => {
                    prop_assert_eq!(now, Side::Above);
                    prop_assert!(to.elevation >= field.surface_elevation(&to) - 1e-12);
                    (from, side) = (to, now);
                }
                RayEnd::OutOfSteps(..) => prop_assert!(false),
            }
        }
    }
}
