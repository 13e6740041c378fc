//! Limits of `linkage-core` in exported JavaScript: it has those of core, whatever they are.

use linkage_core::certificate::{
    ALLOWED_CONTRACTION, COMFORTABLE_STRAY, CORRECTION_LIMIT, CORRECTIONS, FIRST_CORRECTION,
    MOST_MIDDLE, MOST_STRAY, ROUNDINGS, SCALES, SETTLED,
};
use linkage_core::range_check::{
    AT_END, DEAD, END, LEAST_SAMPLES, MOST_SAMPLES, ROUNDING, SAMPLES,
};
use linkage_js::module;

use linkage_corpus::given::golden;

#[test]
fn the_engine_has_the_limits_of_core() {
    let given = &golden()[0];
    let script = module(&given.name, &given.unit).script;
    let [scale, smaller, larger] = SCALES;
    for line in [
        format!("const FIRST_CORRECTION = {FIRST_CORRECTION:?};"),
        format!("const CONTRACTION = {ALLOWED_CONTRACTION:?};"),
        format!("const CORRECTIONS = {CORRECTIONS};"),
        format!("const SETTLED = {SETTLED:?};"),
        format!("const SCALES = [{scale}, {smaller}, {larger}];"),
        format!("const CORRECTION_LIMIT = {CORRECTION_LIMIT:?};"),
        format!("const EIGHT_ROUNDOFFS = {ROUNDINGS} * Number.EPSILON;"),
        format!("const COMFORT = {COMFORTABLE_STRAY:?} * Math.PI;"),
        format!("const MOST_STRAY = {MOST_STRAY:?} * Math.PI;"),
        format!("const MOST_MIDDLE = {MOST_MIDDLE:?} * Math.PI;"),
        format!("const DEAD = {DEAD:?};"),
        format!("const END = {END:?};"),
        format!("const AT_RANGE_END = {AT_END:?};"),
        format!("const SLACK_ROUNDING = {ROUNDING:?};"),
        format!("const SAMPLES_OF_A_TURN = {SAMPLES};"),
        format!(" / TURN, {LEAST_SAMPLES}), {MOST_SAMPLES}) :"),
    ] {
        assert!(script.contains(&line), "`{line}` is not in the module");
    }
    assert!(!script.contains("CORE."), "a constant is not written");
}
