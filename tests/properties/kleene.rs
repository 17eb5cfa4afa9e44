//! Answers that may be left open.

use ombrage::{Bounded, Kleene, Mask, Real};

pub fn choices_are_those_of_three_valued_logic() {
    let open = Kleene {
        certain: false,
        possible: true,
    };
    let of = |truth: bool| Kleene {
        certain: truth,
        possible: truth,
    };
    let answers = [of(false), of(true), open];
    // What an answer may turn out to be.
    let worlds = |answer: Kleene<bool>| {
        [false, true].into_iter().filter(move |&world| {
            if world {
                answer.possible
            } else {
                !answer.certain
            }
        })
    };
    let join = |truths: &mut dyn Iterator<Item = bool>| {
        let truths: Vec<bool> = truths.collect();
        (truths.iter().all(|&t| t), truths.iter().any(|&t| t))
    };
    let parts = |answer: Kleene<bool>| (answer.certain, answer.possible);
    for a in answers {
        assert_eq!(parts(!a), join(&mut worlds(a).map(|a| !a)), "not {a:?}");
        assert_eq!(a.any(), worlds(a).any(|a| a));
        assert_eq!(a.decided(), worlds(a).count() == 1);
        for b in answers {
            let both = || worlds(a).flat_map(move |a| worlds(b).map(move |b| (a, b)));
            assert_eq!(
                parts(a & b),
                join(&mut both().map(|(a, b)| a & b)),
                "{a:?} & {b:?}"
            );
            assert_eq!(
                parts(a | b),
                join(&mut both().map(|(a, b)| a | b)),
                "{a:?} | {b:?}"
            );
        }
        let (yes, no) = (Bounded::<f64>::exact(1.0), Bounded::exact(2.0));
        let chosen = Bounded::select(a, yes, no);
        assert_eq!(chosen.error == 0.0, a.decided());
        assert!(!a.decided() || chosen.value == if a.certain { 1.0 } else { 2.0 });
    }
}
