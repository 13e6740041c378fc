//! The kernels in 154 digits: the circles of the dyads intersected as they are, derivatives as central
//! differences with tiny steps.

use crate::{Motion, Position};
use linkage_reference::{Big, Plane};

/// Steps are this power of two: 1.1e-36, so that second differences keep 80 digits.
const STEP: i32 = -120;

/// A number as the sum of two, good for about 32 digits.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    high: f64,
    low: f64,
}

impl Exact {
    fn new(x: &Big) -> Self {
        let high = x.to_f64();
        let low = (x - &Big::from(high)).to_f64();
        Self { high, low }
    }

    /// How far a number lies from this one; the number may come in two parts.
    #[must_use]
    pub fn distance(self, high: f64, low: f64) -> f64 {
        ((high - self.high) + (low - self.low)).abs()
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn value(self) -> f64 {
        self.high
    }
}

/// A kernel: a point from the dimensions and the input.
#[derive(Clone, Copy, Debug)]
pub struct Reference<const N: usize> {
    dimensions: [f64; N],
    point: fn(&[Big], &Big) -> Plane,
}

/// K1, its dimensions in the order of the mechanism's parameters.
#[must_use]
pub fn k1(dimensions: [f64; 7]) -> Reference<7> {
    Reference {
        dimensions,
        point: tracer,
    }
}

/// K2, its dimensions in the order of the mechanism's parameters.
#[must_use]
pub fn k2(dimensions: [f64; 12]) -> Reference<12> {
    Reference {
        dimensions,
        point: needle,
    }
}

impl<const N: usize> Reference<N> {
    fn big(&self) -> Vec<Big> {
        self.dimensions.iter().map(|&x| Big::from(x)).collect()
    }

    /// The point.
    #[must_use]
    pub fn point(&self, phi: f64) -> [Exact; size_of::<Position>() / 8] {
        let p = (self.point)(&self.big(), &Big::from(phi));
        [&p.x, &p.y].map(Exact::new)
    }

    /// The point with both derivatives by the input.
    #[must_use]
    pub fn motion(&self, phi: f64) -> [Exact; size_of::<Motion>() / 8] {
        let dimensions = self.big();
        let step = Big::power_of_two(STEP);
        let (more, less) = (Big::from(phi) + &step, Big::from(phi) - &step);
        let [after, here, before] =
            [&more, &Big::from(phi), &less].map(|phi| (self.point)(&dimensions, phi));
        let first = |after: &Big, before: &Big| (after - before) * Big::power_of_two(-STEP - 1);
        let second = |after: &Big, here: &Big, before: &Big| {
            (after + before - here * 2.0) * Big::power_of_two(-2 * STEP)
        };
        [
            Exact::new(&here.x),
            Exact::new(&here.y),
            Exact::new(&first(&after.x, &before.x)),
            Exact::new(&first(&after.y, &before.y)),
            Exact::new(&second(&after.x, &here.x, &before.x)),
            Exact::new(&second(&after.y, &here.y, &before.y)),
        ]
    }

    /// The point with its sensitivities: the point, then two numbers for each dimension.
    #[must_use]
    pub fn accuracy(&self, phi: f64) -> Vec<Exact> {
        let mut dimensions = self.big();
        let phi = Big::from(phi);
        let here = (self.point)(&dimensions, &phi);
        let mut row = vec![Exact::new(&here.x), Exact::new(&here.y)];
        let step = Big::power_of_two(STEP);
        for index in 0..N {
            let value = Big::from(self.dimensions[index]);
            dimensions[index] = &value + &step;
            let after = (self.point)(&dimensions, &phi);
            dimensions[index] = &value - &step;
            let before = (self.point)(&dimensions, &phi);
            dimensions[index] = value;
            for difference in [after.x - before.x, after.y - before.y] {
                row.push(Exact::new(&(difference * Big::power_of_two(-STEP - 1))));
            }
        }
        row
    }
}

/// `base` times `along`, and its left-hand normal times `across`.
fn combine(base: &Plane, along: &Big, across: &Big) -> Plane {
    base.times(along) + base.quarter().times(across)
}

/// The corner of a triangle from the start of its base: `first` from there, `second` from its end, to
/// the left or (-1) to the right.
fn corner(base: &Plane, first: &Big, second: &Big, side: f64) -> Plane {
    let square = base.dot(base);
    let along = (&square + first * first - second * second) / (&square * 2.0);
    let across = (first * first / &square - &along * &along).sqrt() * side;
    combine(base, &along, &across)
}

fn tracer(d: &[Big], phi: &Big) -> Plane {
    let pin = Plane::direction(phi).times(&d[0]);
    let base = Plane::new(d[3].clone(), d[4].clone()) - pin.clone();
    let coupler = corner(&base, &d[1], &d[2], 1.0);
    let lever = coupler.times(&(&d[5] / &d[1]));
    pin + lever.turned(&Plane::direction(&d[6]))
}

fn needle(d: &[Big], phi: &Big) -> Plane {
    let [p4, p7] = [0, 2].map(|i| Plane::new(d[i].clone(), d[i + 1].clone()));
    let angle = |x: f64| Plane::direction(&Big::from(x));
    let pin = Plane::direction(phi).times(&d[4]);
    let base = p4.clone() - pin.clone();
    let p3 = pin + corner(&base, &d[5], &d[6], -1.0);
    let rocker = (p3 - p4.clone()).times(&(Big::from(1.0) / &d[6]));
    let arm = rocker.turned(&Plane::direction(&d[11]));
    let guide = arm.turned(&angle(std::f64::consts::FRAC_PI_2));
    let p5 = p4 + arm.times(&d[7]);
    let start = 15f64.to_radians();
    let p8 = p7 + Plane::direction(&(Big::from(start) - phi * 0.5)).times(&d[8]);
    let to = p8 - p5.clone();
    let distance = guide.cross(&to);
    let slide = guide.dot(&to) - (&d[9] * &d[9] - &distance * &distance).sqrt();
    p5 + guide.times(&(slide - &d[10]))
}
