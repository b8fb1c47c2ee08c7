//! Operators, comparisons and casts.

use crate::{
    machine::Machine,
    number::Number,
    value::{Integer, IntegerType, Outcome, Value, foreign},
};
use syn::{BinOp, UnOp};

impl Machine<'_> {
    pub(crate) fn unary(&mut self, unary: &syn::ExprUnary) -> Outcome<Value> {
        let value = self.expression(&unary.expr)?;
        match (unary.op, value) {
            (UnOp::Deref(_), value) => Ok(value),
            (UnOp::Neg(_), Value::Number(number)) => Ok(number.neg().into()),
            (UnOp::Neg(_), Value::Integer(Integer { value, of })) => {
                if of.is_some_and(|of| of.from == 0) {
                    return foreign("the negative of an unsigned integer");
                }
                Ok(Integer::checked(Some(-value), of)?.into())
            }
            (UnOp::Not(_), Value::Bool(truth)) => Ok(Value::Bool(!truth)),
            (_, value) => foreign(format!("an operator before {}", value.kind())),
        }
    }

    pub(crate) fn binary(&mut self, binary: &syn::ExprBinary) -> Outcome<Value> {
        match binary.op {
            BinOp::And(_) => {
                Ok(Value::Bool(self.expression(&binary.left)?.truth()? && self.expression(&binary.right)?.truth()?))
            }
            BinOp::Or(_) => {
                Ok(Value::Bool(self.expression(&binary.left)?.truth()? || self.expression(&binary.right)?.truth()?))
            }
            op => match Self::assigning(op) {
                Some(plain) => {
                    let right = self.expression(&binary.right)?;
                    let left = self.expression(&binary.left)?;
                    let value = self.operate(plain, &left, &right)?;
                    self.count_update(&binary.left);
                    self.store(&binary.left, value)?;
                    Ok(Value::Unit)
                }
                None => {
                    let (left, right) = (self.expression(&binary.left)?, self.expression(&binary.right)?);
                    let value = self.operate(op, &left, &right)?;
                    if let (BinOp::Mul(_), Value::Number(_)) = (op, &value) {
                        self.count_product([&binary.left, &binary.right]);
                    }
                    Ok(value)
                }
            },
        }
    }

    /// The operator of an assignment.
    fn assigning(op: BinOp) -> Option<BinOp> {
        Some(match op {
            BinOp::AddAssign(_) => BinOp::Add(Default::default()),
            BinOp::SubAssign(_) => BinOp::Sub(Default::default()),
            BinOp::MulAssign(_) => BinOp::Mul(Default::default()),
            BinOp::DivAssign(_) => BinOp::Div(Default::default()),
            BinOp::RemAssign(_) => BinOp::Rem(Default::default()),
            _ => return None,
        })
    }

    pub(crate) fn operate(&mut self, op: BinOp, left: &Value, right: &Value) -> Outcome<Value> {
        match (left, right) {
            (Value::Number(a), Value::Number(b)) if a.kind != b.kind => {
                foreign(format!("{:?} meets {:?}", a.kind, b.kind))
            }
            (Value::Number(a), Value::Number(b)) => self.numbers(op, a, b),
            (Value::Integer(a), Value::Integer(b)) => Self::integers(op, *a, *b),
            (Value::Bool(a), Value::Bool(b)) => match op {
                BinOp::Eq(_) => Ok(Value::Bool(a == b)),
                BinOp::Ne(_) => Ok(Value::Bool(a != b)),
                BinOp::BitXor(_) => Ok(Value::Bool(a ^ b)),
                BinOp::BitAnd(_) => Ok(Value::Bool(a & b)),
                BinOp::BitOr(_) => Ok(Value::Bool(a | b)),
                _ => foreign("an operator between truths"),
            },
            (left, right) => foreign(format!("{} meets {}", left.kind(), right.kind())),
        }
    }

    fn numbers(&mut self, op: BinOp, a: &Number, b: &Number) -> Outcome<Value> {
        self.count_operator(op);
        Ok(match op {
            BinOp::Add(_) => a.add(b).into(),
            BinOp::Sub(_) => a.sub(b).into(),
            BinOp::Mul(_) => a.mul(b).into(),
            BinOp::Div(_) => a.div(b).into(),
            BinOp::Rem(_) => {
                let (quotient, iterations) = (a.div(b).main, (a.main.value / b.main.value).round().into());
                self.on_edge |= quotient.is_near(iterations);
                a.rem(b).into()
            }
            op => Value::Bool(self.compared(op, a, b)?),
        })
    }

    /// A comparison, which may be one that rounding decides.
    pub(crate) fn compared(&mut self, op: BinOp, a: &Number, b: &Number) -> Outcome<bool> {
        self.on_edge |= a.main.is_near(b.main);
        let (a, b) = (a.main.value, b.main.value);
        Ok(match op {
            BinOp::Lt(_) => a < b,
            BinOp::Le(_) => a <= b,
            BinOp::Gt(_) => a > b,
            BinOp::Ge(_) => a >= b,
            BinOp::Eq(_) => a == b,
            BinOp::Ne(_) => a != b,
            _ => return foreign("an operator between numbers"),
        })
    }

    fn integers(op: BinOp, left: Integer, right: Integer) -> Outcome<Value> {
        let of = left.common(right)?;
        let (a, b) = (left.value, right.value);
        let value = match op {
            BinOp::Add(_) => a.checked_add(b),
            BinOp::Sub(_) => a.checked_sub(b),
            BinOp::Mul(_) => a.checked_mul(b),
            BinOp::Div(_) => a.checked_div(b),
            BinOp::Rem(_) => a.checked_rem(b),
            BinOp::Lt(_) => return Ok(Value::Bool(a < b)),
            BinOp::Le(_) => return Ok(Value::Bool(a <= b)),
            BinOp::Gt(_) => return Ok(Value::Bool(a > b)),
            BinOp::Ge(_) => return Ok(Value::Bool(a >= b)),
            BinOp::Eq(_) => return Ok(Value::Bool(a == b)),
            BinOp::Ne(_) => return Ok(Value::Bool(a != b)),
            _ => return foreign("an operator between integers"),
        };
        Ok(Integer::checked(value, of)?.into())
    }

    pub(crate) fn cast(value: Value, to: &syn::Type) -> Outcome<Value> {
        let name = quote::quote!(#to).to_string();
        let integer = IntegerType::named(&name);
        match (value, integer) {
            (Value::Integer(from), Some(to)) => Ok(Integer { value: to.wrapped(from.value), of: Some(to) }.into()),
            (Value::Bool(from), Some(to)) => Ok(Integer { value: i128::from(from), of: Some(to) }.into()),
            (Value::Number(from), Some(to)) if from.tangents.is_empty() => {
                let value = (from.main.value as i128).clamp(to.from, to.to);
                Ok(Integer { value, of: Some(to) }.into())
            }
            (Value::Integer(from), None) if name == "f64" => Ok(Value::plain(from.value as f64)),
            (value @ Value::Number(_), None) if name == "f64" => Ok(value),
            (value @ Value::Closure(_), None) if name == "_" => Ok(value),
            (value, _) => foreign(format!("{} as {name}", value.kind())),
        }
    }
}
