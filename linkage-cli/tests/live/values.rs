//! What pages show for other dimensions.

use linkage_random::Random;

use crate::pages::{self, Live};

/// How often dimensions are changed at random, for each mechanism; `LIVE_COUNT=2000` in the environment changes them more often.
const COUNT: usize = 6;

fn changes() -> usize {
    let wanted = std::env::var("LIVE_COUNT").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT)
}

#[test]
fn pages_show_what_the_command_computes() {
    let examples = [
        "favorit.rs",
        "eye_needle.rs",
        "spatial_crank_rocker.rs",
        "quick_return.rs",
        "geared_five_bar.rs",
    ];
    let mut random = Random::new(20);
    for example in examples {
        let Some(mut live) = Live::example(example) else {
            return;
        };
        let (mut reached, mut gaps) = (0, 0);
        for _ in 0..changes() {
            let part = *random.pick(&[0.002, 0.02, 0.1]);
            let own = live.mechanism.dimensions().into_iter();
            let dimensions: Vec<f64> = own
                .map(|x| x * (1.0 + random.between(-part, part)))
                .collect();
            live.set(&dimensions);
            match live.mechanism.assemble(&dimensions) {
                Ok(assembly) => {
                    let said = live.says();
                    assert!(!said.contains("no farther"), "{example}: {said}");
                    gaps += pages::compare(&mut live, &assembly, &[]);
                    reached += 1;
                }
                Err(error) => {
                    // What closes at the reference and ends within the range has rows up to there.
                    let said = live.says();
                    let ends = live.page.holds("!document.getElementById('gaps').hidden");
                    assert!(
                        said.starts_with("That far and no farther.") || ends,
                        "{example}: {said}, {error}"
                    );
                }
            }
        }
        println!(
            "{example}: {reached} of {} changes close, {gaps} positions without values",
            changes()
        );
        assert!(reached > changes() / 2);
        live.page.assert_quiet();
    }
}

/// Many changes of the first dimension by its field, with a rest now and then in which they are drawn: of the times of computing, of showing and of
/// both that which a tenth of them do not exceed. The others may have waited for what else runs on the machine.
const TIMES: &str = "(async () => {
    document.getElementById('play').click();
    const field = document.querySelector('input[data-dimension]');
    const before = Number(field.value);
    const all = [];
    for (let step = 1; step <= 200; step += 1) {
        field.value = before + (Math.abs(before) || 1) * 1e-5 * step;
        field.dispatchEvent(new Event('change'));
        const { computed, shown } = document.body.dataset;
        all.push([Number(computed), Number(shown), Number(computed) + Number(shown)]);
        if (step % 4 === 0) await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    }
    return [0, 1, 2].map((k) => all.map((own) => own[k]).sort((a, b) => a - b)[20]).join(' ');
})()";

#[test]
fn changes_are_shown_at_once() {
    // The limits are those of a quiet machine; here others may be at work, too.
    const PATIENCE: f64 = 3.0;
    for (mechanism, limit) in [("crank_rocker", 4.0), ("favorit", 16.0)] {
        let found = match mechanism {
            "favorit" => Live::example("favorit.rs"),
            _ => Live::golden("crank_rocker.mech"),
        };
        let Some(mut live) = found else {
            return;
        };
        let times = live.page.words(TIMES);
        let times: Vec<f64> = times
            .split(' ')
            .map(|word| word.parse().expect("milliseconds"))
            .collect();
        let [computed, shown, both] = times[..] else {
            panic!("{times:?}")
        };
        println!("{mechanism}: {computed:.2} ms computing, {shown:.2} ms showing");
        assert!(both < PATIENCE * limit, "{mechanism}: {both} ms");
    }
}

/// What lies out of reach stops at the last dimensions that close.
#[test]
fn what_cannot_be_assembled_is_as_near_as_possible() {
    let Some(mut live) = Live::golden("crank_rocker.mech") else {
        return;
    };
    live.page.value("location.hash = 'rocker=10'");
    live.page
        .wait("document.getElementById('says').textContent !== ''");
    let said = live.says();
    assert!(said.starts_with("That far and no farther. CrankRocker: the RRR group of theta, psi (loop 1) cannot be closed: "), "{said}");
    // There the triangle is flat.
    let mut dimensions = live.mechanism.dimensions();
    let place = live
        .mechanism
        .parameters()
        .iter()
        .position(|own| own.name == "rocker")
        .expect("it has one");
    let shown = live
        .page
        .number("Number(document.querySelector('input[data-dimension=rocker]').value)");
    dimensions[place] = shown;
    assert!(live.mechanism.assemble(&dimensions).is_ok());
    dimensions[place] = shown - 1e-4;
    assert!(live.mechanism.assemble(&dimensions).is_err(), "{shown}");
    live.page.assert_quiet();
}

/// Another input has its own slider.
const PAUSE: &str = "new Promise((done) => setTimeout(() => done(true), 300))";

#[test]
fn a_second_input_runs_by_itself() {
    let Some(mut live) = Live::golden_as("shaper.mech", "runs") else {
        return;
    };
    let unit = &live.mechanism.compiled();
    let second = &unit.inputs[1];
    let name = second.name.as_str();
    let (low, high) = second.range.expect("a range");
    let step = (high - low) * 1e-3;
    let value = format!("Number(document.querySelector('[data-slides={name}]').value)");
    let button = format!("document.querySelector('[data-runs={name}]')");
    let first = format!(
        "document.querySelectorAll('[data-runs={}]')",
        unit.inputs[0].name
    );
    assert_eq!(live.page.number(&format!("{first}.length")), 0.0);
    // The first input stands still, and the drawing moves.
    let picture = "document.querySelector('#drawing .bodies').innerHTML";
    live.page.value("document.getElementById('play').dataset.playing === undefined || document.getElementById('play').click()");
    let before = live.page.words(picture);
    live.page.value(&format!("{button}.click()"));
    live.page.wait(&format!(
        "{button}.getAttribute('aria-label') === 'Pause {name}'"
    ));
    live.page.wait(&format!(
        "{picture} !== {}",
        serde_json::Value::from(before)
    ));
    live.page.value(PAUSE);
    live.page.value(&format!("{button}.click()"));
    let stopped = live.page.number(&value);
    assert!(stopped >= low && stopped <= high, "{stopped}");
    assert!((stopped - second.reference).abs() > step, "{stopped}");
    live.page.value(PAUSE);
    assert_eq!(live.page.number(&value), stopped);
    // A run is one step of the history.
    live.page.value("document.getElementById('undo').click()");
    assert_eq!(live.page.number(&value), second.reference);
    live.page.assert_quiet();
}

#[test]
fn other_inputs_are_changed_too() {
    let Some(mut live) = Live::golden("shaper.mech") else {
        return;
    };
    let unit = &live.mechanism.compiled();
    let second = &unit.inputs[1];
    let moved = second.reference + 0.01 * unit.longest;
    let name = second.name.as_str();
    live.page.value(&format!(
        "(() => {{ const slider = document.querySelector('input[data-slides={name}]'); slider.value = {moved:?}; for (const kind of ['input', 'change']) \
         slider.dispatchEvent(new Event(kind)); }})()"
    ));
    live.page
        .wait(&format!("location.hash.startsWith('#{name}=')"));
    let shown: f64 = live
        .page
        .words("location.hash.split('=')[1]")
        .parse()
        .expect("a number");
    assert!(
        (shown - moved).abs() < 1e-3 * unit.longest,
        "{shown}, {moved}"
    );
    let assembly = live
        .mechanism
        .assemble(&live.mechanism.dimensions())
        .expect("it closes");
    let gaps = pages::compare(&mut live, &assembly, &[(name, shown)]);
    println!("{gaps} positions without values");
    live.page.assert_quiet();
}
