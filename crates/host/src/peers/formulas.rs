//! The formulas as they stand in books, over whatever functions the module has that asks for them: `sqrt`, `sin_cos`
//! of radians, `ln` and `powf`.

macro_rules! formulas {
    () => {
        /// The unit disk: radius √u₁, angle 2πu₂.
        #[inline]
        pub fn disk([u1, u2]: [f32; 2]) -> [f32; 2] {
            let r = sqrt(u1);
            let (s, c) = sin_cos(std::f32::consts::TAU * u2);
            [r * c, r * s]
        }

        /// The unit circle: angle 2πu.
        #[inline]
        pub fn circle([u]: [f32; 1]) -> [f32; 2] {
            let (s, c) = sin_cos(std::f32::consts::TAU * u);
            [c, s]
        }

        /// The direction of height z, 2πu about the axis.
        #[inline]
        fn at_height(z: f32, u: f32) -> [f32; 3] {
            let r = sqrt(1.0 - z * z);
            let (s, c) = sin_cos(std::f32::consts::TAU * u);
            [r * c, r * s, z]
        }

        /// The unit sphere: z = 1 − 2u₁.
        #[inline]
        pub fn sphere([u1, u2]: [f32; 2]) -> [f32; 3] {
            at_height(1.0 - 2.0 * u1, u2)
        }

        /// The upper half of it: z = u₁.
        #[inline]
        pub fn hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
            at_height(u1, u2)
        }

        /// In proportion to the cosine: a point of the disk, lifted to √(1 − u₁).
        #[inline]
        pub fn cosine_hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
            let [x, y] = disk([u1, u2]);
            [x, y, sqrt(1.0 - u1)]
        }

        /// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): z = u₁^(1/(n + 1)).
        #[inline]
        pub fn lobe(exponent: f32, [u1, u2]: [f32; 2]) -> [f32; 3] {
            at_height(powf(u1, exponent), u2)
        }

        /// The exponential distribution of mean 1: −ln(1 − u).
        #[inline]
        pub fn exponential([u]: [f32; 1]) -> f32 {
            -ln(1.0 - u)
        }

        /// Two standard normals, by Box and Muller.
        #[inline]
        pub fn normal_pair([u1, u2]: [f32; 2]) -> [f32; 2] {
            let r = sqrt(-2.0 * ln(1.0 - u1));
            let (s, c) = sin_cos(std::f32::consts::TAU * u2);
            [r * c, r * s]
        }
    };
}
pub(crate) use formulas;
