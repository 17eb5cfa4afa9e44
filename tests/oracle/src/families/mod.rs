//! Test vectors: families of requests, each with its exact truth.
//!
//! A family is a name and a recipe; the recipe draws one request after another, in f32 and in f64, from a generator seeded
//! by kind, family and format. Inputs are built with + - * / and square roots of `f64` and then rounded, so every machine
//! builds the same.

mod any_hit;
mod any_hit_ends;
mod case;
mod draw;
mod light_sample;
mod offset;
mod quantise;
mod ray_plane;
mod ray_plane_edge;
mod ray_sphere;
mod ray_sphere_edge;
mod shade;
mod shade_edge;
mod shade_light;

use crate::case::KINDS;
use crate::format::Format;
use case::{Case, vector};
use draw::Draw;
use serde_json::Value;

/// A name, how many requests it has in each format, and the recipe for them.
struct Family {
    name: &'static str,
    count: usize,
    /// A number the recipe takes: an angle, a distance, a scale.
    parameter: f64,
    recipe: fn(&mut Draw) -> Case,
}

fn family(name: &'static str, count: usize, recipe: fn(&mut Draw) -> Case) -> Family {
    family_of(name, count, 0.0, recipe)
}

fn family_of(
    name: &'static str,
    count: usize,
    parameter: f64,
    recipe: fn(&mut Draw) -> Case,
) -> Family {
    Family {
        name,
        count,
        parameter,
        recipe,
    }
}

fn families(kind: &str) -> Vec<Family> {
    match kind {
        "ray_plane" => [ray_plane::families(), ray_plane_edge::families()]
            .into_iter()
            .flatten()
            .collect(),
        "ray_sphere" => [ray_sphere::families(), ray_sphere_edge::families()]
            .into_iter()
            .flatten()
            .collect(),
        "any_hit" => [any_hit::families(), any_hit_ends::families()]
            .into_iter()
            .flatten()
            .collect(),
        "light_sample" => light_sample::families(),
        "shade" => [
            shade::families(),
            shade_light::families(),
            shade_edge::families(),
        ]
        .into_iter()
        .flatten()
        .collect(),
        "offset" => offset::families(),
        "quantise" => quantise::families(),
        _ => Vec::new(),
    }
}

/// The vectors of one kind, in order of format, family and number; none for an unknown kind.
pub fn cases_of(kind: &str) -> impl Iterator<Item = Value> {
    Format::ALL.into_iter().flat_map(move |format| {
        families(kind)
            .into_iter()
            .flat_map(move |family| vectors(kind, &family, format))
    })
}

fn vectors(kind: &str, family: &Family, format: Format) -> Vec<Value> {
    let mut draw = Draw::new(kind, family.name, format, family.count, family.parameter);
    (0..family.count)
        .map(|index| {
            draw.index = index;
            vector(
                kind,
                family.name,
                format,
                index + 1,
                (family.recipe)(&mut draw),
            )
        })
        .collect()
}

/// All vectors, grouped by kind.
pub fn cases() -> impl Iterator<Item = Value> {
    KINDS.into_iter().flat_map(cases_of)
}

/// The vectors of one kind as JSON Lines.
pub fn write_jsonl(kind: &str) -> String {
    cases_of(kind).map(|case| format!("{case}\n")).collect()
}
