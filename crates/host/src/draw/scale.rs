//! Axes: where a number lies along one, and the round numbers that are written beside it.

/// A linear or logarithmic axis, from 0 at one end to 1 at the other.
#[derive(Clone, Copy)]
pub struct Scale {
    pub from: f64,
    pub to: f64,
    pub log: bool,
}

impl Scale {
    /// The number that is spaced evenly along the axis.
    pub fn even(self, x: f64) -> f64 {
        if self.log { x.log10() } else { x }
    }

    pub fn at(self, x: f64) -> f64 {
        let (from, to) = (self.even(self.from), self.even(self.to));
        (self.even(x) - from) / (to - from)
    }

    /// Round numbers along the axis, about `count` of them.
    pub fn ticks(self, count: f64) -> Vec<f64> {
        if self.log {
            let decades = self.to.log10() - self.from.log10();
            let step = (decades / count).ceil();
            multiples(self.from.log10(), self.to.log10(), step)
                .iter()
                .map(|e| 10f64.powf(*e))
                .collect()
        } else {
            multiples(
                self.from,
                self.to,
                round_step((self.to - self.from) / count),
            )
        }
    }

    pub fn label(self, x: f64) -> String {
        if !self.log {
            // Adding 0 turns -0 into 0.
            return format!("{}", (x * 1e6).round() / 1e6 + 0.0).replace('-', "−");
        }
        match x.log10().round() as i32 {
            e @ 0..=2 => format!("{}", 10_u32.pow(e as u32)),
            e => ten_to(e),
        }
    }
}

/// A power of ten as it is written.
pub fn ten_to(power: i32) -> String {
    let digit = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32('⁰' as u32 + c as u32 - '0' as u32).unwrap_or(c),
    };
    let raised: String = power.to_string().chars().map(digit).collect();
    format!("10{raised}")
}

/// 1, 2 or 5 times a power of ten, at least `least`.
pub fn round_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|&s| s >= 0.999 * least)
        .unwrap_or(least)
}

fn multiples(from: f64, to: f64, step: f64) -> Vec<f64> {
    let (first, last) = (
        (from / step - 1e-9).ceil() as i64,
        (to / step + 1e-9).floor() as i64,
    );
    (first..=last).map(|k| k as f64 * step).collect()
}
