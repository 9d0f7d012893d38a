//! The shape of a matrix that is answered in place of the expected one.

use serde::Serialize;

/// The shape of an answered matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// Its upper triangle is right, and zero stands below.
    UpperTriangle,
    /// Its lower triangle is right, and zero stands above.
    LowerTriangle,
    /// Its diagonal is right, the entries above are doubled, and zero stands below.
    DoubledUpperTriangle,
    /// Its diagonal is right, the entries below are doubled, and zero stands above.
    DoubledLowerTriangle,
    /// Its diagonal is right, and all other entries are doubled.
    Doubled,
    /// It is not symmetric.
    Unsymmetric,
    /// The expected matrix is not symmetric, but its lower triangle stands above the diagonal too.
    LowerTriangleTwice,
    /// The same with the upper triangle.
    UpperTriangleTwice,
}

/// The largest difference of entries that are taken for equal, over the largest expected entry.
const SAME: f64 = 1e-4;

impl Shape {
    /// The shape of the answered matrix, row by row; nothing if it is an ordinary matrix.
    pub(super) fn of(answered: &[f64], expected: &[f64], size: usize) -> Option<Self> {
        let largest = expected.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        let mirror = |k: usize| (k % size) * size + k / size;
        if (0..expected.len()).any(|k| (expected[k] - expected[mirror(k)]).abs() > SAME * largest) {
            return Self::of_unsymmetric(answered, expected, size, largest);
        }
        // Without entries beside the diagonal there are no triangles.
        let is_beside = |k: usize| k / size != k % size;
        let has_beside = (0..expected.len()).any(|k| is_beside(k) && expected[k].abs() > SAME * largest);
        if answered.len() != size * size || answered.len() != expected.len() || !has_beside {
            return None;
        }
        let all = |factors: [f64; 2]| {
            (0..answered.len()).all(|k| {
                let (i, j) = (k / size, k % size);
                let factor = if i < j { factors[0] } else { factors[1] };
                let factor = if i == j { 1.0 } else { factor };
                (answered[k] - factor * expected[k]).abs() <= SAME * largest * factor.abs()
            })
        };
        let shapes = [
            ([1.0, 0.0], Self::UpperTriangle),
            ([0.0, 1.0], Self::LowerTriangle),
            ([2.0, 0.0], Self::DoubledUpperTriangle),
            ([0.0, 2.0], Self::DoubledLowerTriangle),
            ([2.0, 2.0], Self::Doubled),
        ];
        let triangle = shapes.into_iter().find(|(factors, _)| all(*factors)).map(|(_, shape)| shape);
        let is_apart = |k: usize| (answered[k] - answered[mirror(k)]).abs() > SAME * largest;
        triangle.or_else(|| (0..answered.len()).any(is_apart).then_some(Self::Unsymmetric))
    }

    /// The shape where the expected matrix is not symmetric.
    fn of_unsymmetric(answered: &[f64], expected: &[f64], size: usize, largest: f64) -> Option<Self> {
        let is_twice = |is_upper: bool| {
            answered.len() == expected.len()
                && (0..answered.len()).all(|k| {
                    let (i, j) = (k / size, k % size);
                    let is_copied = if is_upper { i < j } else { i > j };
                    let from = if is_copied { j * size + i } else { k };
                    (answered[k] - expected[from]).abs() <= SAME * largest
                })
        };
        let shapes = [(true, Self::LowerTriangleTwice), (false, Self::UpperTriangleTwice)];
        shapes.into_iter().find(|(is_upper, _)| is_twice(*is_upper)).map(|(_, shape)| shape)
    }

    /// What is answered, after the words "the Hessian of d".
    pub fn words(self) -> &'static str {
        match self {
            Self::UpperTriangle => "is an upper triangle alone: zero stands below the diagonal",
            Self::LowerTriangle => "is a lower triangle alone: zero stands above the diagonal",
            Self::DoubledUpperTriangle => {
                "is an upper triangle alone, with doubled entries beside the diagonal"
            }
            Self::DoubledLowerTriangle => {
                "is a lower triangle alone, with doubled entries beside the diagonal"
            }
            Self::Doubled => "has doubled entries beside the diagonal",
            Self::Unsymmetric => "is not symmetric",
            Self::LowerTriangleTwice => "has its lower triangle above the diagonal too; it is not symmetric",
            Self::UpperTriangleTwice => "has its upper triangle below the diagonal too; it is not symmetric",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Shape;

    #[test]
    fn shapes_are_named() {
        let right = [1.0, 2.0, 3.0, 2.0, 4.0, 5.0, 3.0, 5.0, 6.0];
        for (answered, shape) in [
            (right, None),
            ([1.5; 9], None),
            ([1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 0.0, 0.0, 6.0], Some(Shape::UpperTriangle)),
            ([1.0, 0.0, 0.0, 2.0, 4.0, 0.0, 3.0, 5.0, 6.0], Some(Shape::LowerTriangle)),
            ([1.0, 4.0, 6.0, 0.0, 4.0, 10.0, 0.0, 0.0, 6.0], Some(Shape::DoubledUpperTriangle)),
            ([1.0, 0.0, 0.0, 4.0, 4.0, 0.0, 6.0, 10.0, 6.0], Some(Shape::DoubledLowerTriangle)),
            ([1.0, 4.0, 6.0, 4.0, 4.0, 10.0, 6.0, 10.0, 6.0], Some(Shape::Doubled)),
            ([1.0, 2.0, 3.0, 2.0, 4.0, 5.0, 3.5, 5.0, 6.0], Some(Shape::Unsymmetric)),
        ] {
            assert_eq!(Shape::of(&answered, &right, 3), shape);
        }
        let unsymmetric = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
        for (answered, shape) in [
            ([1.0, 4.0, 7.0, 4.0, 5.0, 8.0, 7.0, 8.0, 9.0], Some(Shape::LowerTriangleTwice)),
            ([1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 3.0, 6.0, 9.0], Some(Shape::UpperTriangleTwice)),
            ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 8.0], None),
        ] {
            assert_eq!(Shape::of(&answered, &unsymmetric, 3), shape);
        }
        let diagonal = [1.0, 0.0, 0.0, 2.0];
        assert_eq!(Shape::of(&diagonal, &diagonal, 2), None);
    }
}
