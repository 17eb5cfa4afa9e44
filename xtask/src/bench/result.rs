//! What a bench measures, as data.

use serde::{Deserialize, Serialize};

/// Everything one run measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bench {
    /// On what.
    pub machine: Machine,
    /// Figure 3(c), in every way and at every size.
    pub rows: Vec<Row>,
    /// Figure 3(c) at growing sizes.
    pub growth_with_pixels: Vec<Row>,
    /// A plane under growing numbers of spheres.
    pub growth_with_spheres: Vec<Row>,
    /// From how many spheres a hierarchy pays.
    pub hierarchy: Vec<Hierarchy>,
    /// How fast this machine computes at best.
    pub limits: Vec<Limit>,
    /// How fast it writes pictures at best.
    pub stores: Vec<Store>,
    /// How many operations Figure 3(c) takes.
    pub operations: Vec<Operations>,
    /// Pictures that are not what they must be, one sentence each: none, if all is well.
    pub wrong_pictures: Vec<String>,
}

/// The machine, and the state it is in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name, or its architecture where the system does not tell.
    pub processor: String,
    /// The processor's architecture.
    pub architecture: String,
    /// The operating system.
    pub system: String,
    /// How many threads run at the same time.
    pub cores: usize,
    /// The levels the processor has, by name, each narrower one before the wider.
    pub levels: Vec<String>,
    /// The system's load over the last minute when the run began: others were at work where it is
    /// near `cores`. `None` where the system does not tell.
    pub load: Option<f64>,
    /// Whether the code was built with optimisations; without them no time means anything.
    pub optimised: bool,
}

/// A picture, computed in one way, and its time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// `3c`, or `spheres` for a plane under some.
    pub picture: String,
    /// How many spheres it has.
    pub spheres: usize,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `f32` or `f64`.
    pub float: String,
    /// `lab-way`: the baseline; `lab`: the lab's chain; `relative`: the kit's default; `proven`: the
    /// same, every byte proven; `lab, hierarchy`: the lab's chain with a tree over the spheres.
    pub chain: String,
    /// How shadow rays leave their surface.
    pub shadow: String,
    /// How well the lab's chain computes; `None` for the relative chain, which has one way only.
    pub quality: Option<String>,
    /// What shadow rays ask the scene, `nearest` or `any`; `None` for the relative chain.
    pub query: Option<String>,
    /// The processor level.
    pub level: String,
    /// How many threads.
    pub threads: usize,
    /// The median time, in nanoseconds a pixel.
    pub ns_per_pixel: f64,
    /// How many times as fast as the lab's way: the median of the ratios of neighbouring times.
    pub ratio_to_lab_way: f64,
    /// How many times as long a proof takes as the relative chain at the same level, on as many
    /// threads: the median of the ratios of neighbouring times. `None` for what is no proof.
    pub ratio_to_plain: Option<f64>,
    /// How many bytes differ from the true picture.
    pub wrong_bytes: usize,
    /// The share of the machine's limit that is reached, where the operations were counted.
    pub share_of_limit: Option<f64>,
}

/// From how many spheres a hierarchy pays, in one format, at one level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hierarchy {
    /// `f32` or `f64`.
    pub float: String,
    /// The processor level.
    pub level: String,
    /// The smallest measured number from which on the tree is always faster than the list; `None`:
    /// it never is.
    pub pays_from: Option<usize>,
}

/// The measured throughput of one core, in one format, at one level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// `f32` or `f64`.
    pub float: String,
    /// The processor level.
    pub level: String,
    /// How many numbers a packet holds.
    pub lanes: usize,
    /// Nanoseconds a packet: an addition or a multiplication.
    pub add_mul_ns: f64,
    /// Nanoseconds a packet: a comparison or a selection.
    pub compare_select_ns: f64,
    /// Nanoseconds a packet: a division.
    pub divide_ns: f64,
    /// Nanoseconds a packet: a square root.
    pub sqrt_ns: f64,
}

/// The measured time to fill a new picture with bytes, on one core.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Store {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Nanoseconds a pixel, of three bytes.
    pub ns_per_pixel: f64,
}

/// The operations of Figure 3(c) at the first size, in a chain: counted, per pixel, from radiance to
/// bytes. A packet counts for all its lanes, whether they need the operation or not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Operations {
    /// `f32` or `f64`.
    pub float: String,
    /// `lab` or `relative`.
    pub chain: String,
    /// How many pixels are computed together: 1 for scalars, else two packets.
    pub lanes: usize,
    /// Additions, subtractions and multiplications.
    pub add_mul: f64,
    /// Comparisons and selections.
    pub compare_select: f64,
    /// Divisions.
    pub divide: f64,
    /// Square roots.
    pub sqrt: f64,
}

/// The instructions that Figure 3(c), 600 x 400, takes in a chain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instructions {
    /// `lab` or `relative`.
    pub chain: String,
    /// `f32` or `f64`.
    pub float: String,
    /// The processor level.
    pub level: String,
    /// Instructions a pixel.
    pub per_pixel: f64,
    /// How many it may be at most.
    pub allowed: Option<f64>,
}
