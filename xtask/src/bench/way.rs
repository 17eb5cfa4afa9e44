//! The ways to compute a picture that run against each other.

use ombrage::{Float, Level, Quality, Scalar, Shadow, ShadowQuery};
use std::num::NonZero;

/// How a picture is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// The baseline, [`lab_way`](super::lab_way).
    Baseline,
    /// The lab's chain.
    Lab(Shadow, Quality, ShadowQuery),
    /// The lab's chain with a tree over the spheres, [`hierarchy`](super::hierarchy).
    Hierarchy,
    /// The kit's default.
    Relative,
    /// The same, every byte proven.
    Proven,
}

/// The lab's chain as Figure 3(c) has it.
pub const LAB: Way = Way::Lab(Shadow::UlpOffset, Quality::Textbook, ShadowQuery::Any);

impl Way {
    /// The name of its chain, as tables give it.
    pub fn chain(self) -> &'static str {
        match self {
            Way::Baseline => "lab-way",
            Way::Lab(..) => "lab",
            Way::Hierarchy => "lab, hierarchy",
            Way::Relative => "relative",
            Way::Proven => "proven",
        }
    }

    /// How its shadow rays leave their surface.
    pub fn shadow(self) -> String {
        match self {
            Way::Baseline | Way::Hierarchy => Shadow::UlpOffset.name(),
            Way::Lab(shadow, ..) => shadow.name(),
            Way::Relative | Way::Proven => "sidedness".into(),
        }
    }

    /// How well it computes, where there is a choice.
    pub fn quality(self) -> Option<Quality> {
        match self {
            Way::Baseline | Way::Hierarchy => Some(Quality::Textbook),
            Way::Lab(_, quality, _) => Some(quality),
            Way::Relative | Way::Proven => None,
        }
    }

    /// What its shadow rays ask, where there is a choice.
    pub fn query(self) -> Option<&'static str> {
        match self {
            Way::Baseline | Way::Lab(_, _, ShadowQuery::Nearest) => Some("nearest"),
            Way::Lab(_, _, ShadowQuery::Any) | Way::Hierarchy => Some("any"),
            Way::Relative | Way::Proven => None,
        }
    }

    /// The way whose scalar path must have the same bytes; for the baseline nearly the same.
    pub fn reference(self) -> Way {
        match self {
            Way::Baseline | Way::Hierarchy => LAB,
            Way::Lab(shadow, quality, _) => Way::Lab(shadow, quality, ShadowQuery::Any),
            Way::Relative | Way::Proven => self,
        }
    }

    /// Whether it runs in a format: a proof takes all formats it needs, and is counted as `f32`.
    pub fn runs_in<F: Float>(self) -> bool {
        self != Way::Proven || F::NAME == f32::NAME
    }

    /// Whether it knows packets.
    fn has_packets(self) -> bool {
        !matches!(self, Way::Baseline | Way::Lab(_, Quality::Wide, _))
    }
}

/// A way to compute a picture, and what with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contender {
    /// How it is computed.
    pub way: Way,
    /// At which processor level.
    pub level: Level,
    /// On how many threads.
    pub threads: NonZero<usize>,
}

impl Contender {
    /// A way at a level, on one thread; one pixel at a time where the way knows no packets.
    pub fn new(way: Way, level: Level) -> Self {
        Self {
            way,
            level: if way.has_packets() {
                level
            } else {
                Level::Scalar
            },
            threads: NonZero::<usize>::MIN,
        }
    }

    /// The same on two threads.
    pub fn on_two_threads(self) -> Self {
        let threads = self.threads.saturating_add(1);
        Self { threads, ..self }
    }
}
