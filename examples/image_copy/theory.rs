//! The exact error that a copy should have. For uniform proposals over the pixels, the eigenvectors of the
//! transition matrix are known in closed form.
//!
//! With the pixels in order of falling brightness, π the picture divided by its sum and S_k the sum of π from
//! the k-th on, λ_k = Σ_{j ≥ k} (1 − π_j/π_k)/N, to the right eigenvector (0, …, 0, S_{k+1}, −π_k, …, −π_k)
//! whose first entry other than 0 is the k-th.
//!
//! Source: J. S. Liu, "Metropolized Independent Sampling with Comparisons to Rejection Sampling and Importance
//! Sampling", 1996.

/// What a chain over the pixels of a picture should measure.
pub struct Theory {
    /// RMSE over the mean, times the root of the mutations a pixel: recorded plainly, with both states
    /// weighted, and of as many independent draws. But for a part in (mutations a pixel) · 10³ of it.
    pub error: [f64; 3],
    pub acceptance: f64,
    /// In how many steps the influence of the start shrinks to 1/e.
    pub relaxation: f64,
}

impl Theory {
    pub fn of(luminance: &[f32]) -> Self {
        let pixels = luminance.len() as f64;
        let mut pi: Vec<f64> = luminance.iter().map(|&l| f64::from(l)).collect();
        pi.retain(|&p| p > 0.0);
        pi.sort_by(|a, b| b.total_cmp(a));
        let sum: f64 = pi.iter().sum();
        pi.iter_mut().for_each(|p| *p /= sum);
        let count = pi.len();
        // Sums from the k-th on, of π and of π²; past the end they are 0.
        let (mut s, mut q) = (vec![0.0; count + 1], vec![0.0; count + 1]);
        for k in (0..count).rev() {
            s[k] = s[k + 1] + pi[k];
            q[k] = q[k + 1] + pi[k] * pi[k];
        }
        // The k brighter ones all accept with probability below 1; the rest is 1 − λ_k.
        let gap = |k: usize| (k as f64 + s[k] / pi[k]) / pixels;

        let (mut plain, mut decisions, mut independent, mut acceptance) = (0.0, 0.0, 0.0, 0.0);
        let mut before = Before::default();
        for i in 0..count {
            let (p, gap) = (pi[i], gap(i));
            let time = 2.0 / gap - 1.0;
            plain += time * p * s[i + 1] / s[i] + p * p * before.times;
            independent += p * (1.0 - p);
            acceptance += (i as f64 * p + s[i]) / pixels;

            // Recording plainly adds the noise of the decision, on which the chain's later way depends. With
            // h from (1 − P)h = g, g being 1 at pixel i and 0 elsewhere, a decision of acceptance a between
            // pixels whose g and h differ by dg and dh adds a(1 − a)(2 dg dh − dg²).
            let darker = (s[i + 1] - q[i + 1] / p) * time;
            let alpha = 2.0 * (p * before.ends + s[i + 1] / (gap * s[i])) - 1.0;
            let brighter = p
                * (alpha * (i as f64 - p * before.inverses)
                    + p * (before.betas - p * before.betas_over));
            decisions += (darker + brighter) / pixels;

            let beta = 2.0 * (1.0 / (gap * s[i]) - before.ends);
            before.inverses += 1.0 / p;
            before.betas += beta;
            before.betas_over += beta / p;
            if s[i + 1] > 0.0 {
                before.times += time * p / (s[i + 1] * s[i]);
                before.ends += p / (gap * s[i + 1] * s[i]);
            }
        }
        Self {
            error: [plain, plain - decisions, independent].map(f64::sqrt),
            acceptance,
            relaxation: -1.0 / (-gap(0)).ln_1p(),
        }
    }
}

/// Sums over the pixels that are brighter than the present one.
#[derive(Default)]
struct Before {
    times: f64,
    ends: f64,
    inverses: f64,
    betas: f64,
    betas_over: f64,
}
