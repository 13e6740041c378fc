//! Paths and certificates in parts; whole searches, which are for optimised code, with
//! `LINKAGE_LONG`.

mod curves;
mod divided;
mod generator;

use super::super::Pose;
use super::super::path::Pace;
use super::super::tests::coupler_at;
use super::equations::{Unknowns, with_turns};
use super::path::ParameterPath;
use super::search::{Data, SolutionSearch};
use super::task::Task;
use super::*;
use core::f64::consts::TAU;
use linkage_core::numeric::complex::{Complex, ONE};
use linkage_random::Random;
use std::println;

/// Nine points of Wampler, Morgan and Sommese (1992), their problem 3, which has 64 real triples;
/// Hauenstein and Sottile certified that number (ACM Transactions on Mathematical Software,
/// Algorithm 921).
const PROBLEM_3: [[f64; 2]; 9] = [
    [0.25, 0.00],
    [0.52, 0.10],
    [0.80, 0.70],
    [1.20, 1.00],
    [1.40, 1.30],
    [1.10, 1.48],
    [0.70, 1.40],
    [0.20, 1.00],
    [0.02, 0.40],
];

/// The example of FourBarLinkages.jl (github.com/JuliaHomotopyContinuation).
const JULIA: [[f64; 2]; 9] = [
    [0.8961867, -0.09802917],
    [1.2156535, -1.18749100],
    [1.5151435, -0.85449808],
    [1.6754775, -0.48768058],
    [1.7138690, -0.30099232],
    [1.7215236, 0.03269953],
    [1.6642029, 0.33241088],
    [1.4984171, 0.74435576],
    [1.3011834, 0.92153806],
];

/// Joints of the frame, points of the path, and the poses of the coupler in them, of a
/// crank-rocker.
struct Planted {
    fixed: [[f64; 2]; 2],
    coupler: f64,
    tracer: [f64; 2],
    poses: [Pose; 9],
}

impl Planted {
    fn new(random: &mut Random) -> Self {
        let fixed = [[10.0, 20.0], [70.0, random.between(15.0, 25.0)]];
        let lengths =
            [(17.0, 23.0), (50.0, 60.0), (40.0, 50.0)].map(|(low, high)| random.between(low, high));
        let tracer = [random.between(21.0, 39.0), random.between(16.0, 34.0)];
        let poses = core::array::from_fn(|i| {
            let angle = TAU / 9.0 * (i as f64 + random.between(0.1, 0.9));
            coupler_at(fixed, lengths, angle, 1.0)
        });
        Self {
            fixed,
            coupler: lengths[1],
            tracer,
            poses,
        }
    }

    fn points(&self) -> [[f64; 2]; 9] {
        self.poses.map(|pose| pose.place(self.tracer))
    }

    /// Its unknowns.
    fn unknowns(&self, task: &Task) -> Unknowns<Complex> {
        let unit = 1.0 / task.unit;
        let from_first = |point: [f64; 2]| (Complex::from(point) - task.first.into()).scaled(unit);
        let joints =
            [[0.0, 0.0], [self.coupler, 0.0]].map(|joint| from_first(self.poses[0].place(joint)));
        let fixed = self.fixed.map(from_first);
        core::array::from_fn(|i| {
            let number = match i / 2 {
                0 => joints[0],
                1 => fixed[0],
                2 => joints[1],
                3 => fixed[1],
                turn => Complex::polar(self.poses[turn - 3].angle - self.poses[0].angle),
            };
            if i % 2 == 0 {
                number
            } else {
                number.conjugate()
            }
        })
    }
}

/// Every four-bar keeps its lengths in all poses, and its coupler has the points.
fn assert_passes(triple: &Triple, points: &[[f64; 2]; 9]) {
    for PathFourBar {
        four_bar,
        poses,
        passage,
    } in &triple.four_bars
    {
        let known = four_bar.lengths(&poses[0]);
        let size = known.into_iter().fold(0.0, f64::max);
        for (pose, point) in poses.iter().zip(points) {
            for (length, known) in four_bar.lengths(pose).into_iter().zip(known) {
                assert!((length - known).abs() < 1e-11 * size, "{length} {known}");
            }
            let way = (pose.point[0] - point[0]).hypot(pose.point[1] - point[1]);
            assert!(way < 1e-14 * size.max(1.0), "{way}");
        }
        assert_eq!(passage.visits.len(), 9);
    }
    // Cognates have one curve: an order of one is that of all.
    let [first, second, third] = triple
        .four_bars
        .each_ref()
        .map(|path| path.passage.in_order);
    assert!(first == second && second == third);
}

#[test]
fn a_planted_four_bar_and_its_cognates() {
    let mut random = Random::new(11);
    for _ in 0..5 {
        let planted = Planted::new(&mut random);
        let points = planted.points();
        let task = Task::new(&points).unwrap();
        let shown = Data::new(&task.shifts).shown(&planted.unknowns(&task));
        let (certificate, _) = shown.expect("it is a solution");
        assert_eq!(certificate.real, Some(true));
        let triple = task.triple(&certificate);
        assert!(triple.error < 1e-9, "{}", triple.error);
        assert_passes(&triple, &points);
        assert!(triple.four_bars[0].passage.in_order && triple.four_bars[0].passage.one_branch(0));
        let [first, second, third] = triple.four_bars.each_ref().map(|path| path.four_bar.fixed);
        for (joint, known) in first.iter().zip(planted.fixed) {
            assert!((joint[0] - known[0]).hypot(joint[1] - known[1]) < 1e-9);
        }
        // Each two have a joint of the frame in common.
        let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        assert!(apart(first[0], second[0]) < 1e-9 && apart(first[1], third[0]) < 1e-9);
        assert!(apart(second[1], third[1]) < 1e-9, "{second:?} {third:?}");
    }
}

#[test]
fn what_is_stored_are_distinct_solutions() {
    let stored = stored_solutions::solutions();
    assert_eq!(stored.len(), TRIPLES);
    let shifts = stored_solutions::shifts();
    let data = Data {
        plain: shifts,
        wide: shifts.map(|pair| pair.map(Complex::wide)),
        discs: shifts.map(|pair| pair.map(super::super::ball::Ball::exact)),
    };
    let mut search = SolutionSearch::default();
    for unknowns in stored.iter().step_by(97) {
        let here = ParameterPath {
            from: &shifts,
            to: &shifts,
            arc: ONE,
        };
        let found = data
            .end(unknowns, &here, Pace::of_attempt(0))
            .expect("a solution is stored");
        search.index_of(found);
    }
    assert_eq!(search.found.len(), TRIPLES.div_ceil(97));
}

#[test]
fn paths_end_in_distinct_solutions() {
    let task = Task::new(&PROBLEM_3).unwrap();
    let data = Data::new(&task.shifts);
    let shifts = stored_solutions::shifts();
    let way = ParameterPath {
        from: &shifts,
        to: &data.plain,
        arc: Complex::polar(1.0),
    };
    let mut search = SolutionSearch::default();
    let starts = stored_solutions::solutions();
    for start in starts.iter().step_by(361) {
        search.index_of(data.end(start, &way, Pace::of_attempt(0)).expect("an end"));
    }
    assert_eq!(search.found.len(), 4);
}

#[test]
fn bad_points_and_searches_that_are_stopped() {
    let mut points = PROBLEM_3;
    points[7] = points[2];
    assert_eq!(
        nine_points(&points),
        Err(Unsolved::Equal { indices: [2, 7] })
    );
    points[7] = [f64::NAN, 0.0];
    assert_eq!(nine_points(&points), Err(Unsolved::NotFinite { index: 7 }));
    let stopped = Unsolved::Stopped {
        done: 0,
        count: TRIPLES,
    };
    assert_eq!(nine_points_reporting(&PROBLEM_3, |_| false), Err(stopped));
}

/// The points of planted four-bars, and random ones.
struct Problems(Random);

impl Problems {
    fn new() -> Self {
        Self(Random::new(12))
    }

    fn next(&mut self) -> (Planted, [[f64; 2]; 9]) {
        let planted = Planted::new(&mut self.0);
        let mut number = || self.0.between(-9.0, 9.0);
        (planted, [(); 9].map(|()| [number(), number()]))
    }
}

/// A triple of the fourth planted problem: a joint within a hundred thousandth of the point of the
/// path, links a hundred thousand times as long.
#[test]
fn a_triple_next_to_singular_ones_is_shown() {
    let mut problems = Problems::new();
    let [.., (planted, _)] = [(); 4].map(|()| problems.next());
    let task = Task::new(&planted.points()).unwrap();
    let data = Data::new(&task.shifts);
    // The end of its path.
    let joints = [
        [1.2341065667922137e-5, 9.360122646304186e-6],
        [-59509.26606023089, 35091.35030932802],
        [-0.8598345796440185, -0.10203461535688649],
        [-11631.035958614173, 48279.051548496675],
        [1.2340927977321717e-5, 9.359890323326815e-6],
        [-0.7300251330826593, 0.9581015533199039],
        [-0.7300127921584336, -0.9580921934171405],
        [-0.7300127921544455, 0.9580921934298907],
    ];
    let unknowns = with_turns(&joints.map(Complex::from), &data.plain);
    assert!(data.shown(&unknowns).is_none(), "77 digits are needed");
    let (certificate, _) = data.shown_long(&unknowns).expect("it is a solution");
    assert_eq!(certificate.real, Some(false));
    for (disc, unknown) in certificate.discs.iter().zip(unknowns) {
        assert!(disc.radius <= f64::EPSILON * disc.size(), "{disc:?}");
        assert!(
            (disc.middle - unknown).size() < 1e-4 * unknown.size(),
            "{disc:?} {unknown:?}"
        );
    }
}

/// All triples of a published problem and of planted ones.
#[test]
fn whole_searches() {
    if !linkage_random::is_long() {
        return;
    }
    let check = |name: &str, points: &[[f64; 2]; 9]| {
        let clock = std::time::Instant::now();
        let found = nine_points(points).unwrap();
        let (seconds, real) = (clock.elapsed().as_secs_f64(), found.triples.len());
        println!(
            "{name}: {real} real, {} complex, {} undecided, {seconds:.2} s",
            found.complex, found.undecided
        );
        assert_eq!((real + found.complex, found.undecided), (TRIPLES, 0));
        assert!(found.is_complete());
        for triple in &found.triples {
            assert_passes(triple, points);
        }
        found
    };
    assert_eq!(check("problem 3", &PROBLEM_3).triples.len(), 64);
    check("FourBarLinkages.jl", &JULIA);
    let mut problems = Problems::new();
    for i in 0..6 {
        let (planted, random) = problems.next();
        let found = check(&std::format!("planted {i}"), &planted.points());
        let four_bars = found.triples.iter().flat_map(|triple| &triple.four_bars);
        let near = |joint: [f64; 2], known: [f64; 2]| {
            (joint[0] - known[0]).hypot(joint[1] - known[1]) < 1e-8
        };
        let [a, b] = planted.fixed;
        let is_planted = |path: &PathFourBar| {
            let [c, d] = path.four_bar.fixed;
            (near(c, a) && near(d, b)) || (near(c, b) && near(d, a))
        };
        assert_eq!(four_bars.filter(|path| is_planted(path)).count(), 1);
        let triples = found
            .triples
            .iter()
            .filter(|triple| triple.four_bars[0].passage.in_order);
        println!("  {} pass the points in their order", triples.count());
        check("random", &random);
    }
}
