//! A golden subject's constructor, from its tokens in Rust to a call in C.

use super::bound::{Block, Bound, Constructor};
use super::form::Form;

/// What a golden subject is in C.
pub struct Call<'a> {
    pub warp: &'a Bound,
    pub constructor: &'a Constructor,
    /// A C expression for each parameter; `{…}` for arrays.
    pub arguments: Vec<String>,
}

/// A parameter as it stands in Rust.
enum Value {
    /// `v(word)` or `whole(number)`, with its type where it is named.
    Number {
        text: String,
        whole: bool,
        of: Option<String>,
    },
    Several(Vec<Value>),
}

/// The call of a subject, or why there is none.
pub fn call<'a>(block: &'a Block, rust: &str) -> Result<Call<'a>, String> {
    if let Some(reason) = block.reason {
        return Err(reason.into());
    }
    let mut tokens = Tokens(tokens(rust));
    let parsed = tokens.call(block.type_name);
    let (of, constructor, values) = parsed.ok_or("it is not one call of a constructor")?;
    let candidates = block.bound.iter().filter(|warp| matches(warp, &of));
    for warp in candidates {
        let of_name =
            |c: &&Constructor| c.name == constructor && c.parameters.len() == values.len();
        let Some(constructor) = warp.constructors.iter().find(of_name) else {
            continue;
        };
        let parameters = constructor.parameters.iter().zip(&values);
        let arguments = parameters.map(|((_, form), value)| argument(form, &form.lengths, value));
        if let Some(arguments) = arguments.collect() {
            return Ok(Call {
                warp,
                constructor,
                arguments,
            });
        }
    }
    Err("its parameters are of a type or a length that is not bound".into())
}

/// Whether a bound type may be the one with these arguments; `_` may be any.
fn matches(warp: &Bound, of: &[String]) -> bool {
    let bound = warp
        .of
        .split_once('<')
        .map_or("", |(_, of)| of.trim_end_matches('>'));
    let bound: Vec<&str> = bound
        .split(',')
        .map(str::trim)
        .filter(|of| !of.is_empty())
        .collect();
    of.is_empty()
        || of.len() == bound.len()
            && of
                .iter()
                .zip(bound)
                .all(|(of, bound)| of == "_" || of == bound)
}

fn argument(form: &Form, lengths: &[usize], value: &Value) -> Option<String> {
    match (value, lengths) {
        (Value::Several(values), [length, inner @ ..]) if values.len() == *length => {
            let values: Option<Vec<_>> = values.iter().map(|v| argument(form, inner, v)).collect();
            Some(format!("{{{}}}", values?.join(", ")))
        }
        (Value::Number { text, whole, of }, []) => {
            if of.as_ref().is_some_and(|of| named(of) != form.format) {
                return None;
            }
            Some(match form.base.as_str() {
                "float" => format!("{text}f"),
                base => {
                    let word = format!("(uint32_t)({})", unsigned(text));
                    let word = if *whole {
                        format!("({word} << 16)")
                    } else {
                        word
                    };
                    let shift = if base == "uint64_t" { " << 32" } else { "" };
                    format!("(({base}){word}{shift})")
                }
            })
        }
        _ => None,
    }
}

/// An expression of whole numbers, none of them signed.
fn unsigned(text: &str) -> String {
    let text = text.replace("u32::MAX", "0xffffffff");
    let mut unsigned = String::new();
    let mut inside = false;
    for c in text.chars().chain([' ']) {
        let now = c.is_ascii_alphanumeric();
        if inside && !now {
            unsigned.push('u');
        }
        inside = now;
        unsigned.push(c);
    }
    unsigned.trim_end().into()
}

/// The format of a type: `I16F16` is Q16.16.
fn named(of: &str) -> Option<String> {
    let (whole, fraction) = of.get(1..)?.split_once('F')?;
    let sign = if of.starts_with('U') { "U" } else { "" };
    Some(format!("{sign}Q{whole}.{fraction}"))
}

fn tokens(rust: &str) -> Vec<String> {
    let mut tokens = Vec::<String>::new();
    let mut joins = false;
    let mut chars = rust.chars().peekable();
    while let Some(c) = chars.next() {
        // A point, and the sign of an exponent, belong to a number.
        let last = tokens.last().map_or("", String::as_str);
        let number = last.starts_with(|c: char| c.is_ascii_digit()) && !last.starts_with("0x");
        let part = c.is_alphanumeric()
            || c == '_'
            || joins && number && (c == '.' || c == '-' && last.ends_with('e'));
        if c.is_whitespace() {
            joins = false;
        } else if part && joins {
            tokens.last_mut().unwrap().push(c);
        } else {
            let twice =
                matches!(c, ':' | '<') && chars.peek() == Some(&c) && (c == ':' || last != "::");
            tokens.push(if twice {
                [c, chars.next().unwrap()].iter().collect()
            } else {
                c.into()
            });
            joins = part;
        }
    }
    tokens.reverse();
    tokens
}

/// What is left to read, the next at the end.
struct Tokens(Vec<String>);

impl Tokens {
    fn take(&mut self, token: &str) -> Option<()> {
        if self.0.last()? == token {
            self.0.pop();
            Some(())
        } else {
            None
        }
    }

    /// `Type::<T, 2>::constructor(values)`, or that in an `Ok`. The tier and the grade are left out of the arguments.
    fn call(&mut self, of: &str) -> Option<(Vec<String>, String, Vec<Value>)> {
        let wrapped = self.take("Ok").is_some();
        if wrapped {
            self.take("(")?;
        }
        self.take(of)?;
        self.take("::")?;
        let mut arguments = Vec::new();
        if self.take("<").is_some() {
            while self.take(">").is_none() {
                let argument = self.0.pop()?;
                if !["T", "G", ","].contains(&argument.as_str()) {
                    arguments.push(argument);
                }
            }
            self.take("::")?;
        }
        let constructor = self.0.pop()?;
        self.take("(")?;
        let values = self.values(")")?;
        if wrapped {
            self.take(")")?;
        }
        self.0
            .is_empty()
            .then_some((arguments, constructor, values))
    }

    fn values(&mut self, end: &str) -> Option<Vec<Value>> {
        let mut values = Vec::new();
        while self.take(end).is_none() {
            values.push(self.value()?);
            if self.take(";").is_some() {
                let count = self.0.pop()?.parse().ok()?;
                let Some(Value::Number { text, whole, of }) = values.pop() else {
                    return None;
                };
                let same = || Value::Number {
                    text: text.clone(),
                    whole,
                    of: of.clone(),
                };
                values.extend(std::iter::repeat_with(same).take(count));
            }
            let _ = self.take(",");
        }
        Some(values)
    }

    fn value(&mut self) -> Option<Value> {
        if self.take("[").is_some() {
            return self.values("]").map(Value::Several);
        }
        let function = self.0.pop()?;
        if !["v", "whole", "black_box"].contains(&function.as_str()) {
            return None;
        }
        let mut of = None;
        if self.take("::").is_some() {
            self.take("<")?;
            of = self.0.pop();
            self.take(">")?;
        }
        self.take("(")?;
        let (mut text, mut depth) = (String::new(), 1);
        loop {
            let token = self.0.pop()?;
            match token.as_str() {
                "(" => depth += 1,
                ")" => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                break;
            }
            let digit = token.starts_with(|c: char| c.is_ascii_digit());
            text += &if digit { token.replace('_', "") } else { token };
        }
        let whole = function == "whole";
        Some(Value::Number { text, whole, of })
    }
}
