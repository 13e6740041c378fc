//! The check of ranges in JavaScript is that of the command: of all exported mechanisms at other dimensions, and of four-bars at change points.

use linkage_browser::Page;
use linkage_corpus::given::{FOUR_BAR, Given, exported};
use linkage_engine::{Assembly, Mechanism};
use linkage_random::{Random, one_in};
use linkage_runtime::RangeFindingKind;

use crate::{load, object};

/// How far places are apart at most, relative to the range: a place where a slack touches zero is known to half of its digits.
const APART: f64 = 1e-6;

/// Compares the reports of an assembly with these dimensions; how many findings there are. Nothing if it does not close.
fn compare(mechanism: &Mechanism, dimensions: &[f64], page: &mut Page) -> Option<usize> {
    let given = object(mechanism, dimensions);
    let text = page.words(&format!(
        "(() => {{ try {{ window.own = mechanism.assemble({given}); }} catch {{ return 'open'; }} \
         const {{ findings, unchecked }} = mechanism.checkRange(own); \
         return [unchecked === null, ...findings.map((f) => [f.kind, f.group, f.from, f.to, f.miss].join(' '))].join(';'); }})()"
    ));
    let assembly: Assembly = mechanism.assemble(dimensions).ok()?;
    let report = assembly.check_range();
    let name = mechanism.name();
    let mut parts = text.split(';');
    let checked = parts.next().expect("a word") == "true";
    assert_eq!(checked, report.unchecked.is_none(), "{name}: {text}");
    let found: Vec<Vec<&str>> = parts.map(|own| own.rsplitn(5, ' ').collect()).collect();
    assert_eq!(
        found.len(),
        report.findings.len(),
        "{name} {dimensions:?}: {text}, not {report:?}"
    );
    let [low, high] = report.range;
    for (own, expected) in found.iter().zip(&report.findings) {
        let kind = match expected.kind {
            RangeFindingKind::ChangePoint => "change point",
            RangeFindingKind::DeadPoint => "dead point",
            RangeFindingKind::Gap => "gap",
            RangeFindingKind::Undefined => "undefined",
        };
        let number = |k: usize| own[k].parse::<f64>().expect("a number");
        let near = |a: f64, b: f64| (a - b).abs() <= APART * (high - low);
        let same = own[4] == kind && number(3) == expected.group as f64;
        let close = near(number(2), expected.from) && near(number(1), expected.to);
        let miss = (number(0) - expected.miss).abs() <= 1e-6 * expected.miss + 1e-9;
        assert!(
            same && close && miss,
            "{name} {dimensions:?}: {own:?}, not {expected:?}"
        );
    }
    Some(found.len())
}

#[test]
fn exported_mechanisms_have_the_findings_of_the_command() {
    let Some(mut page) = Page::empty() else {
        return;
    };
    let mut random = Random::new(3);
    let (mut closed, mut count) = (0, 0);
    for given in one_in(3, exported()) {
        let mechanism = load("ranges", given, &mut page);
        for part in [0.0, 0.3, 0.4] {
            let own = mechanism.dimensions().into_iter();
            let dimensions: Vec<f64> = own
                .map(|x| x * (1.0 + random.between(-part, part)))
                .collect();
            // Coupled groups are followed in JavaScript and listed by the command: other dimensions may have another assembly.
            if part > 0.0 && !mechanism.compiled().coupled.is_empty() {
                continue;
            }
            if let Some(found) = compare(&mechanism, &dimensions, &mut page) {
                assert!(part > 0.0 || found == 0, "{}", mechanism.name());
                (closed, count) = (closed + 1, count + found);
            }
        }
    }
    println!("{closed} assemblies, {count} findings");
    assert!(closed > 20 && count > 0, "{closed} {count}");
}

#[test]
fn four_bars_at_change_points_have_the_findings_of_the_command() {
    let Some(mut page) = Page::empty() else {
        return;
    };
    let mechanism = load("ranges", Given::text(FOUR_BAR), &mut page);
    let mut random = Random::new(5);
    let mut counts = [0; 3];
    for round in 0..90 {
        let [a, b, c] = [0; 3].map(|_| random.between(20.0, 200.0));
        let mut lengths = match random.below(4) {
            0 => [a, b, a, b],
            1 => [a, b, b, a],
            2 => [a, b, c, b + c - a],
            _ => [a, b, c, a + b - c],
        };
        if round % 3 == 1 {
            lengths[1] *= 1.0 + random.pick(&[1e-6, -1e-6]);
        }
        if lengths[3] > 10.0
            && let Some(found) = compare(&mechanism, &lengths, &mut page)
        {
            counts[found.min(2)] += 1;
        }
    }
    assert!(counts.iter().all(|own| *own > 2), "{counts:?}");
    // At a change point rates are no numbers, and not infinite.
    let text = page.words(
        "(() => { const at = mechanism.assemble({ coupler: 140, rocker: 50 }).motion(Math.PI); \
         return [Number.isFinite(at.psi), Number.isNaN(at.v)].join(' '); })()",
    );
    assert_eq!(text, "true true");
}
