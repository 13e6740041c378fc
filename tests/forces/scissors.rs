//! Scissor lifts with a cylinder against statics of each arm, in closed form: arms whose angles
//! follow from one unknown, arms with unknowns of their own, blocks or rollers at the sliding ends.
//! Two stages with weights against the equilibrium of all bodies.

use linkage::Vector2;

use super::{Instant, Kind, NEWTON, Rate, Vector, each, flat, pin};

/// A lift of one stage with these unknowns, loops, bodies and joints besides the first arm.
macro_rules! lift {
    ($name:ident, $forces:ident, { $($unknowns:tt)* } { $($loops:tt)* } { $($bodies:tt)* }) => {
        linkage_interpreted::interpreted! {
            pub struct $name {
                unit mm;
                param arm = 1200mm;
                param foot = (350mm, -60mm);
                param head = 820mm;
                param place = 400mm;
                argument load = 5kN;
                input length = 620mm in 560mm..700mm;
                $($unknowns)*
                let rod_end = polar(head, alpha);
                let middle = polar(arm / 2, alpha);
                let right_up = polar(arm, alpha);
                $($loops)*
                body first = pin p on frame at (0, 0), turns alpha;
                $($bodies)*
                force (0, -load) on platform at left_up + (place, 0);
            }
            impl $name {
                pub fn forces(length, load) -> $forces {
                    alpha, f: force(length), ratio: velocity(right_up.y),
                    p: reaction(p), m: reaction(m), q: reaction(q), r: reaction(r), s: reaction(s), h: reaction(h),
                }
            }
        }
    };
}

lift! { Shared, SharedForces, {
        unknown alpha = 40deg;
    } {
        loop distance(foot, rod_end) = length;
        let right_down = (arm * cos(alpha), 0);
        let left_up = (0, arm * sin(alpha));
    } {
        body second = pin m on first at middle, turns -alpha;
        body platform = pin q on second at left_up, turns 0deg;
        body low = slide on frame at right_down along (1, 0);
        body high = slide on platform at right_up along (1, 0);
        pin r = second on low at right_down;
        pin s = first on high at right_up;
        body barrel = pin f on frame at foot, turns angle(rod_end - foot);
        body rod = slide g on barrel at rod_end along rod_end - foot;
        pin h = rod on first at rod_end;
} }

lift! { Separate, SeparateForces, {
        unknown alpha = 40deg;
        unknown beta = 140deg;
        unknown gamma = 60deg;
        unknown x = 900mm;
    } {
        loop foot + polar(length, gamma) = rod_end;
        let right_down = (x, 0);
        loop right_down + polar(arm / 2, beta) = middle;
        let left_up = right_down + polar(arm, beta);
    } {
        body low = slide on frame at right_down along (1, 0);
        body second = pin r on low at right_down, turns beta;
        pin m = second on first at middle;
        body platform = pin q on second at left_up, turns 0deg;
        body high = slide on platform at right_up along (1, 0);
        pin s = first on high at right_up;
        body barrel = pin f on frame at foot, turns gamma;
        body rod = slide g on barrel at rod_end along dir(gamma);
        pin h = rod on first at rod_end;
} }

lift! { Rolling, RollingForces, {
        unknown alpha = 40deg;
    } {
        loop distance(foot, rod_end) = length;
        let right_down = (arm * cos(alpha), 0);
        let left_up = (0, arm * sin(alpha));
    } {
        body second = pin m on first at middle, turns -alpha;
        body platform = pin q on second at left_up, turns 0deg;
        roller r = second on frame at right_down along (1, 0);
        roller s = first on platform at right_up along (1, 0);
        body barrel = pin f on frame at foot, turns angle(rod_end - foot);
        body rod = slide g on barrel at rod_end along rod_end - foot;
        pin h = rod on first at rod_end;
} }

lift! { OnRollers, OnRollersForces, {
        unknown alpha = 40deg;
        unknown beta = 140deg;
        unknown x = 900mm;
    } {
        loop distance(foot, rod_end) = length;
        let right_down = (x, 0);
        loop right_down + polar(arm / 2, beta) = middle;
        let left_up = right_down + polar(arm, beta);
    } {
        body second = roller r on frame at right_down along (1, 0), turns beta;
        pin m = second on first at middle;
        body platform = pin q on second at left_up, turns 0deg;
        roller s = first on platform at right_up along (1, 0);
        body barrel = pin f on frame at foot, turns angle(rod_end - foot);
        body rod = slide g on barrel at rod_end along rod_end - foot;
        pin h = rod on first at rod_end;
} }

/// Returns the angle of the first arm, the force of the cylinder, and the reactions `p m q r s h`,
/// from the statics of each body.
fn statics(arm: f64, head: f64, foot: Vector2<f64>, place: f64, length: f64, load: f64) -> Statics {
    let base = foot.x.hypot(foot.y);
    let cosine = (base * base + head * head - length * length) / (2.0 * base * head);
    let alpha = foot.y.atan2(foot.x) + cosine.acos();
    let (sin, cos) = alpha.sin_cos();
    let end = Vector2::new(head * cos, head * sin);
    let along = (end - foot) / length;
    // The platform: the two arms share the load.
    let s = load * place / (arm * cos);
    let q = load - s;
    // The second arm: about its middle both ends push downwards alike.
    let (m, r) = (2.0 * q, -q);
    // The first arm: about its foot.
    let f = (m * 0.5 + s) * arm * cos / (end.x * along.y - end.y * along.x);
    let up = |y| Vector2::new(0.0, y);
    Statics {
        alpha,
        f,
        reactions: [
            up(m + s) - along * f,
            up(m),
            up(q),
            up(r),
            up(-s),
            -along * f,
        ],
    }
}

struct Statics {
    alpha: f64,
    f: f64,
    reactions: [Vector2<f64>; 6],
}

impl Statics {
    #[track_caller]
    fn expect(&self, alpha: f64, f: f64, reactions: [Vector2<f64>; 6]) {
        assert!((alpha - self.alpha).abs() < 1e-13, "{alpha} {}", self.alpha);
        let limit = 1e-12 * self.f.abs();
        assert!((f - self.f).abs() < limit, "{f} {}", self.f);
        for (number, (found, known)) in reactions.iter().zip(self.reactions).enumerate() {
            let error = (found - known).norm();
            assert!(error < limit, "reaction {number}: {found:?}, not {known:?}");
        }
    }
}

macro_rules! compare {
    ($name:ident) => {{
        let lift = $name::default();
        let assembled = lift.assemble().unwrap();
        for (length, load) in [
            (560.0, 5000.0),
            (601.5, -300.0),
            (650.0, 1.0),
            (700.0, 12e3),
        ] {
            let found = assembled.forces(length, load);
            let known = statics(lift.arm, lift.head, lift.foot, lift.place, length, load);
            let reactions = [found.p, found.m, found.q, found.r, found.s, found.h];
            known.expect(found.alpha, found.f, reactions);
            // Virtual work: the cylinder lifts the load.
            let work = load * found.ratio;
            assert!(
                (found.f - work).abs() < 1e-12 * work.abs(),
                "{} {work}",
                found.f
            );
        }
    }};
}

#[test]
fn arms_share_one_unknown() {
    compare!(Shared);
}

#[test]
fn arms_end_on_rollers() {
    compare!(Rolling);
    compare!(OnRollers);
}

#[test]
fn arms_have_unknowns_of_their_own() {
    compare!(Separate);
}

linkage_interpreted::interpreted! {
    /// Two stages of arms with weights, whose angles follow from one unknown.
    pub struct Stages {
        unit mm;
        param arm = 1200mm;
        param foot = (350mm, -60mm);
        param head = 820mm;
        param lug = 60mm;
        param cargo = 450mm;
        param mass = 15kg;
        argument load = 5kN;
        input length = 620mm in 560mm..760mm;
        unknown alpha = 40deg;
        let rod_end = polar(head, alpha) + polar(-lug, alpha + 90deg);
        loop distance(foot, rod_end) = length;
        let slide = (arm * cos(alpha), 0);
        let middle = polar(arm / 2, alpha);
        let left = (0, arm * sin(alpha));
        let right = polar(arm, alpha);
        let upper_middle = left + polar(arm / 2, alpha);
        let upper_right = left + polar(arm, alpha);
        let upper_left = (0, 2 * arm * sin(alpha));
        let place = upper_left + (cargo, 0);

        gravity = (0, -9.80665m/s^2);
        body first = pin j0 on frame at (0, 0), turns alpha, mass mass at middle;
        body second = pin j1 on first at middle, turns -alpha, mass mass at middle;
        body third = pin j2 on second at left, turns alpha, mass mass at upper_middle;
        body fourth = pin j3 on first at right, turns -alpha, mass mass at upper_middle;
        body platform = pin j4 on fourth at upper_left, turns 0deg;
        pin j5 = third on fourth at upper_middle;
        roller j6 = second on frame at slide along (1, 0);
        roller j7 = third on platform at upper_right along (1, 0);
        body barrel = pin j8 on frame at foot, turns angle(rod_end - foot);
        body rod = slide j9 on barrel at rod_end along rod_end - foot;
        pin j10 = rod on first at rod_end;
        force (0, -load) on platform at place;
    }
    impl Stages {
        pub fn places(length) -> StagesPlaces {
            rod_end, slide, middle, left, right, upper_middle, upper_right, upper_left, place,
        }
        pub fn forces(length, load) -> StagesForces {
            j0: reaction(j0), j1: reaction(j1), j2: reaction(j2), j3: reaction(j3), j4: reaction(j4), j5: reaction(j5),
            j6: reaction(j6), j7: reaction(j7), j8: reaction(j8), j9: reaction(j9), j10: reaction(j10),
            m9: moment(j9), f: force(length),
        }
        pub fn alone(length, load) -> StagesAlone { f: force(length) }
    }
}

#[test]
fn two_stages() {
    each(0x173, |m: Stages, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (length, load) = (random.between(560.0, 760.0), random.load(5e3));
        let at = linkage.places(length);
        if !at.slide.x.is_finite() {
            return false;
        }
        let mut all = Instant::new(true, m.arm, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [zero, x] = [Vector::zeros(), Vector::x()];
        let [end, foot, middle] = [at.rod_end, m.foot, at.middle].map(flat);
        let [upper_middle, slide, upper_right] =
            [at.upper_middle, at.slide, at.upper_right].map(flat);
        let still = |at: Vector2<f64>| Rate::REST.pivot(at, [0.0, 0.0]);
        let first = all.body(still(Vector2::zeros()).add_mass(m.mass, middle));
        let second = all.body(still(at.middle).add_mass(m.mass, middle));
        let third = all.body(still(at.left).add_mass(m.mass, upper_middle));
        let fourth = all.body(still(at.right).add_mass(m.mass, upper_middle));
        let platform = all.body(still(at.upper_left));
        let barrel = all.body(still(m.foot));
        let rod = all.body(still(at.rod_end));
        all.joint(pin(), first, None, zero);
        all.joint(pin(), second, Some(first), middle);
        all.joint(pin(), third, Some(second), flat(at.left));
        all.joint(pin(), fourth, Some(first), flat(at.right));
        all.joint(pin(), platform, Some(fourth), flat(at.upper_left));
        all.joint(pin(), third, Some(fourth), upper_middle);
        all.joint(Kind::Roller(x), second, None, slide);
        all.joint(Kind::Roller(x), third, Some(platform), upper_right);
        all.joint(pin(), barrel, None, foot);
        let cylinder = all.driven(Kind::Slide(end - foot), rod, Some(barrel), end);
        all.joint(pin(), rod, Some(first), end);
        all.force(
            [Some(platform), None],
            flat(at.place),
            Vector::new(0.0, -load, 0.0),
        );

        let solution = all.solve();
        let found = linkage.forces(length, load);
        solution.expect_forces([
            found.j0, found.j1, found.j2, found.j3, found.j4, found.j5, found.j6, found.j7,
            found.j8, found.j9, found.j10,
        ]);
        solution.expect_moment(cylinder, found.m9);
        let force = solution.drive(cylinder);
        let alone = linkage.alone(length, load).f;
        assert!(
            (found.f - force).abs() < 1e-11 * force.abs(),
            "{} {force}",
            found.f
        );
        assert!(
            (alone - force).abs() < 1e-11 * force.abs(),
            "{alone} {force}"
        );
        true
    });
}
