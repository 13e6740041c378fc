//! Every function of the small examples, one position at a time, and their sweeps: those of the others are in `larger_examples`.
//!
//! The workspace builds this package with optimisation in every profile.

#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

use linkage::mechanism;

mechanisms! {
    crank_rocker,
    drag_link,
    geared_five_bar,
    gears,
    hydraulic_cylinder,
    quick_return,
    stability,
    trammel,
    two_crank_triad,
}

check!(crank_rocker_: crank_rocker::CrankRocker, crank_rocker::CrankRockerAssembly:
    angles [angles_sweep angles_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(drag_link_: drag_link::DragLink, drag_link::DragLinkAssembly:
    angles [angles_sweep angles_sweep_sets] (phi),
    rates [rates_sweep rates_sweep_sets] (phi));
check!(stability_two_links: stability::TwoLinks, stability::TwoLinksAssembly:
    place [place_sweep place_sweep_sets] (y));
check!(stability_rod_and_guide: stability::RodAndGuide, stability::RodAndGuideAssembly:
    place [place_sweep place_sweep_sets] (y));
check!(stability_turning_guide: stability::TurningGuide, stability::TurningGuideAssembly:
    place [place_sweep place_sweep_sets] (y));
check!(geared_five_bar_: geared_five_bar::GearedFiveBar, geared_five_bar::GearedFiveBarAssembly:
    points [points_sweep points_sweep_sets] (phi, phase),
    motion [motion_sweep motion_sweep_sets] (phi, phase),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi, phase));
check!(gears_tusi_couple: gears::TusiCouple, gears::TusiCoupleAssembly:
    point [point_sweep point_sweep_sets] (motor),
    accuracy [accuracy_sweep accuracy_sweep_sets] (motor));
check!(gears_bracket: gears::Bracket, gears::BracketAssembly: apex [] ());
check!(hydraulic_cylinder_: hydraulic_cylinder::Boom, hydraulic_cylinder::BoomAssembly:
    position [position_sweep position_sweep_sets] (stroke),
    motion [motion_sweep motion_sweep_sets] (stroke),
    accuracy [accuracy_sweep accuracy_sweep_sets] (stroke));
check!(quick_return_: quick_return::QuickReturn, quick_return::QuickReturnAssembly:
    position [position_sweep position_sweep_sets] (phi),
    stroke [stroke_sweep stroke_sweep_sets] (phi));
check!(trammel_: trammel::Trammel, trammel::TrammelAssembly:
    point [point_sweep point_sweep_sets] (phi));
check!(trammel_scotch_yoke: trammel::ScotchYoke, trammel::ScotchYokeAssembly:
    yoke [yoke_sweep yoke_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(two_crank_triad_: two_crank_triad::TwoCranks, two_crank_triad::TwoCranksAssembly:
    working_point [working_point_sweep working_point_sweep_sets] (phi),
    picture [picture_sweep picture_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi));

// A machine of parts: functions of one part, of two of them, of all dimensions and of a part that another one carries, one
// position at a time, and their sweeps.

mechanism! {
    /// A crank-rocker with a needle.
    pub struct Needle {
        unit mm;
        param crank = 12mm;
        param arm = 70mm;
        input phi = 0deg in 0deg..360deg;
        unknown theta = 24deg;
        unknown psi = 81deg;
        loop polar(crank, phi) + polar(60mm, theta) = (60mm, -20mm) + polar(45mm, psi);
        body lever = pin on frame at (60mm, -20mm), turns psi;
        let pin = (60mm, -20mm) + polar(45mm, psi);
        let tip = polar(arm, psi - 80deg);
    }
    impl Needle {
        pub fn motion(phi) -> NeedleMotion { tip, v: velocity(tip), a: acceleration(tip) }
    }

    /// A slider-crank.
    pub struct Ram {
        unit mm;
        param crank = 20mm;
        param rod = 65mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 80mm;
        loop polar(crank, phi) + polar(rod, theta) = (s, 4mm);
        let end = (s, 4mm);
    }
    impl Ram {
        pub fn motion(phi) -> RamMotion { s, v: velocity(s) }
    }

    /// Two needles on one shaft, the second one ahead; a ram on the lever of the first one.
    pub struct Machine {
        unit mm;
        param lead = 30deg;
        input shaft = 0deg in 0deg..360deg;
        part hook: Needle { phi = shaft };
        part eye:  Needle { phi = shaft + lead, arm = hook.arm };
        part ram:  Ram { phi = 2 * shaft } on hook.lever at hook.pin, turned by hook.psi;
    }
    impl Machine {
        pub fn hook(shaft) -> Hook { tip: hook.tip, v: velocity(hook.tip), a: acceleration(hook.tip) }
        pub fn gap(shaft) -> Gap { gap: norm(eye.tip - hook.tip), v: velocity(norm(eye.tip - hook.tip)) }
        pub fn seen(shaft) -> Seen { seen: rotate(eye.tip - hook.tip, -hook.psi), end: ram.end, v: velocity(ram.end) }
        pub fn accuracy(shaft) -> Accuracy { e: sensitivity(eye.tip - hook.tip), s: sensitivity(velocity(ram.end)) }
        pub fn picture(shaft) -> Picture { shape: picture() }
    }
}

check!(needle: Needle, NeedleAssembly:
    motion [motion_sweep motion_sweep_sets] (phi));
check!(ram: Ram, RamAssembly:
    motion [motion_sweep motion_sweep_sets] (phi));
check!(machine: Machine, MachineAssembly:
    hook [hook_sweep hook_sweep_sets] (shaft),
    gap [gap_sweep gap_sweep_sets] (shaft),
    seen [seen_sweep seen_sweep_sets] (shaft),
    accuracy [accuracy_sweep accuracy_sweep_sets] (shaft),
    picture [picture_sweep picture_sweep_sets] (shaft));
