//! One request as a recipe writes it, and the line of JSON it becomes.

use crate::case::truth;
use crate::format::Format;
use serde_json::{Map, Value, json};

/// The inputs of a request, in the order of the protocol, and what else is noted beside them.
pub struct Case {
    inputs: Vec<(&'static str, Input)>,
    notes: Vec<(&'static str, Value)>,
}

enum Input {
    Number(f64),
    Vector([f64; 3]),
    Shape(Shape),
    Shapes(Vec<Shape>),
}

/// An object of a request.
#[derive(Clone)]
pub struct Shape {
    surface: Surface,
    color: Option<[f64; 3]>,
}

#[derive(Clone, Copy)]
enum Surface {
    Plane { q: [f64; 3], n: [f64; 3] },
    Sphere { c: [f64; 3], r: f64 },
}

pub fn plane(q: [f64; 3], n: [f64; 3]) -> Shape {
    Shape {
        surface: Surface::Plane { q, n },
        color: None,
    }
}

pub fn sphere(c: [f64; 3], r: f64) -> Shape {
    Shape {
        surface: Surface::Sphere { c, r },
        color: None,
    }
}

impl Shape {
    pub fn colored(self, color: [f64; 3]) -> Shape {
        Shape {
            color: Some(color),
            ..self
        }
    }
}

/// An origin and a direction.
#[derive(Clone, Copy)]
pub struct Line {
    pub o: [f64; 3],
    pub d: [f64; 3],
}

impl Line {
    pub const fn new(o: [f64; 3], d: [f64; 3]) -> Line {
        Line { o, d }
    }
}

/// The lower and the upper end of an interval.
pub type Ends = [f64; 2];

/// Everything in front of the origin.
pub const AHEAD: Ends = [0.0, f64::INFINITY];

/// The light and the background of a shading request.
#[derive(Clone, Copy)]
pub struct Lamp {
    pub light: [f64; 3],
    pub power: f64,
    pub color: [f64; 3],
    pub background: f64,
}

use Input::{Number, Vector};

impl Case {
    fn of(inputs: Vec<(&'static str, Input)>) -> Case {
        Case {
            inputs,
            notes: Vec::new(),
        }
    }

    pub fn ray_plane(line: Line, q: [f64; 3], n: [f64; 3], [tmin, tmax]: Ends) -> Case {
        let Line { o, d } = line;
        Case::of(vec![
            ("o", Vector(o)),
            ("d", Vector(d)),
            ("q", Vector(q)),
            ("n", Vector(n)),
            ("tmin", Number(tmin)),
            ("tmax", Number(tmax)),
        ])
    }

    pub fn ray_sphere(line: Line, c: [f64; 3], r: f64, [tmin, tmax]: Ends) -> Case {
        let Line { o, d } = line;
        Case::of(vec![
            ("o", Vector(o)),
            ("d", Vector(d)),
            ("c", Vector(c)),
            ("r", Number(r)),
            ("tmin", Number(tmin)),
            ("tmax", Number(tmax)),
        ])
    }

    pub fn any_hit(line: Line, [tmin, tmax]: Ends, objs: Vec<Shape>) -> Case {
        Case::of(vec![
            ("o", Vector(line.o)),
            ("d", Vector(line.d)),
            ("tmin", Number(tmin)),
            ("tmax", Number(tmax)),
            ("objs", Input::Shapes(objs)),
        ])
    }

    pub fn light_sample(p: [f64; 3], light: [f64; 3], power: f64, color: [f64; 3]) -> Case {
        Case::of(vec![
            ("p", Vector(p)),
            ("light", Vector(light)),
            ("power", Number(power)),
            ("color", Vector(color)),
        ])
    }

    pub fn shade(line: Line, objs: Vec<Shape>, lamp: Lamp, [tmin, tmax]: Ends) -> Case {
        Case::of(vec![
            ("o", Vector(line.o)),
            ("d", Vector(line.d)),
            ("objs", Input::Shapes(objs)),
            ("light", Vector(lamp.light)),
            ("power", Number(lamp.power)),
            ("light_color", Vector(lamp.color)),
            ("background", Number(lamp.background)),
            ("tmin", Number(tmin)),
            ("tmax", Number(tmax)),
        ])
    }

    pub fn offset(line: Line, obj: Shape, p: [f64; 3], n: [f64; 3]) -> Case {
        Case::of(vec![
            ("o", Vector(line.o)),
            ("d", Vector(line.d)),
            ("obj", Input::Shape(obj)),
            ("p", Vector(p)),
            ("n", Vector(n)),
        ])
    }

    pub fn quantise(x: f64) -> Case {
        Case::of(vec![("x", Number(x))])
    }

    /// A key beside the inputs, which a program under test ignores.
    pub fn note(mut self, key: &'static str, value: impl Into<Value>) -> Case {
        self.notes.push((key, value.into()));
        self
    }
}

/// The line of the file: the request, its inputs in decimal, its truth, its notes.
pub fn vector(kind: &str, family: &str, format: Format, number: usize, case: Case) -> Value {
    let render = |text: &dyn Fn(f64) -> String| -> Value {
        let members = case
            .inputs
            .iter()
            .map(|(key, input)| ((*key).to_owned(), input.render(text)));
        Value::Object(members.collect::<Map<_, _>>())
    };
    let mut line = json!({
        "id": format!("{kind}.{family}.{}.{number:04}", format.name()),
        "kind": kind,
        "family": family,
        "prec": format.name(),
        "in": render(&|x| format.hex(format.narrow(x))),
        "dec": render(&|x| format!("{:?}", format.narrow(x)).to_lowercase()),
    });
    line["exp"] = truth(&line).expect("a recipe writes well-formed requests");
    for (key, value) in case.notes {
        line[key] = value;
    }
    line
}

impl Input {
    fn render(&self, text: &dyn Fn(f64) -> String) -> Value {
        match self {
            Number(x) => text(*x).into(),
            Vector(v) => render_vector(*v, text),
            Input::Shape(shape) => shape.render(text),
            Input::Shapes(shapes) => shapes.iter().map(|shape| shape.render(text)).collect(),
        }
    }
}

impl Shape {
    fn render(&self, text: &dyn Fn(f64) -> String) -> Value {
        let mut shape = match self.surface {
            Surface::Plane { q, n } => {
                json!({ "type": "plane", "q": render_vector(q, text), "n": render_vector(n, text) })
            }
            Surface::Sphere { c, r } => {
                json!({ "type": "sphere", "c": render_vector(c, text), "r": text(r) })
            }
        };
        if let Some(color) = self.color {
            shape["color"] = render_vector(color, text);
        }
        shape
    }
}

fn render_vector(v: [f64; 3], text: &dyn Fn(f64) -> String) -> Value {
    v.iter().map(|&x| Value::from(text(x))).collect()
}
