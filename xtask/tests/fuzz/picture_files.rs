//! Picture files that somebody damaged: read, or refused in a line.

use crate::properties::picture_file;
use crate::{cases, files};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// Small pictures in every format that is read, and in their odd kinds.
static SEEDS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| files("fuzz/seeds/picture_file"));

/// What damages a file.
#[derive(Clone, Debug)]
enum Damage {
    Cut(Index),
    Flip(Index, u8),
    Replace(Index, usize, Vec<u8>),
    /// Four bytes that may be a length or a side, large or not, in either order.
    Number(Index, u32, bool),
    /// The same, early in the file, where headers are.
    Header(usize, u32, bool),
}

fn damage() -> impl Strategy<Value = Damage> {
    let number = || {
        prop_oneof![
            any::<u32>(),
            select(vec![
                0,
                1,
                31,
                32,
                65_535,
                100_000,
                0x7fff_ffff,
                0xffff_ffff
            ]),
        ]
    };
    let bytes = prop::collection::vec(any::<u8>(), 0..8);
    prop_oneof![
        1 => any::<Index>().prop_map(Damage::Cut),
        4 => (any::<Index>(), any::<u8>()).prop_map(|(at, bits)| Damage::Flip(at, bits)),
        2 => (any::<Index>(), 0_usize..8, bytes)
            .prop_map(|(at, gone, bytes)| Damage::Replace(at, gone, bytes)),
        2 => (any::<Index>(), number(), any::<bool>())
            .prop_map(|(at, number, big)| Damage::Number(at, number, big)),
        3 => (0_usize..64, number(), any::<bool>())
            .prop_map(|(at, number, big)| Damage::Header(at, number, big)),
    ]
}

fn damaged(mut file: Vec<u8>, damages: Vec<Damage>) -> Vec<u8> {
    for damage in damages {
        let length = file.len();
        let put = |file: &mut Vec<u8>, at: usize, number: u32, big: bool| {
            let bytes = if big {
                number.to_be_bytes()
            } else {
                number.to_le_bytes()
            };
            let at = at.min(length.saturating_sub(4));
            let end = length.min(at + 4);
            file.splice(at..end, bytes);
        };
        match damage {
            Damage::Cut(at) => file.truncate(at.index(length + 1)),
            Damage::Flip(at, bits) if length > 0 => file[at.index(length)] ^= bits,
            Damage::Flip(..) => {}
            Damage::Replace(at, gone, bytes) => {
                let at = at.index(length + 1);
                file.splice(at..length.min(at + gone), bytes);
            }
            Damage::Number(at, number, big) => put(&mut file, at.index(length + 1), number, big),
            Damage::Header(at, number, big) => put(&mut file, at, number, big),
        }
    }
    file
}

fn file() -> impl Strategy<Value = Vec<u8>> {
    let damages = prop::collection::vec(damage(), 1..5);
    (any::<Index>(), damages).prop_map(|(seed, damages)| damaged(seed.get(&SEEDS).clone(), damages))
}

/// No file makes the reader panic, or take longer than [`LONGEST`].
#[test]
fn picture_files() {
    let count = cases(3000).cases;
    let mut runner = TestRunner::new(ProptestConfig::default());
    let (mut read, mut refused) = (0, 0);
    for _ in 0..count {
        let bytes = file().new_tree(&mut runner).expect("a file").current();
        let start = Instant::now();
        if picture_file(&bytes) {
            read += 1;
        } else {
            refused += 1;
        }
        let time = start.elapsed();
        assert!(time < LONGEST, "{time:?} for {bytes:?}");
    }
    // Else the damage is of one kind only.
    assert!(
        read * 20 > count && refused * 20 > count,
        "{read} read, {refused} refused"
    );
}

/// The most time that a file may take; the largest picture that is judged takes less.
const LONGEST: Duration = Duration::from_secs(20);
