//! The places of a source file that a switch can be put at, found in its syntax tree.

use crate::lines::{Lines, Range};
use crate::mutant::{Genre, Mutant};
use std::collections::HashMap;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// What a switch is put around.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// What a function does: all that is between its braces.
    Body,
    /// An arm of a match: its guard, or the end of its pattern.
    Arm {
        /// Its guard.
        guard: Option<Range>,
    },
    /// The guard of an arm.
    Guard,
    /// A field of a struct expression that has a base.
    Field {
        /// Its name.
        name: String,
        /// The base.
        base: Range,
        /// Its value; none if a variable has the field's name.
        value: Option<Range>,
    },
    /// Two operands and what is between them.
    Binary {
        /// The left operand.
        left: Range,
        /// The operator.
        operator: Range,
        /// The right operand.
        right: Range,
    },
    /// An operator before an operand.
    Unary {
        /// The operand.
        operand: Range,
    },
}

impl Shape {
    /// What is written further outside, where two shapes have the same bytes.
    pub fn rank(&self) -> u8 {
        match self {
            Self::Body => 0,
            Self::Arm { .. } => 1,
            Self::Guard => 2,
            Self::Field { .. } => 3,
            Self::Binary { .. } => 4,
            Self::Unary { .. } => 5,
        }
    }
}

/// The places of a file.
pub struct Sites<'a> {
    lines: &'a Lines<'a>,
    /// By kind and by the byte that cargo-mutants names as the start.
    found: HashMap<(u8, usize), (Range, Shape)>,
    /// Where only constants are allowed: no switch can be asked there.
    constant: Vec<Range>,
}

impl<'a> Sites<'a> {
    /// Finds them.
    pub fn of(file: &syn::File, lines: &'a Lines<'a>) -> Self {
        let mut sites = Self {
            lines,
            found: HashMap::new(),
            constant: vec![],
        };
        sites.visit_file(file);
        sites
    }

    /// Where a mutant is, if it can have a switch.
    pub fn at(&self, mutant: &Mutant) -> Option<(Range, Shape)> {
        let range = self.lines.of_mutant(mutant.span);
        let is_constant = |around: &Range| around.0 <= range.0 && range.1 <= around.1;
        if self.constant.iter().any(is_constant) || mutant.returns_opaque() {
            return None;
        }
        let rank = match mutant.genre {
            Genre::FnValue => return Some((range, Shape::Body)),
            Genre::MatchArm => 1,
            Genre::MatchArmGuard => 2,
            Genre::StructField => 3,
            Genre::BinaryOperator => 4,
            Genre::UnaryOperator => 5,
            Genre::Other => return None,
        };
        self.found.get(&(rank, range.0)).cloned()
    }

    fn add(&mut self, start: usize, range: Range, shape: Shape) {
        self.found.insert((shape.rank(), start), (range, shape));
    }

    fn bytes(&self, of: &impl Spanned) -> Range {
        self.lines.of_token(of.span())
    }

    fn is_constant(&mut self, part: &impl Spanned) {
        let range = self.bytes(part);
        self.constant.push(range);
    }
}

/// Whether a condition has a `let`, which cannot stand in parentheses.
fn has_let(condition: &syn::Expr) -> bool {
    match condition {
        syn::Expr::Let(_) => true,
        syn::Expr::Binary(both) => has_let(&both.left) || has_let(&both.right),
        _ => false,
    }
}

impl<'ast> Visit<'ast> for Sites<'_> {
    fn visit_expr_binary(&mut self, binary: &'ast syn::ExprBinary) {
        if !has_let(&binary.left) && !has_let(&binary.right) {
            let operator = self.bytes(&binary.op);
            let shape = Shape::Binary {
                left: self.bytes(&binary.left),
                operator,
                right: self.bytes(&binary.right),
            };
            self.add(operator.0, self.bytes(binary), shape);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'ast syn::ExprUnary) {
        let range = self.bytes(unary);
        let operand = self.bytes(&unary.expr);
        self.add(range.0, range, Shape::Unary { operand });
        visit::visit_expr_unary(self, unary);
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        let end = self.bytes(&arm.pat).1;
        let guard = arm.guard.as_ref().map(|(_, guard)| guard);
        if guard.is_none_or(|guard| !has_let(guard)) {
            let guard = guard.map(|guard| self.bytes(guard));
            let site = (end, guard.map_or(end, |guard| guard.1));
            self.add(self.bytes(arm).0, site, Shape::Arm { guard });
            if let Some(guard) = guard {
                self.add(guard.0, guard, Shape::Guard);
            }
        }
        visit::visit_arm(self, arm);
    }

    fn visit_expr_struct(&mut self, made: &'ast syn::ExprStruct) {
        for field in &made.fields {
            if let (Some(base), syn::Member::Named(name)) = (&made.rest, &field.member) {
                let range = self.bytes(field);
                let shape = Shape::Field {
                    name: name.to_string(),
                    base: self.bytes(base),
                    value: field.colon_token.map(|_| self.bytes(&field.expr)),
                };
                self.add(range.0, range, shape);
            }
        }
        visit::visit_expr_struct(self, made);
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if item.sig.constness.is_some() {
            self.is_constant(&item.block);
        }
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if item.sig.constness.is_some() {
            self.is_constant(&item.block);
        }
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        self.is_constant(&item.expr);
    }

    fn visit_item_static(&mut self, item: &'ast syn::ItemStatic) {
        self.is_constant(&item.expr);
    }

    fn visit_impl_item_const(&mut self, item: &'ast syn::ImplItemConst) {
        self.is_constant(&item.expr);
    }

    fn visit_trait_item_const(&mut self, item: &'ast syn::TraitItemConst) {
        if let Some((_, value)) = &item.default {
            self.is_constant(value);
        }
    }

    fn visit_expr_const(&mut self, block: &'ast syn::ExprConst) {
        self.is_constant(block);
    }

    fn visit_type_array(&mut self, array: &'ast syn::TypeArray) {
        self.is_constant(&array.len);
    }

    fn visit_expr_repeat(&mut self, array: &'ast syn::ExprRepeat) {
        self.is_constant(&array.len);
        visit::visit_expr_repeat(self, array);
    }

    fn visit_variant(&mut self, variant: &'ast syn::Variant) {
        if let Some((_, number)) = &variant.discriminant {
            self.is_constant(number);
        }
        visit::visit_variant(self, variant);
    }
}
