//! A source file with a switch in front of each of its mutants.
//!
//! No line is added or moved, so that panics and snapshots name the lines that they name without
//! switches. In the copy of an operand that belongs to a mutant there is no switch of another one: only
//! one is ever on.

use crate::lines::{Lines, Range, in_one_line};
use crate::mutant::Mutant;
use crate::sites::{Shape, Sites};
use std::cmp::Reverse;

/// How a crate asks a switch.
const IS_ON: &str = "crate::mutant_switch::is_on";

/// Functions with switches are compiled once, not once a caller, which would be too much. Both are of one
/// length, since places are counted in bytes.
const INLINED: [&str; 2] = ["#[inline(always)]", "#[inline( never)]"];

/// A file with switches, and where they are in it.
#[derive(Debug)]
pub struct Switched {
    /// The text.
    pub text: String,
    /// The code that runs where a mutant is on.
    pub branches: Vec<(Range, usize)>,
    /// The code around all branches of a place, with their mutants.
    pub places: Vec<(Range, Vec<usize>)>,
    /// Mutants that can have no switch.
    pub without: Vec<usize>,
}

/// A place and its mutants, each with what it puts there.
struct Site {
    range: Range,
    shape: Shape,
    mutants: Vec<(usize, String)>,
}

/// Puts switches into a text, for these of `mutants`.
///
/// # Errors
/// If the text is no Rust.
pub fn rewrite(text: &str, mutants: &[Mutant], numbers: &[usize]) -> syn::Result<Switched> {
    let text = &text.replace(INLINED[0], INLINED[1]);
    let lines = Lines::new(text);
    let found = Sites::of(&syn::parse_file(text)?, &lines);
    let mut sites: Vec<Site> = vec![];
    let mut without = vec![];
    for &number in numbers {
        let mutant = &mutants[number];
        let place = found.at(mutant);
        let Some((range, shape)) = place.filter(|(_, shape)| can_be_copied(text, shape)) else {
            without.push(number);
            continue;
        };
        let change = (number, mutant.replacement.clone());
        let same = |site: &&mut Site| site.range == range && site.shape == shape;
        match sites.iter_mut().find(same) {
            Some(site) => site.mutants.push(change),
            None => sites.push(Site {
                range,
                shape,
                mutants: vec![change],
            }),
        }
    }
    sites.sort_by_key(|site| (site.range.0, Reverse(site.range.1), site.shape.rank()));
    let mut writer = Writer {
        source: text,
        sites: &sites,
        text: String::new(),
        branches: vec![],
        places: vec![],
    };
    writer.copy((0, text.len()), 0);
    Ok(Switched {
        text: writer.text,
        branches: writer.branches,
        places: writer.places,
        without,
    })
}

/// Whether the parts that a mutant needs a second time fit into one line.
fn can_be_copied(text: &str, shape: &Shape) -> bool {
    let fits = |part: &Range| in_one_line(&text[part.0..part.1]).is_some();
    match shape {
        Shape::Body | Shape::Arm { .. } | Shape::Guard => true,
        Shape::Field { base, .. } => fits(base),
        Shape::Binary { left, right, .. } => fits(left) && fits(right),
        Shape::Unary { operand } => fits(operand),
    }
}

struct Writer<'a> {
    source: &'a str,
    /// Sorted by start; a place comes before those in it.
    sites: &'a [Site],
    text: String,
    branches: Vec<(Range, usize)>,
    places: Vec<(Range, Vec<usize>)>,
}

impl Writer<'_> {
    /// Writes a part of the source, with switches at the sites from the `first` on that are in it.
    fn copy(&mut self, part: Range, first: usize) {
        let mut done = part.0;
        for (place, site) in self.sites.iter().enumerate().skip(first) {
            let (start, end) = site.range;
            if start >= done && end <= part.1 && start < part.1 {
                self.text += &self.source[done..start];
                self.place(place);
                done = end;
            }
        }
        self.text += &self.source[done..part.1];
    }

    /// Writes a place with its switches.
    fn place(&mut self, place: usize) {
        let start = self.text.len();
        let site = &self.sites[place];
        let inside = place + 1;
        match &site.shape {
            Shape::Body => {
                self.branches_of(site, |value| format!("return {value};"), "");
                self.copy(site.range, inside);
            }
            Shape::Arm { guard } => {
                let number = site.mutants[0].0;
                let code = format!("!{IS_ON}({number})");
                match guard {
                    None => self.branch(number, &format!(" if {code}")),
                    Some(guard) => {
                        self.text += &self.source[site.range.0..guard.0];
                        self.branch(number, &format!("{code} && ("));
                        self.copy(*guard, inside);
                        self.text += ")";
                    }
                }
            }
            Shape::Guard => {
                self.text += "(";
                self.branches_of(site, str::to_owned, "else ");
                self.braced(site.range, inside);
                self.text += ")";
            }
            Shape::Field { name, base, value } => {
                let base = self.second(*base);
                match value {
                    Some(value) => self.text += &self.source[site.range.0..value.0],
                    None => self.text += &format!("{name}: "),
                }
                self.branches_of(site, |_| format!("({base}).{name}"), "else ");
                match value {
                    Some(value) => self.braced(*value, inside),
                    None => self.text += &format!("{{ {name} }}"),
                }
            }
            Shape::Binary {
                left,
                operator,
                right,
            } => {
                let [open, close] = match assigns(&self.source[operator.0..operator.1]) {
                    true => ["{ ", " }"],
                    false => ["(", ")"],
                };
                let (a, b) = (self.second(*left), self.second(*right));
                self.text += open;
                self.branches_of(site, |operator| format!("{a} {operator} {b}"), "else ");
                self.text += "{ ";
                self.copy(*left, inside);
                self.text += &self.source[left.1..right.0];
                self.copy(*right, inside);
                self.text += &format!(" }}{close}");
            }
            Shape::Unary { operand } => {
                let other = self.second(*operand);
                self.text += "(";
                self.branches_of(site, |_| other.clone(), "else ");
                self.text += "{ ";
                self.text += &self.source[site.range.0..operand.0];
                self.copy(*operand, inside);
                self.text += " })";
            }
        }
        let numbers = site.mutants.iter().map(|(number, _)| *number).collect();
        self.places.push(((start, self.text.len()), numbers));
    }

    /// A second copy of a part, in one line; all parts of sites can have one.
    fn second(&self, part: Range) -> String {
        in_one_line(&self.source[part.0..part.1]).unwrap_or_default()
    }

    fn braced(&mut self, part: Range, inside: usize) {
        self.text += "{ ";
        self.copy(part, inside);
        self.text += " }";
    }

    fn branches_of(&mut self, site: &Site, code: impl Fn(&str) -> String, end: &str) {
        for (number, replacement) in &site.mutants {
            let code = code(replacement);
            self.branch(*number, &format!("if {IS_ON}({number}) {{ {code} }} {end}"));
        }
    }

    fn branch(&mut self, number: usize, code: &str) {
        let start = self.text.len();
        self.text += code;
        self.branches.push(((start, self.text.len()), number));
    }
}

/// Whether an operator changes its left operand, so that it is a statement, and has no value.
fn assigns(operator: &str) -> bool {
    operator.ends_with('=') && !["==", "<=", ">=", "!="].contains(&operator)
}

#[cfg(test)]
#[path = "rewrite_tests.rs"]
mod tests;
