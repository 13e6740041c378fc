//! Every function of the small examples, one position at a time, and their sweeps: those of the others are in `larger_examples`.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

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
