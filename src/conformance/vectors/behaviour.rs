//! Known ways to be wrong, recognised by their answers.
//!
//! A behaviour is recognised by the cases that tell it from the truth: those where it would give
//! another answer than the right one. It is named where the kernels answer most of these as the
//! behaviour would, and most of all others right; never where the truth explains the same answers.

mod failures;
mod interval;
mod offset;
mod predict;

use super::{Judged, Wrong};
use crate::conformance::Kernel;
use crate::float::Float;
use std::collections::BTreeSet;
use std::fmt;

/// A known way to be wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Behaviour {
    /// The sphere's discriminant is b² - 4ac.
    TextbookSphere,
    /// Directions are taken for unit vectors.
    UnitDirectionAssumed,
    /// Hits beyond `tmax` count.
    TMaxIgnored,
    /// Hits before `tmin` count, or a lower end of one's own is used.
    TMinIgnored,
    /// An end of the interval does not belong to it.
    OpenInterval,
    /// A plane is seen from one side only.
    PlaneCulled,
    /// A sphere is not seen from inside.
    InsideMissed,
    /// Products overflow or underflow where the answer does not.
    Overflow,
    /// Origins move by the same length everywhere.
    OffsetConstant,
    /// The program ended before it had answered.
    Crashed,
    /// The program did not answer in time.
    Hung,
    /// The program printed what is no answer.
    Garbled,
}

impl Behaviour {
    /// All behaviours, in the order of reports.
    pub const ALL: [Behaviour; 12] = [
        Behaviour::TextbookSphere,
        Behaviour::UnitDirectionAssumed,
        Behaviour::TMaxIgnored,
        Behaviour::TMinIgnored,
        Behaviour::OpenInterval,
        Behaviour::PlaneCulled,
        Behaviour::InsideMissed,
        Behaviour::Overflow,
        Behaviour::OffsetConstant,
        Behaviour::Crashed,
        Behaviour::Hung,
        Behaviour::Garbled,
    ];

    /// The code, which never changes.
    pub fn code(self) -> &'static str {
        match self {
            Behaviour::TextbookSphere => "TEXTBOOK_SPHERE",
            Behaviour::UnitDirectionAssumed => "UNIT_DIRECTION_ASSUMED",
            Behaviour::TMaxIgnored => "T_MAX_IGNORED",
            Behaviour::TMinIgnored => "T_MIN_IGNORED",
            Behaviour::OpenInterval => "OPEN_INTERVAL",
            Behaviour::PlaneCulled => "PLANE_CULLED",
            Behaviour::InsideMissed => "INSIDE_MISSED",
            Behaviour::Overflow => "OVERFLOW",
            Behaviour::OffsetConstant => "OFFSET_CONSTANT",
            Behaviour::Crashed => "CRASHED",
            Behaviour::Hung => "HUNG",
            Behaviour::Garbled => "GARBLED",
        }
    }

    /// What to look for in one's code.
    pub fn advice(self) -> &'static str {
        match self {
            Behaviour::TextbookSphere => {
                "b² - 4ac cancels near tangents and far from the sphere: take the discriminant from \
                 the distance of the line to the center (Ray Tracing Gems, chapter 7)"
            }
            Behaviour::UnitDirectionAssumed => {
                "directions have any length and t counts in lengths of d: divide by dot(d, d)"
            }
            Behaviour::TMaxIgnored => "a hit beyond tmax is none: compare t with tmax",
            Behaviour::TMinIgnored => {
                "a hit before tmin is none, and tmin may have any sign: compare t with tmin, not \
                 with 0 or a constant"
            }
            Behaviour::OpenInterval => {
                "both ends belong to [tmin, tmax]: reject t < tmin and t > tmax, not t <= tmin or \
                 t >= tmax"
            }
            Behaviour::PlaneCulled => {
                "a plane is hit from both sides: divide by dot(d, n) whatever its sign"
            }
            Behaviour::InsideMissed => {
                "from inside a sphere the near root is before tmin: try the far one"
            }
            Behaviour::Overflow => {
                "squares and products leave the range where t does not: scale by a power of two, or \
                 compute one precision up"
            }
            Behaviour::OffsetConstant => {
                "one length is too much near the origin and lost far from it: move in units in the \
                 last place of the coordinates (Ray Tracing Gems, chapter 6)"
            }
            Behaviour::Crashed => "the program ended before it had answered",
            Behaviour::Hung => "the program did not answer in time",
            Behaviour::Garbled => {
                "standard output is for answers alone: one line of JSON each, in the order of the \
                 requests"
            }
        }
    }
}

impl fmt::Display for Behaviour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

/// Why a behaviour is named.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// The behaviour.
    pub behaviour: Behaviour,
    /// The kernel that shows it.
    pub kernel: Kernel,
    /// In which format: `f32` or `f64`.
    pub float: &'static str,
    /// How many cases are answered as the behaviour would.
    pub matched: usize,
    /// Of how many that tell it from the truth.
    pub telling: usize,
    /// The id of the first that matches.
    pub first: &'a str,
}

/// The behaviours that answers show, by kernel and format. Answers that could not be read count as
/// wrong and no more.
pub fn recognise<'a>(judged: &[Judged<'a>]) -> Vec<Evidence<'a>> {
    let mut evidence = vec![];
    for kernel in Kernel::ALL {
        for float in ["f32", "f64"] {
            let is_of = |judged: &&Judged| {
                let case = judged.case;
                case.kernel() == kernel && case.float() == float
            };
            let group: Vec<&Judged> = judged.iter().filter(is_of).collect();
            evidence.extend(match float {
                "f32" => recognise_in::<f32>(kernel, &group),
                _ => recognise_in::<f64>(kernel, &group),
            });
        }
    }
    evidence
}

fn recognise_in<'a, F: Float>(kernel: Kernel, group: &[&Judged<'a>]) -> Vec<Evidence<'a>> {
    match kernel {
        Kernel::RayPlane | Kernel::RaySphere | Kernel::AnyHit => {
            let (mut evidence, explained) = interval::recognise::<F>(group);
            evidence.extend(failures::recognise::<F>(kernel, group, &explained));
            evidence
        }
        Kernel::LightSample => failures::recognise::<F>(kernel, group, &BTreeSet::new()),
        Kernel::Offset => offset::recognise::<F>(group).into_iter().collect(),
        Kernel::Shade | Kernel::Quantise => vec![],
    }
}

/// How many cases must match, and which part of those that tell.
#[derive(Clone, Copy)]
struct Threshold {
    matched: usize,
    part: f64,
}

/// What speaks for and against a behaviour.
#[derive(Default)]
struct Tally<'a> {
    telling: Vec<&'a str>,
    matching: Vec<&'a str>,
    /// Of the cases where the behaviour is right: for misses and for hits, how many there are and
    /// how many are answered right.
    others: [(usize, usize); 2],
}

impl<'a> Tally<'a> {
    fn tell(&mut self, judged: &Judged<'a>, matches: bool) {
        self.telling.push(judged.case.id());
        if matches {
            self.matching.push(judged.case.id());
        }
    }

    fn other(&mut self, class: bool, right: bool) {
        let (cases, rights) = &mut self.others[usize::from(class)];
        *cases += 1;
        *rights += usize::from(right);
    }

    /// The evidence, if it is enough: also most of the other cases of either class are right, so
    /// that a program that never hits is not taken for one that misses in a certain way.
    fn evidence(
        &self,
        behaviour: Behaviour,
        of: &[&Judged<'a>],
        threshold: Threshold,
    ) -> Option<Evidence<'a>> {
        let matched = self.matching.len();
        let enough = matched as f64 >= threshold.part * self.telling.len() as f64;
        let sound = self.others.iter().all(|(cases, right)| 2 * right >= *cases);
        let case = of.first()?.case;
        (matched >= threshold.matched && enough && sound).then(|| Evidence {
            behaviour,
            kernel: case.kernel(),
            float: case.float(),
            matched,
            telling: self.telling.len(),
            first: self.matching[0],
        })
    }
}

/// Whether an answer is right, give or take one in a hundred.
fn is_about_right<F: Float>(judged: &Judged) -> bool {
    judged.verdict.wrong.is_none() && judged.verdict.ulps * F::EPSILON < 0.01
}
