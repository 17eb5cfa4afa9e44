//! The three figures that say most, for the top of the page and for the README.

use super::chart::speed;
use super::data::Data;
use crate::shadows::{Strategy, totals};
use crate::table::grouped;
use ombrage::Shadow;

/// A figure and the sentence that goes on from it.
pub struct Headline {
    /// The figure, short enough to stand large.
    pub figure: String,
    /// What it counts; code stands between backquotes.
    pub sentence: String,
}

/// The three.
pub fn all(data: &Data) -> Vec<Headline> {
    let headlines = [Some(wrong_shadows(data)), speed(data), Some(far_away(data))];
    headlines.into_iter().flatten().collect()
}

/// Wrong shadows of the default, and of the lab's cure.
fn wrong_shadows(data: &Data) -> Headline {
    let totals = totals(&data.shadows);
    let of = |strategy: &str| {
        let found = totals
            .iter()
            .find(|total| total.strategy == strategy && total.float == "f32");
        found.map_or((0, 0), |total| (total.wrong.shadows(), total.wrong.rays))
    };
    let (own, rays) = of(&Strategy::Sidedness.name());
    let (lab, _) = of(&Shadow::UlpOffset.name());
    Headline {
        figure: grouped(own as u64),
        sentence: format!(
            "wrong shadows in {} shadow rays over {} scenes, in `f32`; the lab's own cure, `Ray::offset`, \
             gets {} wrong.",
            grouped(rays as u64),
            scenes(data),
            grouped(lab as u64)
        ),
    }
}

/// How many scenes there are.
pub fn scenes(data: &Data) -> usize {
    let mut names: Vec<&str> = data.shadows.iter().map(|row| row.scene.as_str()).collect();
    names.dedup();
    names.sort_unstable();
    names.dedup();
    names.len()
}

/// The best time, and what it is measured against.
fn speed(data: &Data) -> Option<Headline> {
    let (best, baseline) = (speed::best(data, "f32")?, speed::lab_way(data, "f32")?);
    Some(Headline {
        figure: format!("{:.1} ns", best.ns_per_pixel),
        sentence: format!(
            "a pixel with shadows, in `f32` on one thread: {:.0} times as fast as a program built as the \
             lab says, which takes {:.1} ns.",
            best.ratio_to_lab_way, baseline.ns_per_pixel
        ),
    })
}

/// Wrong bytes far from the origin.
fn far_away(data: &Data) -> Headline {
    let farthest = data.moved.last();
    let (lab, own) = farthest.map_or((0, 0), |row| (row.f32.lab, row.f32.relative));
    let distance = farthest.map_or(0.0, |row| row.moved_by);
    Headline {
        figure: format!("{} bytes", grouped(own as u64)),
        sentence: format!(
            "of 720,000 are wrong in `f32` when the scene is moved {} units from the origin; computed \
             the lab's way, {} are.",
            grouped(distance as u64),
            grouped(lab as u64)
        ),
    }
}
