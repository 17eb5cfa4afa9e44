//! Tables of a scene file: their keys, and values of the right type.

use super::source::Source;
use crate::error::{Error, Result};
use glam::DVec3;
use ombrage::Invalid;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A key that a table must have.
#[derive(Debug)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// A value to copy.
    pub example: &'static str,
}

/// What a table may contain: all of its keys, and no others.
#[derive(Debug)]
pub struct Kind {
    /// How the table begins.
    pub header: &'static str,
    /// What it describes; empty for the file itself.
    pub word: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
    /// The names of tables in it.
    pub sections: &'static [&'static str],
}

/// A table of the file.
pub struct Section<'a> {
    source: &'a Source,
    kind: &'static Kind,
    table: &'a DeTable<'a>,
    /// The byte where the table begins.
    start: usize,
}

impl<'a> Section<'a> {
    /// The whole file.
    ///
    /// # Errors
    /// If it has an unknown key.
    pub fn whole(
        source: &'a Source,
        document: &'a Spanned<DeTable<'a>>,
        kind: &'static Kind,
    ) -> Result<Self> {
        Self::new(source, document.get_ref(), 0, kind)
    }

    fn new(
        source: &'a Source,
        table: &'a DeTable<'a>,
        start: usize,
        kind: &'static Kind,
    ) -> Result<Self> {
        let keys = kind.keys.iter().map(|key| key.name);
        let known = || keys.clone().chain(kind.sections.iter().copied());
        for key in table.keys() {
            if !known().any(|known| known == key.get_ref()) {
                let names: Vec<&str> = known().collect();
                let (header, unknown, names) = (kind.header, key.get_ref(), names.join(", "));
                let what = format!("{unknown:?} is no key of {header}: use {names}");
                return Err(source.error(key.span().start, &what));
            }
        }
        Ok(Self {
            source,
            kind,
            table,
            start,
        })
    }

    /// The one table of this name.
    ///
    /// # Errors
    /// If it is missing, no table, or has an unknown key.
    pub fn section(&self, name: &str, kind: &'static Kind) -> Result<Section<'a>> {
        let value = self.table.get(name).ok_or_else(|| {
            let what = format!("{0} is missing: write {0} and its keys", kind.header);
            self.source.error(self.start, &what)
        })?;
        self.open(value, kind)
    }

    /// The tables of this name, in their order; none if there is no such name.
    ///
    /// # Errors
    /// If the name has another value than a list. What is wrong with a table is said in its place.
    pub fn sections(
        &self,
        name: &str,
        kind: &'static Kind,
    ) -> Result<impl Iterator<Item = Result<Section<'a>>>> {
        let list = match self.table.get(name) {
            None => &[],
            Some(value) => match value.get_ref() {
                DeValue::Array(list) => &list[..],
                _ => return Err(self.not_a(value, "a list of tables", kind)),
            },
        };
        Ok(list.iter().map(move |value| self.open(value, kind)))
    }

    fn open(&self, value: &'a Spanned<DeValue<'a>>, kind: &'static Kind) -> Result<Section<'a>> {
        match value.get_ref() {
            DeValue::Table(table) => Section::new(self.source, table, value.span().start, kind),
            _ => Err(self.not_a(value, "a table", kind)),
        }
    }

    fn not_a(&self, value: &Spanned<DeValue>, needed: &str, kind: &Kind) -> Error {
        let (word, found, header) = (kind.word, type_of(value), kind.header);
        let what = format!("{word} is {found}, but must be {needed}: begin it with {header}");
        self.source.error(value.span().start, &what)
    }

    /// Text of at least one character, none of them a control character.
    ///
    /// # Errors
    /// If it is missing or anything else.
    pub fn text(&self, name: &str) -> Result<String> {
        let value = self.value(name)?;
        match value.get_ref() {
            DeValue::String(text) if text.is_empty() || text.contains(char::is_control) => {
                Err(self.wrong(name, &format!("{text:?}"), "one line of text"))
            }
            DeValue::String(text) => Ok(text.to_string()),
            _ => Err(self.wrong(name, type_of(value), "text")),
        }
    }

    /// A number, whole or not, finite or not.
    ///
    /// # Errors
    /// If it is missing or anything else, or beyond the range of `f64`.
    pub fn number(&self, name: &str) -> Result<f64> {
        let value = self.value(name)?;
        float(value.get_ref()).map_err(|found| self.wrong(name, &found, "a number"))
    }

    /// Three numbers.
    ///
    /// # Errors
    /// If it is missing or anything else.
    pub fn vector(&self, name: &str) -> Result<DVec3> {
        let value = self.value(name)?;
        let needed = "three numbers";
        let DeValue::Array(list) = value.get_ref() else {
            return Err(self.wrong(name, type_of(value), needed));
        };
        let [x, y, z] = &list[..] else {
            let found = format!("a list of {}", list.len());
            return Err(self.wrong(name, &found, needed));
        };
        let number = |value: &Spanned<DeValue>| {
            let wrong = |found| self.wrong(name, &format!("a list with {found} in it"), needed);
            float(value.get_ref()).map_err(wrong)
        };
        Ok(DVec3::new(number(x)?, number(y)?, number(z)?))
    }

    /// A whole number from 0 to 2^32 - 1.
    ///
    /// # Errors
    /// If it is missing or anything else.
    pub fn count(&self, name: &str) -> Result<u32> {
        let value = self.value(name)?;
        let needed = "a whole number from 1 on";
        match value.get_ref() {
            DeValue::Integer(number) => u32::from_str_radix(number.as_str(), number.radix())
                .map_err(|_| self.wrong(name, &number.to_string(), needed)),
            DeValue::Float(number) => Err(self.wrong(name, number.as_str(), needed)),
            _ => Err(self.wrong(name, type_of(value), needed)),
        }
    }

    /// A value of this table that no scene can have.
    pub fn invalid(&self, invalid: &Invalid) -> Error {
        let name = invalid.field.rsplit(' ').next().unwrap_or_default();
        self.source.error(self.place(name), &invalid.to_string())
    }

    fn value(&self, name: &str) -> Result<&'a Spanned<DeValue<'a>>> {
        self.table.get(name).ok_or_else(|| {
            let (header, example) = (self.kind.header, self.example(name));
            let what = format!("{header} has no {name}: write {name} = {example}");
            self.source.error(self.start, &what)
        })
    }

    fn wrong(&self, name: &str, found: &str, needed: &str) -> Error {
        let (word, example) = (self.kind.word, self.example(name));
        let what =
            format!("{word} {name} is {found}, but must be {needed}: write {name} = {example}");
        self.source.error(self.place(name), what.trim_start())
    }

    fn example(&self, name: &str) -> &'static str {
        let key = self.kind.keys.iter().find(|key| key.name == name);
        key.map_or("", |key| key.example)
    }

    /// The byte where the value of a key begins; where there is none, where the table does.
    fn place(&self, name: &str) -> usize {
        self.table
            .get(name)
            .map_or(self.start, |value| value.span().start)
    }
}

/// The number in a value; else what there is instead.
fn float(value: &DeValue) -> std::result::Result<f64, String> {
    let text = match value {
        DeValue::Float(number) => number.as_str(),
        DeValue::Integer(number) if number.radix() == 10 => number.as_str(),
        DeValue::Integer(number) => {
            let whole = u32::from_str_radix(number.as_str(), number.radix());
            return whole.map(f64::from).map_err(|_| number.to_string());
        }
        other => return Err(name_of(other).to_owned()),
    };
    match text.parse::<f64>() {
        Ok(number) if number.is_infinite() && !text.contains("inf") => {
            Err(format!("{text}, too large for f64"))
        }
        Ok(number) => Ok(number),
        Err(_) => Err(text.to_owned()),
    }
}

fn type_of(value: &Spanned<DeValue>) -> &'static str {
    name_of(value.get_ref())
}

/// What kind of value it is, with its article.
fn name_of(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
