//! Which side of the surface a ray ends on, where it meets a triangle, and through how many cells
//! it goes, in the places where rounding or the map's end could change that.

use surface::ray::{RayEnd, Side, Start, cast};
use surface::readers::F64Little;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Half, Heightfield, SampleType, Triangle};

const SIZE: u64 = 12;

fn grid(height: impl Fn(u64, u64) -> f64) -> Grid {
    let samples = (0..SIZE * SIZE).map(|sample| height(sample % SIZE, sample / SIZE));
    let bytes = samples.flat_map(f64::to_le_bytes).collect();
    let (sample, order) = (SampleType::F64, ByteOrder::Little);
    let layout = GridLayout::packed(SIZE, SIZE, 1.0, 1.0, sample, order).unwrap();
    Grid::from_vec(bytes, layout).unwrap()
}

fn flat() -> Grid {
    grid(|_, _| 0.0)
}

/// Flat ground with one void sample.
fn ground_with_a_hole() -> Grid {
    grid(|column, row| if (column, row) == (5, 5) { f64::NAN } else { 0.0 })
}

fn end(grid: &Grid, from: GridPoint, start: Start, to: GridPoint) -> RayEnd {
    cast(&Heightfield::<F64Little>::new(grid), &from, start, &to, u32::MAX).end
}

fn side(grid: &Grid, from: GridPoint, start: Start, to: GridPoint) -> Side {
    match end(grid, from, start, to) {
        RayEnd::Clear(side) => side,
        other => panic!("{other:?} from {from:?} to {to:?}"),
    }
}

#[test]
fn a_ray_that_leaves_the_rim_of_a_hole_is_on_no_side() {
    let grid = ground_with_a_hole();
    let hole = Triangle { column: 4, row: 5, half: Half::NorthEast };
    let rim = GridPoint::new(4.0, 5.0, 0.0);
    for elevation in [-1.0, 0.0, 1.0] {
        let to = GridPoint::new(4.7, 5.2, elevation);
        assert_eq!(side(&grid, rim, Start::Surface(hole), to), Side::Unknown);
    }
    // A rim whose height was rounded up is still the rim.
    let rounded_up = GridPoint { elevation: f64::MIN_POSITIVE, ..rim };
    let to = GridPoint::new(4.7, 5.2, 1.0);
    assert_eq!(side(&grid, rounded_up, Start::Surface(hole), to), Side::Unknown);
}

#[test]
fn a_ray_that_leaves_a_triangle_is_above_it() {
    let grid = flat();
    let triangle = Triangle { column: 4, row: 5, half: Half::NorthEast };
    let from = GridPoint::new(4.5, 5.25, 0.0);
    for (column, row) in [(4.7, 5.2), (4.1, 5.9), (9.3, 2.2), (1.3, 8.2)] {
        let to = GridPoint::new(column, row, 0.5);
        assert_eq!(side(&grid, from, Start::Surface(triangle), to), Side::Above);
    }
}

#[test]
fn a_ray_that_ends_off_the_map_is_on_no_side() {
    let grid = flat();
    let from = GridPoint::new(5.0, 5.5, 3.0);
    for (column, row) in [(20.0, 5.0), (-3.0, 5.0), (5.0, 14.0), (5.0, -2.0), (-4.0, 15.0)] {
        let to = GridPoint::new(column, row, 2.0);
        for start in [Side::Above, Side::Unknown] {
            assert_eq!(side(&grid, from, Start::Space(start), to), Side::Unknown);
        }
    }
    let on_the_border = GridPoint::new(11.0, 5.0, 2.0);
    assert_eq!(side(&grid, from, Start::Space(Side::Unknown), on_the_border), Side::Above);
}

/// The caller says which side the ray is on; its own height may be a rounding error off.
#[test]
fn a_ray_that_starts_under_a_triangle_by_rounding_meets_it_where_it_starts() {
    let grid = flat();
    let from = GridPoint::new(5.5, 5.25, -1e-15);
    let to = GridPoint::new(5.75, 5.3, -2e-15);
    match end(&grid, from, Start::Space(Side::Above), to) {
        RayEnd::Hit(_, point) => assert_eq!((point.columns(), point.rows()), (5.5, 5.25)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_ray_from_beyond_a_border_begins_in_the_cell_inside_it() {
    let grid = flat();
    let field = Heightfield::<F64Little>::new(&grid);
    for (from, to) in [
        ((14.0, 5.5), (8.5, 5.5)),
        ((-3.0, 5.5), (2.5, 5.5)),
        ((5.5, 14.0), (5.5, 8.5)),
        ((5.5, -3.0), (5.5, 2.5)),
        // Through a corner of the map, along the diagonal and across it.
        ((13.0, 13.0), (8.5, 8.5)),
        ((-2.0, -2.0), (2.5, 2.5)),
    ] {
        let ((u0, v0), (u1, v1)) = (from, to);
        let diagonal = u0 != u1 && v0 != v1;
        let (from, to) = (GridPoint::new(u0, v0, 9.0), GridPoint::new(u1, v1, 8.0));
        let ray = cast(&field, &from, Start::Space(Side::Unknown), &to, u32::MAX);
        let through = if diagonal { 5 } else { 3 };
        assert_eq!(ray.cells, through, "from {from:?} to {to:?}");
    }
}

#[test]
fn a_ray_from_beyond_a_border_that_ends_on_it_knows_its_side() {
    let grid = flat();
    for (column, row, from_column, from_row) in [
        (11.0, 5.5, 14.0, 5.5),
        (0.0, 5.5, -3.0, 5.5),
        (5.5, 11.0, 5.5, 14.0),
        (5.5, 0.0, 5.5, -3.0),
    ] {
        for (elevation, expected) in [(1.0, Side::Above), (-1.0, Side::Below)] {
            let from = GridPoint::new(from_column, from_row, elevation);
            let to = GridPoint::new(column, row, elevation);
            assert_eq!(side(&grid, from, Start::Space(Side::Unknown), to), expected, "{to:?}");
        }
    }
}

#[test]
fn a_ray_from_beyond_the_map_along_its_very_border_meets_it() {
    let grid = flat();
    for (from, to) in [
        ((11.0, -3.0), (11.0, 6.0)),
        ((0.0, -3.0), (0.0, 6.0)),
        ((-3.0, 11.0), (6.0, 11.0)),
        ((-3.0, 0.0), (6.0, 0.0)),
    ] {
        let (from, to) = (GridPoint::new(from.0, from.1, 5.0), GridPoint::new(to.0, to.1, -1.0));
        let ray = end(&grid, from, Start::Space(Side::Unknown), to);
        assert!(matches!(ray, RayEnd::Hit(..)), "{ray:?} from {from:?} to {to:?}");
    }
}
