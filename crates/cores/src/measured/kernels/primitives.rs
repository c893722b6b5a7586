//! The functions under the integer tier, in each grade.

use crate::measured::registry::kernels;
use fixed::types::{I2F30, U0F32, U5F27, U16F16};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};

kernels! {
    "fine_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Fine::sincos_turns(t);
    "fine_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Fine::atan2_turns(y, x);
    "fine_sqrt" (x: U0F32) -> U0F32 = Fine::sqrt(x);
    "fine_neg_ln_1m" (u: U0F32) -> U5F27 = Fine::neg_ln_1m(u);
    "fine_exp_neg" (x: U5F27) -> U0F32 = Fine::exp_neg(x);
    "fine_exp_m1_neg" (x: U5F27) -> U0F32 = Fine::exp_m1_neg(x);
    "fine_pow" (x: U0F32, y: U16F16) -> U0F32 = Fine::pow(x, y);
    "coarse_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Coarse::sincos_turns(t);
    "coarse_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Coarse::atan2_turns(y, x);
    "coarse_sqrt" (x: U0F32) -> U0F32 = Coarse::sqrt(x);
    "coarse_neg_ln_1m" (u: U0F32) -> U5F27 = Coarse::neg_ln_1m(u);
    "coarse_exp_neg" (x: U5F27) -> U0F32 = Coarse::exp_neg(x);
    "coarse_exp_m1_neg" (x: U5F27) -> U0F32 = Coarse::exp_m1_neg(x);
    "coarse_pow" (x: U0F32, y: U16F16) -> U0F32 = Coarse::pow(x, y);
    "compact_sincos_turns" (t: U0F32) -> (I2F30, I2F30) = Compact::sincos_turns(t);
    "compact_atan2_turns" (y: I2F30, x: I2F30) -> U0F32 = Compact::atan2_turns(y, x);
    "compact_sqrt" (x: U0F32) -> U0F32 = Compact::sqrt(x);
    "compact_neg_ln_1m" (u: U0F32) -> U5F27 = Compact::neg_ln_1m(u);
    "compact_exp_neg" (x: U5F27) -> U0F32 = Compact::exp_neg(x);
    "compact_exp_m1_neg" (x: U5F27) -> U0F32 = Compact::exp_m1_neg(x);
    "compact_pow" (x: U0F32, y: U16F16) -> U0F32 = Compact::pow(x, y);
}
