//! Least distances of all pairs of shapes, in the plane and in space.

use crate::distance::distance;
use crate::motion::Moving;
use crate::{TAU, TURN};
use linkage_analysis::clearance::Clearance;
use linkage_analysis::summary::{SummaryError, positions};
use linkage_analysis::tolerance::Tolerances;
use linkage_random::Random;
use linkage_runtime::Parameter;

const POSITIONS: usize = 91;
const DENSE: usize = 900;

type Shape<const K: usize, const A: usize> = [Moving<K>; A];

fn clearance<const K: usize, const A: usize, const B: usize>(
    first: &Shape<K, A>,
    second: &Shape<K, B>,
) -> Clearance<K>
where
    [f64; K]: linkage_analysis::tolerance::Components<K>,
{
    let shapes = |x| (first.map(|p| p.at(x)), second.map(|p| p.at(x)));
    Clearance::new(TURN, POSITIONS, shapes).expect("a clearance")
}

fn at<const K: usize, const A: usize>(shape: &Shape<K, A>, x: f64) -> [[f64; K]; A] {
    shape.map(|point| point.at(x)[0])
}

/// All minima against those of a dense search.
fn compare<const K: usize, const A: usize, const B: usize>(random: &mut Random) -> usize
where
    [f64; K]: linkage_analysis::tolerance::Components<K>,
{
    let first: Shape<K, A> = std::array::from_fn(|_| Moving::random(random, 20.0));
    let second: Shape<K, B> = std::array::from_fn(|_| Moving::random(random, 20.0));
    let found = clearance(&first, &second);
    let truth = |x: f64| distance(&at(&first, x), &at(&second, x));
    let dense: Vec<f64> = (0..DENSE)
        .map(|i| truth(TAU * i as f64 / DENSE as f64))
        .collect();
    let lowest = dense.iter().copied().fold(f64::INFINITY, f64::min);
    let least = found.least();
    assert!(least.distance <= lowest + 1e-9, "{least:?} {lowest}");
    assert!(
        (truth(least.at) - least.distance).abs() < 1e-9,
        "{least:?} {}",
        truth(least.at)
    );
    for nearest in found.minima() {
        assert!(
            (truth(nearest.at) - nearest.distance).abs() < 1e-7,
            "{nearest:?} {}",
            truth(nearest.at)
        );
    }
    if lowest < 1e-3 {
        assert!(least.distance < 1e-9, "{least:?} {lowest}");
        return found.minima().len();
    }
    let low = |i: &usize| {
        let [before, after] = [(i + DENSE - 1) % DENSE, (i + 1) % DENSE];
        dense[*i] < dense[before] && dense[*i] < dense[after]
    };
    for i in (0..DENSE).filter(low) {
        let x = TAU * i as f64 / DENSE as f64;
        let away = |a: f64| (a - x).abs().min(TAU - (a - x).abs());
        let near = found
            .minima()
            .iter()
            .any(|nearest| away(nearest.at) < 2.0 * TAU / DENSE as f64);
        assert!(
            near,
            "a minimum at {x} is missing among {:?}",
            found.minima()
        );
    }
    found.minima().len()
}

#[test]
fn all_minima() {
    let mut random = Random::new(22);
    let mut minima = 0;
    for _ in 0..7 {
        minima += compare::<2, 1, 1>(&mut random);
        minima += compare::<2, 1, 2>(&mut random);
        minima += compare::<2, 2, 1>(&mut random);
        minima += compare::<2, 2, 2>(&mut random);
        minima += compare::<3, 1, 1>(&mut random);
        minima += compare::<3, 1, 2>(&mut random);
        minima += compare::<3, 2, 2>(&mut random);
    }
    assert!(minima > 100, "{minima}");
}

/// The envelope theorem and the implicit function theorem against clearances of changed motions, in all cases of two
/// segments in space.
#[test]
fn sensitivities_are_differences() {
    let mut random = Random::new(7);
    let mut cases = std::collections::BTreeSet::new();
    for _ in 0..14 {
        let first: Shape<3, 2> = std::array::from_fn(|_| Moving::random(&mut random, 25.0));
        let second: Shape<3, 2> = std::array::from_fn(|_| Moving::random(&mut random, 25.0));
        let nominal = *clearance(&first, &second).least();
        let x = nominal.at;
        // Of two ends: the middle along y, and the cosine along x.
        let zero = [[0.0; 3]; 4];
        let by = |p: usize, vector: [f64; 3]| {
            let mut own = zero;
            own[p] = vector;
            own
        };
        let (sin, cos) = x.sin_cos();
        let e_first = [
            [by(0, [0.0, 1.0, 0.0]), by(0, [0.0; 3])],
            [by(1, [cos, 0.0, 0.0]), by(1, [-sin, 0.0, 0.0])],
        ];
        let e_second = [
            [by(2, [0.0, 1.0, 0.0]), by(2, [0.0; 3])],
            [by(3, [cos, 0.0, 0.0]), by(3, [-sin, 0.0, 0.0])],
        ];
        let value = nominal.sensitivity(e_first.map(|e| e[0]), e_second.map(|e| e[0]));
        let shift = nominal.shift(e_first, e_second);
        let changed = |p: usize, h: f64| {
            let (mut first, mut second) = (first, second);
            match p {
                0 => first[0] = first[0].moved(1, h),
                1 => first[1] = first[1].swung(0, h),
                2 => second[0] = second[0].moved(1, h),
                _ => second[1] = second[1].swung(0, h),
            }
            *clearance(&first, &second).least()
        };
        if nominal.distance == 0.0 {
            // In space two segments meet at single angles; then no error of a dimension parts them.
            assert!(value.iter().all(|e| e.is_nan()));
            continue;
        }
        let kind = nominal.feet.map(|foot| foot.fract() != 0.0);
        cases.insert(kind);
        for p in 0..4 {
            const H: f64 = 1e-5;
            let [more, less] = [changed(p, H), changed(p, -H)];
            let difference = (more.distance - less.distance) / (2.0 * H);
            assert!(
                (value[p] - difference).abs() < 1e-6,
                "{kind:?} {p}: {} {difference}",
                value[p]
            );
            let difference = (more.at - less.at) / (2.0 * H);
            // Where the least distance is flat its place is uncertain.
            let tolerance = 1e-5 * (1.0 + shift[p].abs());
            assert!(
                (shift[p] - difference).abs() < tolerance,
                "{kind:?} {p}: {} {difference}",
                shift[p]
            );
        }
    }
    assert_eq!(cases.len(), 4, "{cases:?}");
}

/// The coarse look from given rows finds the same.
#[test]
fn rows_of_a_sweep() {
    let mut random = Random::new(3);
    let first: Shape<2, 1> = [Moving::random(&mut random, 20.0)];
    let second: Shape<2, 2> = std::array::from_fn(|_| Moving::random(&mut random, 20.0));
    let shapes = |x| (first.map(|p| p.at(x)), second.map(|p| p.at(x)));
    let rows: Vec<_> = positions(TURN, POSITIONS).map(shapes).collect();
    let swept = Clearance::swept(TURN, POSITIONS, |i| rows[i], shapes);
    assert_eq!(swept, Ok(clearance(&first, &second)));
}

/// Two bars of a plane that cross for two degrees, between two positions; and some that always do.
#[test]
fn segments_that_cross() {
    let still = |x: f64, y: f64| [[x, y], [0.0; 2], [0.0; 2]];
    let fixed = [still(-1.0, 0.0), still(1.0, 0.0)];
    // The lower end of a bar above: 1 mm less 1 + 1e-3 at 2 degrees.
    let bar = |x: f64| {
        let (sin, cos) = (x - 2f64.to_radians()).sin_cos();
        let end = |y: f64| {
            [
                [0.2, y - 1.001 * cos],
                [0.0, 1.001 * sin],
                [0.0, 1.001 * cos],
            ]
        };
        [end(1.0), end(5.0)]
    };
    let found = Clearance::new(TURN, 19, |x| (fixed, bar(x))).expect("a clearance");
    assert!(found.least().distance < 1e-15, "{:?}", found.least());
    let crossed = [still(0.0, -1.0), still(0.3, 1.0)];
    let found = Clearance::new(TURN, 19, |_| (fixed, crossed)).expect("a clearance");
    assert!(found.least().distance == 0.0 && found.least().direction[0].is_nan());
}

/// A distance that does not change is told, as are a segment without length and a part of a turn.
#[test]
fn borders() {
    let still = |x: f64, y: f64| [[x, y], [0.0; 2], [0.0; 2]];
    let found = Clearance::new(TURN, 19, |_| {
        ([still(0.0, 0.0)], [still(3.0, -1.0), still(3.0, 4.0)])
    });
    let found = found.expect("a clearance");
    assert!(
        found.minima().len() == 1 && found.least().distance == 3.0 && found.least().feet[1] == 0.2
    );
    let found = Clearance::new(TURN, 19, |_| {
        ([still(0.0, 0.0)], [still(3.0, 4.0), still(3.0, 4.0)])
    });
    assert_eq!(found.expect("a clearance").least().distance, 5.0);
    let away = |x: f64| [[x, 0.0], [1.0, 0.0], [0.0; 2]];
    let found =
        Clearance::new((1.0, 2.0), 19, |x| ([away(x)], [still(0.0, 0.0)])).expect("a clearance");
    assert_eq!((found.least().at, found.least().distance), (1.0, 1.0));
    let missing = Clearance::new(TURN, 19, |_| ([[[f64::NAN; 2]; 3]], [still(0.0, 0.0)]));
    assert_eq!(missing, Err(SummaryError::NotAssembled { positions: 19 }));
}

/// Of two minima the one that is less sure is left with less.
#[test]
fn what_tolerances_leave() {
    // 10 mm at 0 degrees, 11 mm at 180 degrees, where the parameter counts tenfold.
    let point = |x: f64| {
        let (sin, cos) = (2.0 * x).sin_cos();
        let (s, c) = x.sin_cos();
        [
            [15.5 - 5.0 * cos - 0.5 * c, 0.0],
            [10.0 * sin + 0.5 * s, 0.0],
            [20.0 * cos + 0.5 * c, 0.0],
        ]
    };
    let still = [[0.0; 2]; 3];
    let found = Clearance::new(TURN, POSITIONS, |x| ([point(x)], [still])).expect("a clearance");
    assert_eq!(found.minima().len(), 2);
    let parameter = Parameter {
        name: "gap",
        unit: "mm",
        nominal: 1.0,
        tolerance: 0.5,
    };
    let tolerances = Tolerances::<1>::complete(&[parameter]).expect("a tolerance");
    let left = found.guaranteed(&tolerances, |nearest| {
        let share = 5.5 - 4.5 * nearest.at.cos();
        nearest.sensitivity([[[share, 0.0]]], [[[0.0; 2]]])
    });
    assert!((found.least().distance - 10.0).abs() < 1e-12 && (left.nominal - 11.0).abs() < 1e-12);
    assert!(
        (left.distance - 6.0).abs() < 1e-12 && (left.error - 5.0).abs() < 1e-12,
        "{left:?}"
    );
}
