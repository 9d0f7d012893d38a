//! A logarithmic axis: every axis of the reports covers powers of ten.

use crate::report::number::error;
/// A logarithmic axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis<'a> {
    /// The first and the last value.
    pub range: [f64; 2],
    /// The pixels of these values.
    pub pixels: [f64; 2],
    /// The quantity on the axis, with its unit.
    pub name: &'a str,
    /// The maximum number of powers of ten that are ticks.
    pub room: usize,
    /// The ticks, if they are not powers of ten.
    pub given: &'a [f64],
    /// The format of the values.
    pub label: fn(f64) -> String,
}

impl Axis<'_> {
    /// The smallest and the largest of the positive `values`; 1 and 10 if there are none.
    pub fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
        let positive = values.filter(|value| *value > 0.0 && value.is_finite());
        let ends = positive.fold([f64::INFINITY, 0.0_f64], |[least, most], x| [least.min(x), most.max(x)]);
        if ends[0] > ends[1] { [1.0, 10.0] } else { ends }
    }

    /// The powers of ten that enclose all positive `values`. Other values are ignored.
    pub fn decades(values: impl Iterator<Item = f64>) -> [f64; 2] {
        let [least, most] = Self::ends(values);
        // A value at a power of ten is at the end of the axis, independently of the rounding of its logarithm.
        let low = (least.log10() + 1e-9).floor();
        let high = (most.log10() - 1e-9).ceil().max(low + 1.0);
        [low, high].map(|power| 10_f64.powf(power))
    }

    /// The values 1, 2 and 5 times powers of ten from below the smallest of `values` to above the largest.
    pub fn steps(values: impl Iterator<Item = f64>) -> Vec<f64> {
        let [least, most] = Self::ends(values);
        let [low, high] = Self::decades([least, most].into_iter());
        let mut steps = vec![low];
        while steps[steps.len() - 1] < 0.999 * high {
            let last = steps[steps.len() - 1];
            let is_two = format!("{last:e}").starts_with('2');
            steps.push(last * if is_two { 2.5 } else { 2.0 });
        }
        let first = steps.iter().rposition(|step| *step <= 1.001 * least).unwrap_or(0);
        let last = steps.iter().position(|step| 1.001 * *step >= most).unwrap_or(steps.len() - 1);
        steps[first..=last.max(first + 1).min(steps.len() - 1)].to_vec()
    }

    /// The pixel of a value.
    pub fn at(&self, value: f64) -> f64 {
        let ([low, high], [from, to]) = (self.range, self.pixels);
        from + (to - from) * (value / low).ln() / (high / low).ln()
    }

    /// The values of the ticks, with their labels.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let [low, high] = self.range.map(f64::log10);
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let [first, last] = [(low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32];
        let powers: Vec<f64> = (first..=last).map(|power| 10_f64.powi(power)).collect();
        let step = powers.len().div_ceil(self.room.max(1)).max(1);
        let values: Vec<f64> = match self.given {
            [] => powers.into_iter().step_by(step).collect(),
            given => given.to_vec(),
        };
        values.into_iter().map(|value| (value, (self.label)(value))).collect()
    }
}

/// An axis of relative errors.
pub fn errors(range: [f64; 2], pixels: [f64; 2], name: &str, room: usize) -> Axis<'_> {
    let label = |value: f64| error(Some(value)).replace(".0e", "e");
    Axis { range, pixels, name, room, given: &[], label }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    fn axis(range: [f64; 2], room: usize) -> Axis<'static> {
        Axis { range, pixels: [0.0, 90.0], name: "", room, given: &[], label: |x| format!("{x}") }
    }

    #[test]
    fn decades_hold_every_value_and_no_more() {
        let of = |values: &[f64]| Axis::decades(values.iter().copied()).map(|x| x.log10().round().to_bits());
        assert_eq!(of(&[3e-6, 0.2]), [-6.0, 0.0].map(f64::to_bits));
        assert_eq!(of(&[1e-3, 1.0]), [-3.0, 0.0].map(f64::to_bits));
        assert_eq!(of(&[7.0, 0.0, f64::NAN]), [0.0, 1.0].map(f64::to_bits));
        assert_eq!(of(&[]), [0.0, 1.0].map(f64::to_bits));
    }

    #[test]
    fn steps_hold_every_value_and_no_more() {
        let of = |values: &[f64]| -> Vec<String> {
            Axis::steps(values.iter().copied()).iter().map(|step| format!("{step:.2}")).collect()
        };
        assert_eq!(of(&[0.3, 1.7]), ["0.20", "0.50", "1.00", "2.00"]);
        assert_eq!(of(&[5.0, 20.0]), ["5.00", "10.00", "20.00"]);
    }

    #[test]
    fn values_lie_where_their_logarithm_is_and_ticks_within_the_range() {
        let of = axis([1.0, 1000.0], 4);
        assert!((of.at(10.0) - 30.0).abs() < 1e-12 && (of.at(1000.0) - 90.0).abs() < 1e-12);
        let labels = |of: Axis| of.ticks().into_iter().map(|(_, label)| label).collect::<Vec<_>>();
        assert_eq!(labels(of), ["1", "10", "100", "1000"]);
        assert_eq!(labels(axis([1.0, 1000.0], 2)), ["1", "100"]);
        assert_eq!(labels(Axis { given: &[2.0, 4.0], ..axis([1.0, 10.0], 9) }), ["2", "4"]);
    }
}
