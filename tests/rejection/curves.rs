//! The curves that ziggurats cover, and their layers, in f64 and without the crate: `libm`'s functions, bisection.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

pub const LAYERS: usize = 256;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// e^(−x²/2) over x ≥ 0.
    Normal,
    /// e^(−x) over x ≥ 0.
    Exponential,
}

pub const CURVES: [Curve; 2] = [Curve::Normal, Curve::Exponential];

/// Layers of equal area: where the tail starts, the area, and the widths from the lowest, whose rectangle stands for
/// it and the tail, to the peak's, which is 0.
pub struct Geometry {
    pub start: f64,
    pub area: f64,
    pub widths: Vec<f64>,
}

impl Curve {
    pub fn height(self, x: f64) -> f64 {
        match self {
            Curve::Normal => libm::exp(-0.5 * x * x),
            Curve::Exponential => libm::exp(-x),
        }
    }

    pub fn at_height(self, height: f64) -> f64 {
        match self {
            Curve::Normal => (-2.0 * libm::log(height)).sqrt(),
            Curve::Exponential => -libm::log(height),
        }
    }

    /// The area beyond x.
    pub fn beyond(self, x: f64) -> f64 {
        match self {
            Curve::Normal => (0.5 * PI).sqrt() * libm::erfc(x * FRAC_1_SQRT_2),
            Curve::Exponential => libm::exp(-x),
        }
    }

    /// f(x)/f(width) − 1.
    pub fn excess(self, width: f64, x: f64) -> f64 {
        match self {
            Curve::Normal => libm::expm1(0.5 * (width - x) * (width + x)),
            Curve::Exponential => libm::expm1(width - x),
        }
    }

    /// The distribution function of the law, over the whole line for the normal one.
    pub fn cdf(self, x: f64) -> f64 {
        match self {
            Curve::Normal => 0.5 * libm::erfc(-x * FRAC_1_SQRT_2),
            Curve::Exponential => -libm::expm1(-x),
        }
    }

    /// The layers that start their tail at this place: how far the last is above the peak, and they.
    fn stacked(self, start: f64) -> (f64, Geometry) {
        let mut top = self.height(start);
        let area = start * top + self.beyond(start);
        let mut widths = vec![area / top, start];
        while widths.len() < LAYERS {
            top += area / widths[widths.len() - 1];
            if top >= 1.0 {
                break;
            }
            widths.push(self.at_height(top));
        }
        let left = (LAYERS + 1 - widths.len()) as f64;
        let over = top - 1.0 + left * area / widths[widths.len() - 1];
        widths.push(0.0);
        let geometry = Geometry {
            start,
            area,
            widths,
        };
        (over, geometry)
    }

    /// The layers that end at the peak.
    pub fn geometry(self) -> Geometry {
        let (mut low, mut high) = (3.0, 9.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            // The farther out the tail starts, the thinner the layers.
            if self.stacked(middle).0 > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (over, geometry) = self.stacked(high);
        assert!(over.abs() <= 1e-12, "{over}");
        geometry
    }
}

/// Every layer has the same area and the whole is the curve's, but for the wedges' upper parts.
#[test]
fn layers_have_equal_areas() {
    for curve in CURVES {
        let Geometry {
            start,
            area,
            widths,
        } = curve.geometry();
        assert_eq!(widths.len(), LAYERS + 1);
        assert!(widths.windows(2).all(|pair| pair[0] > pair[1]));
        for pair in widths[1..].windows(2) {
            let layer = pair[0] * (curve.height(pair[1]) - curve.height(pair[0]));
            assert!((layer / area - 1.0).abs() <= 1e-11, "{curve:?}: {layer}");
        }
        let lowest = start * curve.height(start) + curve.beyond(start);
        assert!((lowest / area - 1.0).abs() <= 1e-14);
        println!("{curve:?}: {start} {area}");
        // The published figures, of fewer digits.
        let published = match curve {
            Curve::Normal => [3.654_152_885_361, 0.004_928_673_233_99],
            Curve::Exponential => [7.697_117_470_131, 0.003_949_659_822_58],
        };
        for (value, published) in [start, area].into_iter().zip(published) {
            assert!((value / published - 1.0).abs() <= 1e-11, "{value}");
        }
    }
}
