//! Numbers that write a script for Gappa: each operation a line over real numbers and one with the rounding of `f32`.

use crate::number::Number;
use crate::range::Range;
use std::cell::RefCell;
use std::fmt::Write as _;
use std::io::Write as _;
use std::ops::{Add, Div, Mul, Sub};
use std::process::{Command, Stdio};

/// What a program writes: the lines so far, and what is known of its inputs. A flaw makes constants an ulp larger where they are
/// rounded.
#[derive(Default)]
pub struct Script {
    lines: RefCell<String>,
    known: RefCell<Vec<String>>,
    flawed: bool,
}

/// A number of a script: r for the real one of this place, and f for the rounded one.
#[derive(Clone, Copy)]
pub struct Written<'a> {
    script: &'a Script,
    place: usize,
}

/// A double in the notation of Gappa.
fn digits(x: f64) -> String {
    let exponent = (x.to_bits() >> 52 & 0x7ff) as i32 - 1075;
    let significand = x.to_bits() << 12 >> 12 | 1 << 52;
    if x == 0.0 {
        "0".into()
    } else {
        format!("{significand}b{exponent}")
    }
}

impl Script {
    pub fn new(flawed: bool) -> Self {
        Self {
            flawed,
            ..Self::default()
        }
    }

    /// A line for each of both numbers.
    fn line(&self, real: &str, rounded: &str) -> Written<'_> {
        let mut lines = self.lines.borrow_mut();
        let place = lines.lines().count() / 2;
        let _ = writeln!(lines, "r{place} = {real};\nf{place} {rounded};");
        Written {
            script: self,
            place,
        }
    }

    fn know(&self, x: &Written, Range { low, high }: Range) {
        let known = format!("r{} in [{}, {}]", x.place, digits(low), digits(high));
        self.known.borrow_mut().push(known);
    }

    /// A number of `f32`.
    pub fn input(&self, range: Range) -> Written<'_> {
        let place = self.lines.borrow().lines().count() / 2;
        let x = self.line(
            &format!("float<ieee_32, ne>(any{place})"),
            &format!("= r{place}"),
        );
        self.know(&x, range);
        x
    }

    /// The uniform and its complement, of which the smaller is given, and only the larger is rounded.
    pub fn complements(&self, range: Range, first: bool) -> [Written<'_>; 2] {
        let given = self.input(range);
        let Written { place, .. } = given;
        let rounded = if first { "float<ieee_32, ne>" } else { "" };
        let other = self.line(
            &format!("1 - r{place}"),
            &format!("{rounded}= 1 - f{place}"),
        );
        if first {
            [given, other]
        } else {
            [other, given]
        }
    }

    /// What Gappa proves of the error of a number, if it does.
    pub fn bound(&self, Written { place, .. }: Written) -> Option<f64> {
        let known = self.known.borrow().join(" /\\ ");
        let script = format!(
            "{}{{ {known} -> |f{place} - r{place}| in ? }}\n",
            self.lines.borrow()
        );
        let mut command = Command::new("gappa");
        let pipes = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut gappa = pipes.spawn().expect("gappa");
        gappa
            .stdin
            .take()
            .expect("a pipe")
            .write_all(script.as_bytes())
            .expect("gappa reads");
        let made = gappa.wait_with_output().expect("gappa ends");
        let said = [made.stdout, made.stderr]
            .map(|text| String::from_utf8_lossy(&text).into_owned())
            .concat();
        // Behind the upper end stands what it is in decimals.
        let (_, number) = said.split_once(" in [")?.1.rsplit_once('{')?;
        number.split(',').next()?.parse().ok()
    }
}

impl<'a> Written<'a> {
    fn with(self, operation: &str, other: Self) -> Self {
        let (a, b) = (self.place, other.place);
        self.script.line(
            &format!("r{a} {operation} r{b}"),
            &format!("float<ieee_32, ne>= f{a} {operation} f{b}"),
        )
    }
}

impl Number for Written<'_> {
    fn like(self, x: f32) -> Self {
        let ulp = if self.script.flawed {
            f32::EPSILON * x
        } else {
            0.0
        };
        self.script.line(
            &digits(x.into()),
            &format!("= {}", digits((x + ulp).into())),
        )
    }

    fn sqrt(self) -> Self {
        let a = self.place;
        self.script.line(
            &format!("sqrt(r{a})"),
            &format!("float<ieee_32, ne>= sqrt(f{a})"),
        )
    }

    fn below(self, _: Self) -> bool {
        unreachable!("programs that ask are not written")
    }
}

impl Add for Written<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with("+", other)
    }
}

impl Sub for Written<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.with("-", other)
    }
}

impl Mul for Written<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with("*", other)
    }
}

impl Div for Written<'_> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.with("/", other)
    }
}
