//! The closest point of a triangle, plainly.
#![allow(dead_code, reason = "each test program uses a part of this")]

/// The closest point of a triangle: its plane's foot where that is inside, else the closest of the
/// three edges' closest points.
pub fn closest_on_triangle(point: [f64; 3], [a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let (ab, ac, ap) = (subtract(*b, *a), subtract(*c, *a), subtract(point, *a));
    let (bb, bc, cc) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
    let (pb, pc) = (dot(ap, ab), dot(ap, ac));
    let determinant = bb * cc - bc * bc;
    let (s, t) = ((pb * cc - pc * bc) / determinant, (pc * bb - pb * bc) / determinant);
    if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
        return [0, 1, 2].map(|axis| a[axis] + s * ab[axis] + t * ac[axis]);
    }
    let candidates = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        let edge = subtract(*to, *from);
        let share = (dot(subtract(point, *from), edge) / dot(edge, edge)).clamp(0.0, 1.0);
        [0, 1, 2].map(|axis| from[axis] + share * edge[axis])
    });
    let distance = |candidate: &[f64; 3]| length(subtract(point, *candidate));
    *candidates.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap()
}

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
