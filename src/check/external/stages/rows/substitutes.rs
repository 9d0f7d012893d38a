//! What is taken for a vector or a number by mistake.

use crate::check::external::stages::terms::{Number, Vector};
use crate::linearization::Quantity;

/// Vectors that are taken for this one by mistake.
pub(super) fn substitutes(of: Vector) -> Vec<Vector> {
    match of {
        Vector::X(beam) => vec![Vector::X(1 - beam)],
        Vector::T(beam, order) => {
            let mut all: Vec<_> = (0..3).filter(|k| *k != order).map(|k| Vector::T(beam, k)).collect();
            all.extend((0..3).map(|k| Vector::T(1 - beam, k)));
            all
        }
        Vector::U(side, beam, order) => {
            let mut all: Vec<_> = (0..3).filter(|k| *k != order).map(|k| Vector::U(side, beam, k)).collect();
            all.extend([Vector::U(side, 1 - beam, order), Vector::U(1 - side, beam, order)]);
            all
        }
        _ => vec![],
    }
}

/// Numbers that are taken for this one by mistake.
pub(super) fn substitutes_of(of: Number) -> Vec<Number> {
    use Quantity::{GT, GTBar, T, TBar, Xi, XiBar};
    match of {
        Number::Of(quantity, part) => {
            let twin = match quantity {
                Xi => XiBar,
                XiBar => Xi,
                T => TBar,
                TBar => T,
                GT => GTBar,
                GTBar => GT,
                other => other,
            };
            let mut all = Vec::new();
            if twin != quantity {
                all.push(Number::Of(twin, part));
            }
            if part == 1 || part == 2 {
                all.extend([Number::Of(quantity, 3 - part), Number::Of(quantity, 0)]);
                if twin != quantity {
                    all.push(Number::Of(twin, 3 - part));
                }
            }
            all
        }
        Number::Radius(beam) => vec![Number::Radius(1 - beam)],
        Number::Moved(beam, _) => {
            vec![
                Number::Moved(1 - beam, 1 - beam),
                Number::Moved(beam, 1 - beam),
                Number::Moved(1 - beam, beam),
            ]
        }
        _ => vec![],
    }
}
