//! Dyads of one slide: RRP on a fixed guide, and RPR on a swinging arm.

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};
use linkage::Vector2;

// Dyad RRP on a fixed guide, in both ways to declare it: the slider hangs on the frame and a pin closes the loop, or it hangs on the rod and
// its guide closes the loop.

macro_rules! slider_crank {
    ($name:ident, $forces:ident, { $($slider:tt)* } $($functions:tt)*) => {
        linkage_interpreted::interpreted! {
            pub struct $name {
                unit mm;
                param a = 40mm;
                param b = 120mm;
                param lean = 10deg;
                param offset = 5mm;
                param m1 = 130g;
                param m2 = 90g;
                param m3 = 0.5kg;
                param i2 = 150000g*mm^2;
                param rate = 1.5N/mm;
                param drag = 0.02N*s/mm;
                argument press = 50N;
                input phi = 40deg in 0deg..360deg at omega, epsilon;
                unknown theta = -10deg;
                unknown x = 150mm;
                let p2 = polar(a, phi);
                let p3 = x * dir(lean) + polar(offset, lean + 90deg);
                loop p2 + polar(b, theta) = p3;
                let c1 = polar(a / 4, phi);
                let c2 = p2 + polar(b / 3, theta);
                let tip = p3 + polar(30mm, lean + 40deg);

                gravity = (0, -9.80665m/s^2);
                body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at c1;
                body rod = pin b2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
                $($slider)*
                force (-press, press / 4) on slider at tip;
                spring rate on b4, free 100mm;
                damper drag on b4;
            }
            impl $name {
                pub fn forces(phi, omega, epsilon, press) -> $forces {
                    f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), m4: moment(b4), t: torque(phi), p: power(),
                }
                $($functions)*
            }
        }
    };
}

slider_crank! { SliderCrank, SliderCrankForces,
    {
        body slider = slide b4 on frame at p3 along dir(lean), mass m3 at tip;
        pin b3 = rod on slider at p3;
    }
    pub fn motion(phi) -> SliderCrankMotion {
        p2, v2: velocity(p2), a2: acceleration(p2), w2: velocity(theta), e2: acceleration(theta),
        p3, v3: velocity(p3), a3: acceleration(p3), c1, c2, tip, x, margin: margin(),
    }
    pub fn energy(phi, omega) -> SliderCrankEnergy {
        k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
    }
}

slider_crank! { HungSlider, HungSliderForces,
    {
        body slider = pin b3 on rod at p3, turns 0deg, mass m3 at tip;
        slide b4 = slider on frame at p3 along dir(lean);
    }
}

/// Bodies and joints of a slider-crank at an instant, with the slider, its pin and its way. Crank, rod
/// and slider have masses.
macro_rules! bodies {
    ($m:ident, $at:ident, $rate:ident, $press:ident) => {{
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [p2, p3, c1, c2, tip] = [$at.p2, $at.p3, $at.c1, $at.c2, $at.tip].map(flat);
        let crank = $rate.pivot(Vector2::zeros(), [1.0, 0.0]);
        let crank = Some(all.body(crank.add_mass($m.m1, c1)));
        let rod = $rate.plane([$at.p2, $at.v2, $at.a2], [$at.w2, $at.e2]);
        all.body(rod.add_mass($m.m2, c2).add_inertia(disc($m.i2)));
        let slider = $rate.plane([$at.p3, $at.v3, $at.a3], [0.0, 0.0]);
        let slider = Some(all.body(slider.add_mass($m.m3, tip)));
        let way = Vector::new($m.lean.cos(), $m.lean.sin(), 0.0);
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 1, crank, p2);
        all.joint(pin(), 1, slider, p3);
        all.joint(Kind::Slide(way), 2, None, p3);
        all.force([slider, None], tip, Vector::new(-$press, $press / 4.0, 0.0));
        (all, slider, p3, way)
    }};
}
pub(crate) use bodies;

/// The joints are b1 to b4.
fn instant(m: &SliderCrank, at: &SliderCrankMotion, rate: Rate, press: f64) -> Instant {
    let (mut all, slider, p3, way) = bodies!(m, at, rate, press);
    all.pair([slider, None], p3, way * (-m.rate * (at.x - 100.0)));
    all.slide_damper([slider, None], (p3, way), m.drag);
    all
}

#[test]
fn reactions_and_powers() {
    each(0x61, |m: SliderCrank, random| {
        let hung: HungSlider = linkage::Dimensions::from_values(&linkage::Dimensions::values(&m));
        let (Ok(linkage), Ok(hung)) = (m.assemble(), hung.assemble()) else {
            return false;
        };
        let (phi, rate, press) = (random.turn(), Rate::any(random), random.load(50.0));
        let all = instant(&m, &linkage.motion(phi), rate, press);
        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, press);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);

        // The pin's force acts on the slider there.
        let other = hung.forces(phi, rate.omega, rate.epsilon, press);
        solution.expect_forces([other.f1, other.f2, -other.f3, other.f4]);
        solution.expect_moment(3, other.m4);
        solution.expect_torque(solution.drive(0), other.t);
        solution.expect_power(solution.power(&all), other.p, rate.omega);

        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}

// Dyad RPR: a block on the crank's pin slides on a swinging arm, with an offset. Once the slide closes the loop, once the block hangs on the arm.

macro_rules! quick_return {
    ($name:ident, $forces:ident, { $($bodies:tt)* } $($functions:tt)*) => {
        linkage_interpreted::interpreted! {
            pub struct $name {
                unit mm;
                param a = 40mm;
                param e = 7mm;
                param reach = 180mm;
                param base = (10mm, -90mm);
                param m1 = 130g;
                param m2 = 90g;
                param m3 = 0.5kg;
                param i2 = 2000g*mm^2;
                param i3 = 800000g*mm^2;
                param rate = 0.5N/mm;
                param drag = 0.02N*s/mm;
                param grip = 3N*mm*s;
                argument cut = 50N;
                input phi = 40deg in 0deg..360deg at omega, epsilon;
                unknown theta = 75deg;
                unknown x = 110mm;
                let p2 = polar(a, phi);
                loop p2 = base + rotate((x, e), theta);
                let end = base + polar(reach, theta);
                let c1 = polar(a / 4, phi + 200deg);
                let c2 = p2 + rotate((8mm, 11mm), theta);
                let c3 = base + rotate((80mm, -6mm), theta);

                gravity = (0.3m/s^2, -9.80665m/s^2);
                body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at c1;
                body arm = pin b4 on frame at base, turns theta, mass m3 at c3, inertia i3;
                $($bodies)*
                force (-cut, cut / 4) on arm at end;
                spring rate on b3, free 100mm;
                damper drag on b3;
                damper grip on b2;
            }
            impl $name {
                pub fn forces(phi, omega, epsilon, cut) -> $forces {
                    f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), m3: moment(b3), t: torque(phi), p: power(),
                }
                $($functions)*
            }
        }
    };
}

quick_return! { QuickReturn, QuickReturnForces,
    {
        body block = pin b2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
        slide b3 = block on arm at p2 along dir(theta);
    }
    pub fn motion(phi) -> QuickReturnMotion {
        p2, v2: velocity(p2), a2: acceleration(p2), w: velocity(theta), e: acceleration(theta), theta, x, c1, c2, c3, end,
        margin: margin(),
    }
    pub fn energy(phi, omega) -> QuickReturnEnergy {
        k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
    }
}

quick_return! { HungBlock, HungBlockForces,
    {
        body block = slide b3 on arm at p2 along (2 * cos(theta), 2 * sin(theta)), mass m2 at c2, inertia i2;
        pin b2 = crank on block at p2;
    }
}

fn instant_of_the_arm(m: &QuickReturn, at: &QuickReturnMotion, rate: Rate, cut: f64) -> Instant {
    let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(300.0, -9806.65, 0.0));
    let [p2, base, c1, c2, c3, end] = [at.p2, m.base, at.c1, at.c2, at.c3, at.end].map(flat);
    let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]);
    let crank = Some(all.body(crank.add_mass(m.m1, c1)));
    let arm = rate.pivot(m.base, [at.w, at.e]);
    let arm = Some(all.body(arm.add_mass(m.m3, c3).add_inertia(disc(m.i3))));
    let block = rate.plane([at.p2, at.v2, at.a2], [at.w, at.e]);
    let block = Some(all.body(block.add_mass(m.m2, c2).add_inertia(disc(m.i2))));
    let way = Vector::new(at.theta.cos(), at.theta.sin(), 0.0);
    all.driven(pin(), 0, None, Vector::zeros());
    all.joint(pin(), 2, crank, p2);
    all.joint(Kind::Slide(way), 2, arm, p2);
    all.joint(pin(), 1, None, base);
    all.force([arm, None], end, Vector::new(-cut, cut / 4.0, 0.0));
    all.pair([block, arm], p2, way * (-m.rate * (at.x - 100.0)));
    all.slide_damper([block, arm], (p2, way), m.drag);
    all.turn_damper([block, crank], Vector::z(), m.grip);
    all
}

#[test]
fn reactions_and_powers_of_a_swinging_arm() {
    each(0x71, |m: QuickReturn, random| {
        let hung: HungBlock = linkage::Dimensions::from_values(&linkage::Dimensions::values(&m));
        let (Ok(linkage), Ok(hung)) = (m.assemble(), hung.assemble()) else {
            return false;
        };
        let (phi, rate, cut) = (random.turn(), Rate::any(random), random.load(50.0));
        let all = instant_of_the_arm(&m, &linkage.motion(phi), rate, cut);
        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, cut);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(2, found.m3);
        solution.expect_torque(solution.drive(0), found.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);

        let other = hung.forces(phi, rate.omega, rate.epsilon, cut);
        solution.expect_forces([other.f1, -other.f2, other.f3, other.f4]);
        solution.expect_moment(2, other.m3);
        solution.expect_torque(solution.drive(0), other.t);

        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}
