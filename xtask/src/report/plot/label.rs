//! Where the labels of marks stand, so that none covers another or a mark.

/// The height of a line of text, in pixels.
const LINE: f64 = 15.0;
/// The mean width of a letter: 0.56 of the size, for the fonts of the page.
const LETTER: f64 = 7.1;

/// A rectangle: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area(pub [f64; 4]);

impl Area {
    fn overlaps(self, other: Area) -> bool {
        let (Area(a), Area(b)) = (self, other);
        a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
    }

    fn is_within(self, outer: Area) -> bool {
        let (Area(a), Area(b)) = (self, outer);
        a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3]
    }
}

/// Where a label stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Label {
    /// Where its text starts or ends, on its baseline.
    pub at: [f64; 2],
    /// Whether it ends there.
    pub ends: bool,
    /// Whether it is so far from its mark that a line should lead to it.
    pub led: bool,
}

/// Places the labels of some marks of a radius, one after the other, each at the first place near
/// its mark that is free; at the nearest, if none is.
pub fn place(
    labels: &[([f64; 2], &str)],
    marks: &[[f64; 2]],
    radius: f64,
    page: Area,
) -> Vec<Label> {
    let around = |[x, y]: [f64; 2]| Area([x - radius, y - radius, x + radius, y + radius]);
    let mut taken: Vec<Area> = marks.iter().map(|&mark| around(mark)).collect();
    let gap = radius + 4.0;
    let mut placed = vec![];
    for &([x, y], text) in labels {
        let width = text.chars().count() as f64 * LETTER;
        let candidate = |right: f64, down: f64, ends: bool| {
            let start = if ends { x - right - width } else { x + right };
            let area = Area([
                start,
                y + down - LINE / 2.0,
                start + width,
                y + down + LINE / 2.0,
            ]);
            let at = [
                if ends { x - right } else { x + right },
                y + down + LINE * 0.3,
            ];
            let led = down.abs() > LINE || right > 2.0 * gap;
            (area, Label { at, ends, led })
        };
        let shifts = [0.0, -0.8, 0.8, -1.6, 1.6, -2.4, 2.4, -3.4, 3.4, -4.6, 4.6];
        let candidates = [1.0, 3.0, 6.0].into_iter().flat_map(|away| {
            shifts
                .into_iter()
                .flat_map(move |down| [(away, down, false), (away, down, true)])
        });
        let candidates: Vec<(Area, Label)> = candidates
            .map(|(away, down, ends)| candidate(away * gap, down * LINE, ends))
            .filter(|(area, _)| area.is_within(page))
            .collect();
        let is_free = |(area, _): &&(Area, Label)| !taken.iter().any(|other| other.overlaps(*area));
        let found = candidates.iter().find(is_free).or(candidates.first());
        let (area, label) = found.copied().unwrap_or(candidate(gap, 0.0, false));
        taken.push(area);
        placed.push(label);
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crowded_labels_do_not_overlap() {
        let marks: Vec<[f64; 2]> = (0..8).map(|i| [100.0 + f64::from(i), 100.0]).collect();
        let labels: Vec<([f64; 2], &str)> = marks.iter().map(|&mark| (mark, "a label")).collect();
        let page = Area([0.0, 0.0, 400.0, 400.0]);
        let placed = place(&labels, &marks, 4.0, page);
        let area = |label: &Label| {
            let [x, y] = label.at;
            let width = 7.0 * LETTER;
            let left = if label.ends { x - width } else { x };
            Area([
                left,
                y - LINE * 0.8 + 0.1,
                left + width,
                y + LINE * 0.2 - 0.1,
            ])
        };
        for (i, a) in placed.iter().enumerate() {
            for b in &placed[i + 1..] {
                assert!(!area(a).overlaps(area(b)), "{a:?} {b:?}");
            }
        }
        assert_eq!(placed.len(), 8);
    }
}
