//! How many operations Figure 3(c) takes, and how fast it could be for them.

use super::counted::{Counted, Counts, take};
use super::result::{Limit, Operations, Row, Store};
use crate::case;
use crate::error::Result;
use ombrage::{
    Chain, Film, Float, LabChain, Lighting, PerspectiveCamera, Quality, Relative, Shadow, Size,
    Triple, Vector, lab,
};
use std::array;

/// The counts of both chains, for each number of pixels that are computed together.
///
/// # Errors
/// None: the lab's scene is valid.
pub fn count<F: Float>(size: Size, lanes: &[usize]) -> Result<Vec<Operations>> {
    let (scene, view) = (lab::scene::<F>()?, lab::view::<F>());
    let camera = PerspectiveCamera::new(&view, F::from_f64(size.aspect()))?;
    let lab_chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator: case::direct(Quality::Textbook, Some(Shadow::UlpOffset)),
    };
    let (scene, view) = (lab::scene()?, lab::view());
    let relative = Relative::<F>::new(&scene, &view, size, Lighting::Shadowed)?;
    let mut operations = vec![];
    for &lanes in lanes {
        operations.push(of("lab", &lab_chain, size, lanes));
        operations.push(of("relative", &relative, size, lanes));
    }
    Ok(operations)
}

fn of<F: Float, C: Chain<F>>(name: &str, chain: &C, size: Size, lanes: usize) -> Operations {
    let counts = match lanes {
        4 => together::<F, C, 4>(chain, size),
        8 => together::<F, C, 8>(chain, size),
        16 => together::<F, C, 16>(chain, size),
        32 => together::<F, C, 32>(chain, size),
        _ => together::<F, C, 1>(chain, size),
    };
    let per_pixel = |count: u64| count as f64 / size.pixels() as f64;
    Operations {
        float: F::NAME.into(),
        chain: name.into(),
        lanes,
        add_mul: per_pixel(counts.add_mul),
        compare_select: per_pixel(counts.compare_select),
        divide: per_pixel(counts.divide),
        sqrt: per_pixel(counts.sqrt),
    }
}

/// Computes the picture, `N` pixels at a time from left to right, as the kit does: columns, rows and
/// the background once.
fn together<F: Float, C: Chain<F>, const N: usize>(chain: &C, size: Size) -> Counts {
    type Vector3<F, const N: usize> = Triple<Counted<F, N>>;
    let (width, height) = (size.width(), size.height());
    let bytes = |radiance: Vector3<F, N>| radiance.to_array().map(|x| Film::Clamp.byte(x));
    take();
    let packet = |first: usize| {
        let column = |i: usize| (first as u32 + i as u32).min(width - 1);
        chain.across(Counted(array::from_fn(|i| C::coordinate(column(i), width))))
    };
    let columns: Vec<Vector3<F, N>> = (0..width as usize).step_by(N).map(packet).collect();
    let background = Vector3::<F, N>::splat((), &chain.background());
    bytes(background);
    for row in 0..height {
        let down = chain.down(Counted([C::coordinate(row, height); N]));
        for &across in &columns {
            if let Some((mask, reflected)) = chain.reflected::<Counted<F, N>>(across + down) {
                bytes(Vector::select(mask, reflected, background));
            }
        }
    }
    take()
}

/// Gives rows of Figure 3(c) on one thread the share of the machine's limit that they reach.
///
/// No picture can be faster than its additions, multiplications, comparisons and selections at the
/// best rate that was measured for any of them, nor than its divisions and roots, which share one
/// unit, nor than the store of its bytes. What else it takes - loads, moves, logic, conversions,
/// loops - is not counted, so the limit cannot be reached.
pub fn judge(rows: &mut [Row], limits: &[Limit], operations: &[Operations], stores: &[Store]) {
    for row in rows.iter_mut().filter(|row| row.threads == 1) {
        let limit = limits
            .iter()
            .find(|limit| (&limit.float, &limit.level) == (&row.float, &row.level));
        let Some(limit) = limit.filter(|_| is_counted(row)) else {
            continue;
        };
        let counted = operations.iter().find(|counted| {
            let together = (&counted.float, &counted.chain, counted.lanes);
            together == (&row.float, &row.chain, 2 * limit.lanes)
        });
        let store = stores
            .iter()
            .find(|store| (store.width, store.height) == (row.width, row.height));
        if let (Some(counted), Some(store)) = (counted, store) {
            row.share_of_limit = Some(fastest(counted, limit, store) / row.ns_per_pixel);
        }
    }
}

/// Whether a row is computed as the operations were counted.
fn is_counted(row: &Row) -> bool {
    let as_figure = row.shadow == Shadow::UlpOffset.name()
        && row.quality.as_deref() == Some(Quality::Textbook.name())
        && row.query.as_deref() == Some("any");
    row.chain == "relative" || row.chain == "lab" && as_figure
}

/// The least nanoseconds a pixel.
fn fastest(counted: &Operations, limit: &Limit, store: &Store) -> f64 {
    let best = limit.add_mul_ns.min(limit.compare_select_ns);
    let arithmetic = (counted.add_mul + counted.compare_select) * best;
    let divider = counted.divide * limit.divide_ns + counted.sqrt * limit.sqrt_ns;
    let lanes = limit.lanes as f64;
    (arithmetic / lanes)
        .max(divider / lanes)
        .max(store.ns_per_pixel)
}

/// How many pixels are computed together at these levels: two packets; and one, for scalars.
pub fn together_at(limits: &[Limit]) -> Vec<usize> {
    let mut lanes = vec![1];
    lanes.extend(limits.iter().map(|limit| 2 * limit.lanes));
    lanes.dedup();
    lanes
}
