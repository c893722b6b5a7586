//! The cells that states are counted in, with their exact probabilities.

/// What a batch is counted in.
pub struct Cells<X> {
    /// The coarse and the fine cell of a state; nothing outside the target's domain.
    pub place: Box<dyn Fn(X) -> Option<[usize; 2]>>,
    /// The exact probabilities of both.
    pub exact: [Vec<f64>; 2],
    /// Two functions of the state whose autocorrelation is measured.
    pub watched: Box<dyn Fn(X) -> [f32; 2]>,
    /// The exact variance of the first.
    pub variance: f64,
}

impl<X: Copy + 'static> Cells<X> {
    /// Equal cells in coordinates that make the target uniform.
    pub fn uniform<const A: usize>(uniforms: impl Fn(X) -> [f64; A] + Clone + 'static) -> Self {
        let (coarse, fine): (&[usize], &[usize]) = match A {
            1 => (&[20], &[120]),
            _ => (&[5, 4], &[12, 10]),
        };
        let dimensions = [coarse, fine];
        let exact = dimensions.map(|d| {
            let count: usize = d.iter().product();
            vec![1.0 / count as f64; count]
        });
        let of_place = uniforms.clone();
        let place = move |x| {
            let u = of_place(x);
            let inside = u.iter().all(|u| (0.0..=1.0).contains(u));
            inside.then(|| {
                dimensions.map(|counts| {
                    let along = u.iter().zip(counts);
                    along.fold(0, |cell, (u, &count)| {
                        cell * count + ((u * count as f64) as usize).min(count - 1)
                    })
                })
            })
        };
        Self {
            place: Box::new(place),
            exact,
            watched: Box::new(move |x| {
                let u = uniforms(x);
                [u[0] as f32, u[A - 1] as f32]
            }),
            variance: 1.0 / 12.0,
        }
    }
}

impl Cells<usize> {
    /// Indices, each a fine cell, in groups that are spread over them.
    pub fn indices(weights: &[f64], groups: usize) -> Self {
        let total: f64 = weights.iter().sum();
        let fine: Vec<f64> = weights.iter().map(|w| w / total).collect();
        let mut coarse = vec![0.0; groups];
        for (i, p) in fine.iter().enumerate() {
            coarse[i % groups] += p;
        }
        let count = weights.len();
        let moment = |power| -> f64 {
            let terms = (0..).zip(&fine).map(|(i, p)| p * f64::from(i).powi(power));
            terms.sum()
        };
        let variance = moment(2) - moment(1).powi(2);
        Self {
            place: Box::new(move |i| (i < count).then_some([i % groups, i])),
            exact: [coarse, fine],
            watched: Box::new(|i| [i as f32, (i % 7) as f32]),
            variance,
        }
    }
}
