//! Results close, also where conditions nearly depend on each other; failures are counted.

use super::super::*;
use super::{coupler_at, point, spread};
use core::f64::consts::PI;
use linkage_random::Random;
use std::vec::Vec;

/// Returns the number of random problems: so many, or with `LINKAGE_LONG` 10,000.
fn count(few: usize) -> usize {
    match std::env::var_os("LINKAGE_LONG") {
        Some(_) => 10_000,
        None => few,
    }
}

/// Pairs so near to each other that rounding decides: a closed form leaves nothing of the
/// equations.
#[test]
fn pairs_close_also_where_they_nearly_depend_on_each_other() {
    let mut random = Random::new(11);
    let (mut left_out, mut returned) = (0, 0);
    for _ in 0..count(300) {
        let near = 10_f64.powf(random.between(-2.5, 0.0));
        let mut pair = Pair::default();
        let pairs: [Pair; 4] = core::array::from_fn(|_| {
            pair.input += near * random.between(0.2, 0.6);
            pair.output += near * random.between(0.2, 0.6);
            pair
        });
        let [a, b, c, _] = pairs;
        let start = random.between(-PI, PI);
        let of_four = [GivenStart::Input(start), GivenStart::Output(start)];
        let of_four = of_four.map(|start| Functions::of_four(&pairs, start));
        let of_three = Functions::of_three(&[a, b, c], start, random.between(-PI, PI));
        let all = of_four.into_iter().chain([of_three]);
        for found in all.filter_map(Result::ok) {
            left_out += found.undecided;
            returned += found.four_bars.len();
            assert!(found.undecided == 0 || !found.certified);
            for four_bar in &found.four_bars {
                let size = four_bar
                    .crank
                    .max(four_bar.coupler)
                    .max(four_bar.rocker)
                    .max(1.0);
                for pair in &pairs[..3] {
                    // The distance of both pins, as it is written by hand.
                    let (i, o) = (
                        four_bar.input_start + pair.input,
                        four_bar.output_start + pair.output,
                    );
                    let x = 1.0 + four_bar.rocker * o.cos() - four_bar.crank * i.cos();
                    let y = four_bar.rocker * o.sin() - four_bar.crank * i.sin();
                    let error = x.hypot(y) - four_bar.coupler;
                    assert!(error.abs() <= 2e-9 * size, "{error:e} {four_bar:?}");
                }
            }
        }
    }
    std::println!("{returned} close, {left_out} do not and are left out");
    assert!(
        left_out > 0 && returned > left_out,
        "{left_out} of {returned}"
    );
}

/// Links of three, four and five poses, some of them nearly parallel, keep their lengths.
#[test]
fn links_keep_their_lengths_in_all_poses() {
    let mut random = Random::new(12);
    let mut links = 0;
    for _ in 0..count(60) {
        let turn = 10_f64.powf(random.between(-6.0, 0.5));
        let poses: [Pose; 5] = core::array::from_fn(|_| {
            Pose::new(point(&mut random), turn * random.between(-1.0, 1.0))
        });
        let [a, b, c, d, _] = poses;
        let mut found: Vec<(Pivots, usize)> = Vec::new();
        let three = [a, b, c];
        found.extend(Pivots::with_fixed(&three, point(&mut random)).map(|pivots| (pivots, 3)));
        found.extend(Pivots::with_moving(&three, point(&mut random)).map(|pivots| (pivots, 3)));
        if let Ok(curve) = CentreCurve::of_poses(&[a, b, c, d]) {
            let on_line = curve.on_line(point(&mut random), random.between(0.0, PI));
            let all = curve.points(12).into_iter().chain(on_line);
            found.extend(all.map(|pivots| (pivots.pivots, 4)));
        }
        if let Ok(dyads) = Dyads::of_poses(&poses) {
            found.extend(dyads.links().map(|pivots| (pivots, 5)));
        }
        links += found.len();
        for (pivots, count) in found {
            let lengths = poses[..count].iter().map(|pose| pivots.length(pose));
            let [x, y] = pivots.fixed;
            let [u, v] = pivots.moving;
            let far = pivots
                .length(&a)
                .max(x.abs())
                .max(y.abs())
                .max(u.abs())
                .max(v.abs());
            let size = far.max(1.0);
            let off = spread(lengths) * pivots.length(&a);
            assert!(off <= 1e-8 * size, "{off:e} {pivots:?}");
        }
    }
    assert!(links > 300, "{links}");
}

/// A link of which one joint is moved by a ten-thousandth of its length is not returned.
#[test]
fn what_does_not_close_is_found_out() {
    let (fixed, tracer) = ([[0.25, -0.125], [3.0, 0.5]], [0.0, 0.0]);
    let poses = [0.2, 0.9, 1.7, 2.3].map(|angle| coupler_at(fixed, [1.0, 2.75, 2.0], angle, 1.0));
    let four_bar = FourBar {
        fixed,
        moving: [tracer, [2.75, 0.0]],
    };
    assert!(verify::closes(&four_bar, &poses));
    let off = FourBar {
        moving: [[1e-4, 0.0], [2.75, 0.0]],
        ..four_bar
    };
    assert!(!verify::closes(&off, &poses));
    let nowhere = FourBar {
        fixed: [[f64::NAN, 0.0], fixed[1]],
        ..four_bar
    };
    assert!(!verify::closes(&nowhere, &poses));
    // A point that turns about another one is on no line.
    let turned = [0.0, 0.4, 1.1].map(|angle| Pose::new([0.0, 0.0], angle));
    let dyad = Dyad::PointOnLine {
        moving: [1.0, 0.0],
        angle: 0.0,
    };
    assert!(!verify::leads(&dyad, &turned));
    let through = Dyad::LineThroughPoint {
        fixed: [1.0, 0.0],
        angle: 0.0,
    };
    assert!(!verify::leads(&through, &turned));
}
