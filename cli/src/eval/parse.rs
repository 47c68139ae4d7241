//! Requests: from a line of JSON to numbers that are known to be right in kind, count and range.

use crate::exponential::Exponential;
use serde_json::{Map, Value};
use sh_core::cap::Fit;
use std::f64::consts::{FRAC_PI_2, PI};

/// How far the length of a direction or quaternion may be from 1; it is then brought to 1.
const UNIT_TOLERANCE: f64 = 1e-4;

/// How far above π an angle may be, for angles that were rounded to single precision.
const ANGLE_TOLERANCE: f64 = 1e-6;

/// One thing to compute.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// SH order, 2 to 6.
    pub order: usize,
    /// What to compute.
    pub op: Op,
}

/// An operation with its arguments: vectors of order² numbers, zonal vectors of order numbers, unit
/// directions and quaternions, angles in radians.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// The basis functions at a direction.
    Basis([f64; 3]),
    /// The cosine lobe about a normal, over π.
    Cosine([f64; 3]),
    /// The projected product.
    Product(Vec<f64>, Vec<f64>),
    /// The product with itself.
    Square(Vec<f64>),
    /// ∫ f g h.
    Triple(Vec<f64>, Vec<f64>, Vec<f64>),
    /// A vector rotated by a quaternion (x, y, z, w).
    Rotate(Vec<f64>, [f64; 4]),
    /// A zonal vector turned to a direction.
    Zonal(Vec<f64>, [f64; 3]),
    /// The visibility past a circle of an angular radius.
    Cap(f64),
    /// The logarithm of that.
    CapLog(f64, CapLog),
    /// The logarithm of a vector.
    Log(Vec<f64>, LogMethod),
    /// The exponential of a vector.
    Exp(Vec<f64>, Exponential),
    /// A vector windowed to a width.
    Window(Vec<f64>, f64),
}

/// Ways to the logarithm of a cap's visibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CapLog {
    /// The polynomial that follows the eigen logarithm, for angles up to π/2.
    Fitted,
    /// The polynomial that is fitted to an exponential, for angles up to π/2.
    FittedTo(Fit),
    /// The eigen logarithm at whole degrees, interpolated.
    Table,
    /// Eigenanalysis.
    Eigen,
    /// Clipped samples, projected back.
    Samples,
}

/// Ways to the logarithm of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LogMethod {
    /// Eigenanalysis.
    Eigen,
    /// Clipped samples, projected back.
    Samples,
}

/// The fitted logarithms by name: `fitted:` and the exponential they are fitted to.
const FITS: [(&str, Fit); 6] = [
    ("fitted:saturating", Fit::Saturating),
    ("fitted:sampled", Fit::Sampled),
    ("fitted:ps*", Fit::Series),
    ("fitted:hyb", Fit::Hybrid),
    ("fitted:ol", Fit::OptimalLinear),
    ("fitted:eigen", Fit::Eigen),
];

/// Reads a line. The error is a sentence.
pub fn parse(line: &[u8]) -> Result<Request, String> {
    let text = std::str::from_utf8(line)
        .map_err(|error| format!("the line is not UTF-8 text: {error}"))?;
    if text.trim().is_empty() {
        return Err("the line is empty: a JSON object is needed".into());
    }
    let value: Value =
        serde_json::from_str(text).map_err(|error| format!("the line is not JSON: {error}"))?;
    let Value::Object(object) = value else {
        return Err(format!("the line is {}, not a JSON object", kind(&value)));
    };
    let name = match object.get("op") {
        Some(Value::String(name)) => name.as_str(),
        Some(other) => return Err(format!("`op` is {}, not a string", kind(other))),
        None => return Err("`op` is missing: it names what to compute".into()),
    };
    let mut fields = Fields {
        object: &object,
        order: 0,
        read: vec!["op", "order"],
    };
    // First the name: whoever misspells it should not be sent to look at the order.
    if !OPS.contains(&name) {
        return Err(format!(
            "`op` is \"{name}\", which is none of {}",
            OPS.join(", ")
        ));
    }
    fields.order = fields.order()?;
    let op = fields.op(name)?;
    if let Some(extra) = object
        .keys()
        .find(|key| !fields.read.contains(&key.as_str()))
    {
        return Err(format!("`{extra}` is not an argument of `{name}`"));
    }
    Ok(Request {
        order: fields.order,
        op,
    })
}

const OPS: [&str; 12] = [
    "basis", "cosine", "product", "square", "triple", "rotate", "zonal", "cap", "cap_log", "log",
    "exp", "window",
];

struct Fields<'a> {
    object: &'a Map<String, Value>,
    order: usize,
    /// What has been asked for: anything else in the object is a mistake.
    read: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    fn op(&mut self, name: &str) -> Result<Op, String> {
        Ok(match name {
            "basis" => Op::Basis(self.unit("dir")?),
            "cosine" => Op::Cosine(self.unit("dir")?),
            "product" => Op::Product(self.vector("f")?, self.vector("g")?),
            "square" => Op::Square(self.vector("f")?),
            "triple" => Op::Triple(self.vector("f")?, self.vector("g")?, self.vector("h")?),
            "rotate" => Op::Rotate(self.vector("f")?, self.unit("quat")?),
            "zonal" => Op::Zonal(self.numbers("z", self.order)?, self.unit("dir")?),
            "cap" => Op::Cap(self.angle()?),
            "cap_log" => {
                let angle = self.angle()?;
                Op::CapLog(angle, self.cap_log(angle)?)
            }
            "log" => Op::Log(self.vector("f")?, self.log()?),
            "exp" => Op::Exp(self.vector("f")?, self.exponential()?),
            _ => {
                let f = self.vector("f")?;
                let h = number("h", self.get("h")?)?;
                if h <= 0.0 {
                    return Err(format!("`h` is {h}, but a window's width must be positive"));
                }
                Op::Window(f, h)
            }
        })
    }

    fn get(&mut self, field: &'static str) -> Result<&'a Value, String> {
        self.read.push(field);
        self.object
            .get(field)
            .ok_or_else(|| format!("`{field}` is missing"))
    }

    fn order(&mut self) -> Result<usize, String> {
        let value = self.get("order")?;
        match value.as_u64() {
            Some(order @ 2..=6) => Ok(order as usize),
            _ => Err(format!(
                "`order` is {value}; the orders are 2, 3, 4, 5 and 6"
            )),
        }
    }

    /// A vector of order² numbers.
    fn vector(&mut self, field: &'static str) -> Result<Vec<f64>, String> {
        self.numbers(field, self.order * self.order)
    }

    fn numbers(&mut self, field: &'static str, count: usize) -> Result<Vec<f64>, String> {
        let value = self.get(field)?;
        let Value::Array(items) = value else {
            return Err(format!(
                "`{field}` is {}, not an array of {count} numbers",
                kind(value)
            ));
        };
        if items.len() != count {
            let reason = match field {
                "dir" | "quat" => String::new(),
                _ => format!(" at order {}", self.order),
            };
            return Err(format!(
                "`{field}` has {} numbers; it needs {count}{reason}",
                items.len()
            ));
        }
        let each = items.iter().enumerate();
        each.map(|(i, item)| number(&format!("{field}[{i}]"), item))
            .collect()
    }

    /// A direction or quaternion, brought to length 1 exactly.
    fn unit<const N: usize>(&mut self, field: &'static str) -> Result<[f64; N], String> {
        let numbers = self.numbers(field, N)?;
        let length = numbers.iter().fold(0.0, |length: f64, x| length.hypot(*x));
        if (length - 1.0).abs() > UNIT_TOLERANCE {
            return Err(format!(
                "`{field}` has length {length}; it must be a unit vector"
            ));
        }
        Ok(std::array::from_fn(|i| numbers[i] / length))
    }

    fn angle(&mut self) -> Result<f64, String> {
        let angle = number("angle", self.get("angle")?)?;
        if (0.0..=PI + ANGLE_TOLERANCE).contains(&angle) {
            Ok(angle.min(PI))
        } else {
            Err(format!(
                "`angle` is {angle}; an angular radius lies between 0 and π radians"
            ))
        }
    }

    /// The text of `method`, where there is one.
    fn method(&mut self) -> Result<Option<&'a str>, String> {
        self.read.push("method");
        match self.object.get("method") {
            None | Some(Value::Null) => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(other) => Err(format!("`method` is {}, not a string", kind(other))),
        }
    }

    fn cap_log(&mut self, angle: f64) -> Result<CapLog, String> {
        // Single precision's π/2 counts as π/2.
        let fits = angle <= FRAC_PI_2 + ANGLE_TOLERANCE;
        match self.method()? {
            None if fits => Ok(CapLog::Fitted),
            None => Ok(CapLog::Table),
            Some(name) if name.starts_with("fitted") && !fits => Err(format!(
                "`angle` is {angle}, but the fitted logarithms end at π/2: use the method table, eigen or samples"
            )),
            Some("fitted") => Ok(CapLog::Fitted),
            Some("table") => Ok(CapLog::Table),
            Some("eigen") => Ok(CapLog::Eigen),
            Some("samples") => Ok(CapLog::Samples),
            Some(other) => match FITS.iter().find(|(name, _)| *name == other) {
                Some((_, fit)) => Ok(CapLog::FittedTo(*fit)),
                None => Err(format!(
                    "`method` is \"{other}\", which is none of fitted, {}, table, eigen, samples",
                    FITS.map(|(name, _)| name).join(", ")
                )),
            },
        }
    }

    fn log(&mut self) -> Result<LogMethod, String> {
        match self.method()? {
            None | Some("eigen") => Ok(LogMethod::Eigen),
            Some("samples") => Ok(LogMethod::Samples),
            Some(other) => Err(format!(
                "`method` is \"{other}\", which is neither eigen nor samples"
            )),
        }
    }

    fn exponential(&mut self) -> Result<Exponential, String> {
        match self.method()? {
            None => Ok(Exponential::Factored(2)),
            Some(text) => {
                Exponential::parse(text, self.order).map_err(|error| format!("`method` is {error}"))
            }
        }
    }
}

fn number(field: &str, value: &Value) -> Result<f64, String> {
    match value.as_f64() {
        Some(x) if x.is_finite() => Ok(x),
        Some(_) => Err(format!("`{field}` is out of range")),
        None => Err(format!("`{field}` is {}, not a number", kind(value))),
    }
}

/// What a value is, with its article.
fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a truth value",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "an array",
        Value::Object(_) => "an object",
    }
}

impl Request {
    /// The request, where every number is within the range of single precision.
    pub fn in_single_precision(self) -> Result<Self, String> {
        let fits = |x: &f64| x.abs() <= f64::from(f32::MAX);
        let (numbers, more, most): (&[f64], &[f64], &[f64]) = match &self.op {
            Op::Product(f, g) => (f, g, &[]),
            Op::Triple(f, g, h) => (f, g, h),
            Op::Square(f) | Op::Rotate(f, _) | Op::Zonal(f, _) | Op::Log(f, _) | Op::Exp(f, _) => {
                (f, &[], &[])
            }
            Op::Window(f, h) => (f, std::slice::from_ref(h), &[]),
            Op::Basis(_) | Op::Cosine(_) | Op::Cap(_) | Op::CapLog(..) => (&[], &[], &[]),
        };
        match numbers.iter().chain(more).chain(most).find(|x| !fits(x)) {
            Some(x) => Err(format!("{x:e} is beyond the range of single precision")),
            None => Ok(self),
        }
    }
}
