//! The four-bar of each crate behind one interface.

use std::hint::black_box;
use std::rc::Rc;

use with_linkage::FourBar;

/// Dimensions `a, b, c, dx, dy, p, u`: lengths in millimetres and an angle in radians.
pub(crate) type Dimensions = [f64; 7];

/// Computes values at all angles, one after the other.
type Pass = Box<dyn Fn(&[f64])>;

/// A function of the angle of the crank.
pub(crate) struct Evaluator {
    /// The values at one angle.
    pub values: Box<dyn Fn(f64) -> Vec<f64>>,
    /// Computes the values at all angles, one after the other.
    pub pass: Pass,
}

fn evaluator<const N: usize>(function: impl Fn(f64) -> [f64; N] + 'static) -> Option<Evaluator> {
    let function = Rc::new(function);
    let shared = Rc::clone(&function);
    Some(Evaluator {
        values: Box::new(move |phi| shared(phi).to_vec()),
        pass: Box::new(move |angles| {
            for phi in angles {
                black_box(function(black_box(*phi)));
            }
        }),
    })
}

/// The quantities that a crate computes.
pub(crate) struct Crate {
    pub name: &'static str,
    /// The tracer point.
    pub point: Option<Evaluator>,
    /// The tracer point with both derivatives.
    pub motion: Option<Evaluator>,
    /// The tracer point, then the effect of each dimension on its first and on its second component.
    pub sensitivities: Option<Evaluator>,
    /// The angle of the rocker and its derivative.
    pub rocker: Option<Evaluator>,
}

impl Crate {
    /// All functions with their names.
    pub(crate) fn functions(&self) -> [(&'static str, Option<&Evaluator>); 4] {
        [
            ("point", self.point.as_ref()),
            ("motion", self.motion.as_ref()),
            ("sensitivities", self.sensitivities.as_ref()),
            ("rocker", self.rocker.as_ref()),
        ]
    }
}

fn linkage([a, b, c, dx, dy, p, u]: Dimensions) -> Crate {
    let name = "linkage";
    let assembled = FourBar {
        a,
        b,
        c,
        dx,
        dy,
        p,
        u,
    }
    .assemble();
    let Ok(linkage) = assembled else {
        return Crate {
            name,
            point: None,
            motion: None,
            sensitivities: None,
            rocker: None,
        };
    };
    let linkage = Rc::new(linkage);
    let [one, two, three, four] = [0; 4].map(|_| Rc::clone(&linkage));
    Crate {
        name,
        point: evaluator(move |phi| one.point(phi).q.into()),
        motion: evaluator(move |phi| {
            let m = two.motion(phi);
            [m.q.x, m.q.y, m.v.x, m.v.y, m.a.x, m.a.y]
        }),
        sensitivities: evaluator(move |phi| {
            let s = three.sensitivities(phi);
            let mut values = [0.0; 16];
            (values[0], values[1]) = (s.q.x, s.q.y);
            for (i, e) in s.e.iter().enumerate() {
                (values[2 + i], values[9 + i]) = (e.x, e.y);
            }
            values
        }),
        rocker: evaluator(move |phi| {
            let r = four.rocker(phi);
            [r.psi, r.v]
        }),
    }
}

#[cfg(feature = "symplex")]
fn symplex([a, b, c, dx, dy, p, u]: Dimensions) -> Crate {
    Crate {
        name: "symplex",
        point: evaluator(move |phi| with_symplex::point(phi, a, b, c, dx, dy, p, u)),
        motion: evaluator(move |phi| with_symplex::motion(phi, a, b, c, dx, dy, p, u)),
        sensitivities: evaluator(move |phi| {
            with_symplex::sensitivities(phi, a, b, c, dx, dy, p, u)
        }),
        rocker: evaluator(move |phi| with_symplex::rocker(phi, a, b, c, dx, dy, p, u)),
    }
}

fn arael_sym([a, b, c, dx, dy, p, u]: Dimensions) -> Crate {
    Crate {
        name: "arael-sym",
        point: evaluator(move |phi| with_arael_sym::point(phi, a, b, c, dx, dy, p, u)),
        motion: evaluator(move |phi| with_arael_sym::motion(phi, a, b, c, dx, dy, p, u)),
        sensitivities: evaluator(move |phi| {
            with_arael_sym::sensitivities(phi, a, b, c, dx, dy, p, u)
        }),
        rocker: evaluator(move |phi| with_arael_sym::rocker(phi, a, b, c, dx, dy, p, u)),
    }
}

fn num_dual(dimensions: Dimensions) -> Crate {
    Crate {
        name: "num-dual",
        point: evaluator(move |phi| with_num_dual::point(phi, dimensions)),
        motion: evaluator(move |phi| {
            let [x, y] = with_num_dual::motion(phi, dimensions);
            [x.0, y.0, x.1, y.1, x.2, y.2]
        }),
        sensitivities: evaluator(move |phi| {
            let (point, effects) = with_num_dual::sensitivities(phi, dimensions);
            let mut values = [0.0; 16];
            (values[0], values[1]) = (point[0], point[1]);
            for i in 0..7 {
                (values[2 + i], values[9 + i]) = (effects[(0, i)], effects[(1, i)]);
            }
            values
        }),
        rocker: evaluator(move |phi| with_num_dual::rocker(phi, dimensions).into()),
    }
}

fn four_bar(dimensions: Dimensions) -> Crate {
    let mechanism = with_four_bar::mechanism(dimensions);
    let again = mechanism.clone();
    Crate {
        name: "four-bar",
        point: evaluator(move |phi| with_four_bar::point(&mechanism, phi).unwrap_or([f64::NAN; 2])),
        motion: None,
        sensitivities: None,
        rocker: evaluator(move |phi| [with_four_bar::rocker(&again, phi).unwrap_or(f64::NAN)]),
    }
}

fn symdiff([a, b, c, dx, dy, p, u]: Dimensions) -> Crate {
    let input = move |phi| [phi, a, b, c, dx, dy, p, u];
    Crate {
        name: "symdiff",
        point: evaluator(move |phi| {
            let x = input(phi);
            [with_symdiff::along(&x), with_symdiff::across(&x)]
        }),
        motion: None,
        sensitivities: evaluator(move |phi| {
            let x = input(phi);
            let (point, along) = (
                [with_symdiff::along(&x), with_symdiff::across(&x)],
                with_symdiff::along_gradient(&x),
            );
            let across = with_symdiff::across_gradient(&x);
            let mut values = [0.0; 16];
            values[..2].copy_from_slice(&point);
            values[2..9].copy_from_slice(&along[1..]);
            values[9..].copy_from_slice(&across[1..]);
            values
        }),
        rocker: None,
    }
}

/// A mechanism in all crates, this project's first.
pub(crate) fn all(dimensions: Dimensions) -> Vec<Crate> {
    let crates: &[fn(Dimensions) -> Crate] = &[
        linkage,
        #[cfg(feature = "symplex")]
        symplex,
        arael_sym,
        num_dual,
        four_bar,
        symdiff,
    ];
    crates.iter().map(|with| with(dimensions)).collect()
}
