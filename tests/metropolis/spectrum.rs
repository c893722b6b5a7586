//! Eigenvalues of small matrices in f64: by Jacobi's rotations, and by squaring a deflated matrix again and
//! again.

pub type Matrix = Vec<Vec<f64>>;

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut product = vec![vec![0.0; b[0].len()]; a.len()];
    for (row, out) in a.iter().zip(&mut product) {
        for (x, across) in row.iter().zip(b) {
            for (out, y) in out.iter_mut().zip(across) {
                *out += x * y;
            }
        }
    }
    product
}

/// A distribution that the matrix leaves as it is: where the lazy chain, which stays at every other step and
/// is therefore never periodic, ends up from the first state.
pub fn stationary(m: &Matrix) -> Vec<f64> {
    let mut lazy = m.clone();
    for (i, row) in lazy.iter_mut().enumerate() {
        row.iter_mut().for_each(|x| *x *= 0.5);
        row[i] += 0.5;
    }
    for _ in 0..60 {
        lazy = product(&lazy, &lazy);
        for row in &mut lazy {
            let sum: f64 = row.iter().sum();
            row.iter_mut().for_each(|x| *x /= sum);
        }
    }
    lazy.swap_remove(0)
}

/// The largest magnitude of an eigenvalue but one that is 1, of a matrix whose rows sum to 1.
///
/// Taking 1π away puts a 0 in place of that 1 and leaves all others; the norm of the 2^k-th power then tells
/// the largest.
pub fn second_by_powers(m: &Matrix) -> f64 {
    let pi = stationary(m);
    let mut power: Matrix = m
        .iter()
        .map(|row| row.iter().zip(&pi).map(|(x, p)| x - p).collect())
        .collect();
    let (mut log_norm, mut exponent) = (0.0, 1.0);
    for _ in 0..40 {
        let norm = power
            .iter()
            .flatten()
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        if norm == 0.0 {
            return 0.0;
        }
        power.iter_mut().flatten().for_each(|x| *x /= norm);
        log_norm += norm.ln() / exponent;
        power = product(&power, &power);
        exponent *= 2.0;
    }
    log_norm.exp()
}

/// The eigenvalues of a reversible chain, decreasing: those of D^{1/2} M D^{-1/2}, of which an entry is the
/// geometric mean of both directions.
pub fn by_rotations(m: &Matrix) -> Vec<f64> {
    let n = m.len();
    let mut s: Matrix = (0..n)
        .map(|i| (0..n).map(|j| (m[i][j] * m[j][i]).sqrt()).collect())
        .collect();
    for _ in 0..50 {
        for p in 0..n {
            for q in p + 1..n {
                if s[p][q] == 0.0 {
                    continue;
                }
                let theta = (s[q][q] - s[p][p]) / (2.0 * s[p][q]);
                let t = 1_f64.copysign(theta) / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                rotate(&mut s, p, q, c, t * c);
            }
        }
    }
    let mut values: Vec<f64> = (0..n).map(|i| s[i][i]).collect();
    values.sort_by(|a, b| b.total_cmp(a));
    values
}

fn rotate(s: &mut Matrix, p: usize, q: usize, cos: f64, sin: f64) {
    for row in s.iter_mut() {
        (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
    }
    let rows: Vec<(f64, f64)> = s[p].iter().copied().zip(s[q].iter().copied()).collect();
    s[p] = rows.iter().map(|(x, y)| cos * x - sin * y).collect();
    s[q] = rows.iter().map(|(x, y)| sin * x + cos * y).collect();
    (s[p][q], s[q][p]) = (0.0, 0.0);
}

/// The largest magnitude of an eigenvalue but the first, of a reversible chain.
pub fn second_by_rotations(m: &Matrix) -> f64 {
    let values = by_rotations(m);
    values[1..].iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Both against matrices whose eigenvalues are known, cycles and blocks included.
#[test]
fn eigenvalues_are_those_of_known_matrices() {
    // A walk on a ring of n with probability 1/2 either way has the eigenvalues cos(2πk/n).
    for n in [3, 5, 8] {
        let step = |i: usize, j: usize| (i + 1) % n == j || (j + 1) % n == i;
        let ring: Matrix = (0..n)
            .map(|i| (0..n).map(|j| if step(i, j) { 0.5 } else { 0.0 }).collect())
            .collect();
        let mut exact: Vec<f64> = (0..n)
            .map(|k| (2.0 * std::f64::consts::PI * k as f64 / n as f64).cos())
            .collect();
        exact.sort_by(|a, b| b.total_cmp(a));
        for (got, exact) in by_rotations(&ring).iter().zip(&exact) {
            assert!((got - exact).abs() <= 1e-14, "{n}: {got} {exact}");
        }
        let second = exact[1..].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!((second_by_powers(&ring) - second).abs() <= 1e-10);
    }
    let two = |a: f64, b: f64| vec![vec![1.0 - a, a], vec![b, 1.0 - b]];
    for (a, b) in [(0.1, 0.9), (1.0, 1.0), (0.0, 0.0), (0.3, 0.001)] {
        let second = (1.0_f64 - a - b).abs();
        for got in [
            second_by_powers(&two(a, b)),
            second_by_rotations(&two(a, b)),
        ] {
            assert!((got - second).abs() <= 1e-10, "{a} {b}: {got}");
        }
    }
}
