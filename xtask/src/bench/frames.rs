//! The same picture again and again, for a profiler to look at.

use super::lists;
use super::stage::Stage;
use super::way::{Contender, LAB, Way};
use crate::arguments::Format;
use crate::error::Result;
use clap::ValueEnum;
use ombrage::{Level, Picture, Size};
use std::hint::black_box;

/// A chain, as the command line names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Chain {
    /// The baseline.
    LabWay,
    /// The lab's chain as Figure 3(c) has it.
    Lab,
    /// The same with a tree over the spheres.
    Hierarchy,
    /// The kit's default.
    Relative,
    /// The same, every byte proven.
    Proven,
}

impl Chain {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Chain::LabWay => "lab-way",
            Chain::Lab => "lab",
            Chain::Hierarchy => "hierarchy",
            Chain::Relative => "relative",
            Chain::Proven => "proven",
        }
    }

    fn way(self) -> Way {
        match self {
            Chain::LabWay => Way::Baseline,
            Chain::Lab => LAB,
            Chain::Hierarchy => Way::Hierarchy,
            Chain::Relative => Way::Relative,
            Chain::Proven => Way::Proven,
        }
    }
}

/// Figure 3(c), 600 x 400, so many times.
#[derive(Clone, Copy, Debug)]
pub struct Frames {
    /// How it is computed.
    pub chain: Chain,
    /// In which format.
    pub format: Format,
    /// How often.
    pub count: u32,
}

impl Frames {
    /// Draws them, on one thread.
    ///
    /// # Errors
    /// If the processor does not have the level.
    pub fn draw(&self, level: Level) -> Result<()> {
        let case = lists::figure(Size::LAB)?;
        let mut picture = Picture::black(Size::LAB);
        let no_truth = picture.clone();
        let contender = Contender::new(self.chain.way(), level);
        match self.format {
            Format::F32 => {
                let stage = Stage::<f32>::new("3c", &case, &no_truth)?;
                for _ in 0..self.count {
                    stage.draw_over(contender, &mut picture)?;
                    black_box(picture.bytes());
                }
            }
            Format::F64 => {
                let stage = Stage::<f64>::new("3c", &case, &no_truth)?;
                for _ in 0..self.count {
                    stage.draw_over(contender, &mut picture)?;
                    black_box(picture.bytes());
                }
            }
        }
        Ok(())
    }

    /// The arguments with which this program draws them.
    pub fn arguments(&self, level: Level) -> Vec<String> {
        let words = format!(
            "bench --frames {} --chain {} --float {} --level {level}",
            self.count,
            self.chain.name(),
            self.format.name(),
        );
        words.split(' ').map(str::to_owned).collect()
    }
}
