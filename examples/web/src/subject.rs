//! The subjects by name.

/// The parameters of a subject, in the order in which the page lists them.
pub type Parameters = [f32; 16];

macro_rules! subjects {
    ($($name:ident)*) => {
        /// What can be sampled; its number is its place among the names.
        #[derive(Clone, Copy, PartialEq, Eq)]
        pub enum Subject { $($name),* }

        impl Subject {
            const ALL: &[Self] = &[$(Self::$name),*];
        }

        /// All names, separated by spaces.
        pub static NAMES: &str = concat!($(stringify!($name), " "),*);
    };
}

subjects! {
    Interval IntervalDecreasing Power PowerDecreasing PowerMax Exponential ExponentialTail StandardExponential
    TruncatedExponential Tent Linear Normal Inversion Transform
    Disk DiskConcentric FloatDisk Triangle TriangleOn NormalPair StandardNormalPair Aabb MarginalConditional
    Sphere Hemisphere CosineHemisphere MalleyHemisphere PhongLobe Cone SphericalPatch Oriented
    Cdf Alias PiecewiseConstant1d PiecewiseConstant2d SelectOnce Reservoir
    DiskRejection BallRejection Region Bounded IntegerDiskRejection IntegerDiskRejection16
    Chain IntegerChain
}

impl Subject {
    /// The subject of a number, if there is one.
    pub fn of(number: u32) -> Option<Self> {
        Self::ALL.get(number as usize).copied()
    }
}
