//! Best approximation in the maximum norm over a set of points, by exchange; and what rounding the
//! coefficients, one after the other, leaves of it. Which functions are fitted is not known here, nor to what the
//! coefficients are rounded.

/// A weighted linear approximation problem: choose c so that the largest |weight (c·basis - target)| is small.
pub struct Problem {
    /// Basis functions times weight, a row per point.
    rows: Vec<Vec<f64>>,
    /// Target times weight.
    right: Vec<f64>,
}

/// The points of an interval where polynomials are best sampled, dense at the ends.
pub fn points([low, high]: [f64; 2]) -> Vec<f64> {
    const COUNT: u32 = 1500;
    (0..=COUNT)
        .map(|i| {
            // A quarter wave squared, from the half-angle form: 0 at the first point, 1 at the last.
            let half = f64::from(i) / f64::from(COUNT) * std::f64::consts::FRAC_PI_2;
            low + (high - low) * libm::sin(half) * libm::sin(half)
        })
        .collect()
}

impl Problem {
    pub fn new(points: impl Iterator<Item = (Vec<f64>, f64, f64)>) -> Self {
        let (rows, right) = points
            .map(|(basis, target, weight)| {
                (basis.iter().map(|b| b * weight).collect(), target * weight)
            })
            .unzip();
        Self { rows, right }
    }

    /// The signed errors of coefficients.
    fn errors(&self, c: &[f64]) -> Vec<f64> {
        self.rows
            .iter()
            .zip(&self.right)
            .map(|(row, right)| row.iter().zip(c).map(|(a, b)| a * b).sum::<f64>() - right)
            .collect()
    }

    pub fn largest_error(&self, c: &[f64]) -> f64 {
        self.errors(c).iter().fold(0.0, |m, e| m.max(e.abs()))
    }

    /// The problem that is left when some coefficients are given.
    fn with_fixed(&self, fixed: &[Option<f64>]) -> Self {
        let rows = self.rows.iter().map(|row| {
            let free = row.iter().zip(fixed).filter(|(_, f)| f.is_none());
            free.map(|(a, _)| *a).collect()
        });
        let right = self.rows.iter().zip(&self.right).map(|(row, right)| {
            let given = row.iter().zip(fixed);
            right - given.map(|(a, f)| f.map_or(0.0, |f| a * f)).sum::<f64>()
        });
        Self {
            rows: rows.collect(),
            right: right.collect(),
        }
    }

    /// The best coefficients, by the exchange algorithm of Remez on the given points.
    pub fn solve(&self) -> Vec<f64> {
        let unknowns = self.rows.first().map_or(0, Vec::len);
        let last = self.rows.len() - 1;
        let mut reference: Vec<usize> = (0..=unknowns)
            .map(|i| last * (2 * i + 1) / (2 * unknowns + 2))
            .collect();
        let mut best = (f64::INFINITY, vec![0.0; unknowns]);
        for _ in 0..60 {
            let mut c = self.levelled(&reference);
            c.truncate(unknowns);
            let errors = self.errors(&c);
            let largest = errors.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
            if largest < best.0 {
                best = (largest, c);
            }
            let next = exchanged(&errors, &reference);
            if next == reference {
                break;
            }
            reference = next;
        }
        best.1
    }

    /// The coefficients whose errors at the reference points are equal with alternating signs.
    fn levelled(&self, reference: &[usize]) -> Vec<f64> {
        let mut sign = 1.0;
        let system = reference.iter().map(|&i| {
            let mut row = self.rows[i].clone();
            row.extend([sign, self.right[i]]);
            sign = -sign;
            row
        });
        eliminate(system.collect())
    }

    /// Coefficients that are all rounded: each in turn, and the rest fitted anew. `fixed` are given from the
    /// start.
    pub fn solve_rounded(&self, fixed: &[Option<f64>], round: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut fixed = fixed.to_vec();
        while let Some(next) = fixed.iter().position(Option::is_none) {
            let c = self.with_fixed(&fixed).solve();
            // The first unknown of the remaining problem is the coefficient at `next`.
            fixed[next] = Some(round(c[0]));
        }
        fixed.into_iter().map(|f| f.unwrap_or(0.0)).collect()
    }
}

/// New reference points: the largest error of every run of one sign, as many as are needed, in a row.
fn exchanged(errors: &[f64], reference: &[usize]) -> Vec<usize> {
    let mut peaks: Vec<usize> = Vec::new();
    for (i, e) in errors.iter().enumerate() {
        match peaks.last_mut() {
            Some(peak) if (errors[*peak] > 0.0) == (*e > 0.0) => {
                if e.abs() > errors[*peak].abs() {
                    *peak = i;
                }
            }
            _ => peaks.push(i),
        }
    }
    while peaks.len() > reference.len() {
        let (first, last) = (peaks[0], peaks[peaks.len() - 1]);
        if errors[first].abs() < errors[last].abs() {
            peaks.remove(0);
        } else {
            peaks.pop();
        }
    }
    if peaks.len() < reference.len() {
        return reference.to_vec();
    }
    peaks
}

/// Gaussian elimination with partial pivoting; the last column is the right side.
fn eliminate(mut m: Vec<Vec<f64>>) -> Vec<f64> {
    let n = m.len();
    for column in 0..n {
        // Rows are compared relative to their largest entry, as their scales differ widely.
        let weight = |row: &Vec<f64>| {
            let scale = row[..n]
                .iter()
                .fold(f64::MIN_POSITIVE, |s, a| s.max(a.abs()));
            row[column].abs() / scale
        };
        let pivot = (column..n)
            .max_by(|&a, &b| weight(&m[a]).total_cmp(&weight(&m[b])))
            .unwrap_or(column);
        m.swap(column, pivot);
        let pivot = m[column].clone();
        for row in &mut m[column + 1..] {
            let factor = row[column] / pivot[column];
            for (a, b) in row.iter_mut().zip(&pivot) {
                *a -= factor * b;
            }
        }
    }
    for column in (0..n).rev() {
        let known: f64 = (column + 1..n).map(|j| m[column][j] * m[j][n]).sum();
        m[column][n] = (m[column][n] - known) / m[column][column];
    }
    m.iter().map(|row| row[n]).collect()
}
