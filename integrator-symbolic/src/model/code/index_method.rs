//! Methods of the impl that compute an index, such as `y * self.width + x`.

use super::shape::typed_arguments;
use syn::{BinOp, Expr, ImplItemFn, ReturnType, Stmt, Type};

/// Whether a method computes an index in one expression of arithmetic.
pub(crate) fn is_index(helper: &ImplItemFn) -> bool {
    fn is_arithmetic(expression: &Expr) -> bool {
        match expression {
            Expr::Binary(binary) => {
                let is_operation =
                    matches!(binary.op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_));
                is_operation && is_arithmetic(&binary.left) && is_arithmetic(&binary.right)
            }
            Expr::Paren(inner) => is_arithmetic(&inner.expr),
            Expr::Group(inner) => is_arithmetic(&inner.expr),
            Expr::Field(field) => matches!(&*field.base, Expr::Path(_)),
            Expr::Path(_) | Expr::Lit(_) => true,
            _ => false,
        }
    }
    let is_usize = |ty: &Type| matches!(ty, Type::Path(path) if path.path.is_ident("usize"));
    let are_all = typed_arguments(helper).all(|argument| is_usize(&argument.ty))
        && matches!(&helper.sig.output, ReturnType::Type(_, ty) if is_usize(ty));
    are_all && matches!(&helper.block.stmts[..], [Stmt::Expr(expression, None)] if is_arithmetic(expression))
}
