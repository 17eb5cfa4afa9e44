//! Many test vectors, answered and judged.

use super::{Case, Verdict, Wrong};
use crate::conformance::{Allowed, Answer, Kernels, Question, precision, promise};
use crate::float::Float;
use crate::quality::Quality;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt;

/// A case with an answer.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    /// The test vector.
    pub case: &'a Case,
    /// The answer's `out`.
    pub out: Value,
    /// How far that is from the truth.
    pub verdict: Verdict,
    /// Whether that is further than allowed.
    pub fails: bool,
}

/// Answers to test vectors, judged.
#[derive(Clone, Debug, Default)]
pub struct Trial<'a> {
    /// The answers, in the order of the cases.
    pub judged: Vec<Judged<'a>>,
    /// The cases without an answer, which is no fault.
    pub unsupported: Vec<&'a Case>,
}

impl<'a> Judged<'a> {
    /// Judges the `out` of an answer by what is allowed.
    pub fn new(case: &'a Case, out: Value, allowed: Allowed) -> Self {
        let verdict = case.judge(&out);
        Self {
            fails: case.fails(&verdict, allowed),
            case,
            out,
            verdict,
        }
    }
}

impl<'a> Trial<'a> {
    /// Asks kernels of one's own all cases in the format `F`, and holds them to what any good
    /// kernel can keep ([`promise`]). `None` is for what they do not do.
    ///
    /// ```
    /// use glam::Vec3;
    /// use ombrage::conformance::{Answer, Kernel, Question, Surface, Trial, vectors};
    ///
    /// fn intersect(o: Vec3, d: Vec3, q: Vec3, n: Vec3, [near, far]: [f32; 2]) -> Option<f32> {
    ///     let t = (q - o).dot(n) / d.dot(n);
    ///     (t.is_finite() && t >= near && t <= far).then_some(t)
    /// }
    ///
    /// let cases: Vec<_> = vectors(Kernel::RayPlane).unwrap();
    /// let cases: Vec<_> = cases.into_iter().filter(|c| c.family().starts_with("grazing")).collect();
    /// let trial = Trial::of::<f32>(&cases, |question| match *question {
    ///     Question::Hit { ray, ends, surface: Surface::Plane { point, normal } } => {
    ///         Some(Answer::Hit(intersect(ray.origin, ray.direction, point, normal, ends)))
    ///     }
    ///     _ => None,
    /// });
    /// assert_eq!(trial.failed(), 0, "{trial}");
    /// # assert_eq!(trial.judged.len(), 77);
    /// ```
    pub fn of<F: Float>(
        cases: &'a [Case],
        answer: impl FnMut(&Question<F>) -> Option<Answer<F>>,
    ) -> Self {
        Self::allowing::<F>(cases, |case| promise(case.kernel).allowed, answer)
    }

    /// The kit's own kernels, held to what is allowed them in this quality.
    pub fn of_kit(cases: &'a [Case], quality: Quality, float: &str) -> Self {
        match float {
            "f32" => Self::of_kit_in::<f32>(cases, quality),
            _ => Self::of_kit_in::<f64>(cases, quality),
        }
    }

    fn of_kit_in<F: Float>(cases: &'a [Case], quality: Quality) -> Self {
        let kernels = Kernels {
            quality,
            shadow: None,
        };
        let allowed = |case: &Case| precision(case.kernel, quality, F::NAME).allowed;
        Self::allowing::<F>(cases, allowed, |question| kernels.answer(question).ok())
    }

    fn allowing<F: Float>(
        cases: &'a [Case],
        allowed: impl Fn(&Case) -> Allowed,
        mut answer: impl FnMut(&Question<F>) -> Option<Answer<F>>,
    ) -> Self {
        let mut trial = Self::default();
        for case in cases.iter().filter(|case| case.float == F::NAME) {
            match case.question().ok().and_then(|question| answer(&question)) {
                Some(answer) => {
                    let judged = Judged::new(case, answer.out(), allowed(case));
                    trial.judged.push(judged);
                }
                None => trial.unsupported.push(case),
            }
        }
        trial
    }

    /// How many answers are more wrong than allowed.
    pub fn failed(&self) -> usize {
        self.judged.iter().filter(|judged| judged.fails).count()
    }
}

/// One line a failing case.
impl fmt::Display for Trial<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for judged in self.judged.iter().filter(|judged| judged.fails) {
            writeln!(f, "{judged}")?;
        }
        let (judged, unsupported) = (self.judged.len(), self.unsupported.len());
        let failed = self.failed();
        write!(f, "{failed} of {judged} fail, {unsupported} unsupported")
    }
}

impl fmt::Display for Judged<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Verdict {
            wrong,
            ulps,
            bounds,
        } = self.verdict;
        write!(f, "{}: ", self.case.id())?;
        match (wrong, bounds) {
            (Some(wrong), _) => write!(f, "{wrong}")?,
            (None, Some(bounds)) => write!(f, "{ulps:.3} ulp, {bounds:.3} u B")?,
            (None, None) => write!(f, "{ulps:.3} ulp")?,
        }
        write!(f, ", answered {}", self.out)
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Wrong::Decision => "wrong decision",
            Wrong::Root => "the other root",
            Wrong::Byte(off) => return write!(f, "byte off by {off}"),
            Wrong::Side => "origin not on the side the ray came from",
            Wrong::Far => "origin too far away",
            Wrong::Malformed => "no answer of this kind",
        })
    }
}

/// The families of which a case fails.
pub fn failing<'a>(judged: &[Judged<'a>]) -> BTreeSet<&'a str> {
    judged
        .iter()
        .filter(|judged| judged.fails)
        .map(|judged| judged.case.family())
        .collect()
}
