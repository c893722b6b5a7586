//! Stationary distributions and second eigenvalues of small matrices in f64, by squaring them again and again.

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

/// The chain that stays at every other step, and is therefore never periodic.
pub fn lazy(m: &Matrix) -> Matrix {
    let mut lazy = m.clone();
    for (i, row) in lazy.iter_mut().enumerate() {
        row.iter_mut().for_each(|x| *x *= 0.5);
        row[i] += 0.5;
    }
    lazy
}

/// A distribution that the matrix leaves as it is: where the lazy chain ends up from the first state.
pub fn stationary(m: &Matrix) -> Vec<f64> {
    let mut lazy = lazy(m);
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
pub fn second(m: &Matrix) -> f64 {
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

/// Against matrices whose eigenvalues are known, cycles and blocks included.
#[test]
fn second_eigenvalues_are_those_of_known_matrices() {
    // A walk on a ring of n with probability 1/2 either way has the eigenvalues cos(2πk/n).
    for n in [3, 5, 8] {
        let step = |i: usize, j: usize| (i + 1) % n == j || (j + 1) % n == i;
        let ring: Matrix = (0..n)
            .map(|i| (0..n).map(|j| if step(i, j) { 0.5 } else { 0.0 }).collect())
            .collect();
        let exact = (1..n).map(|k| (std::f64::consts::TAU * k as f64 / n as f64).cos().abs());
        let exact = exact.fold(0.0, f64::max);
        assert!((second(&ring) - exact).abs() <= 1e-10, "{n}");
    }
    let two = |a: f64, b: f64| vec![vec![1.0 - a, a], vec![b, 1.0 - b]];
    for (a, b) in [(0.1, 0.9), (1.0, 1.0), (0.0, 0.0), (0.3, 0.001)] {
        let (got, exact) = (second(&two(a, b)), (1.0_f64 - a - b).abs());
        assert!((got - exact).abs() <= 1e-10, "{a} {b}: {got}");
    }
}
