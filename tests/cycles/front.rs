//! Compromises of two goals.

use super::{design, figure, margin, speed, tip};
use linkage::design::{DesignError, Dwell, Figure, Lowest, Peak, Stroke};

/// A large stroke costs speed: each compromise is the best mechanism for its stroke, and the ends are those of each goal alone.
#[test]
fn compromises_are_optima_of_their_limits() -> Result<(), DesignError> {
    let problem = || design().want(Lowest(margin()).at_least(0.4));
    let front = problem().front(Peak(speed()).least(), Stroke(tip()).greatest(), 6)?;
    assert_eq!(front.len(), 6);
    let alone = problem().want(Peak(speed()).least()).run()?;
    assert_eq!(front[0].best.goal, alone.goal);
    let most = problem().want(Stroke(tip()).greatest()).run()?.goal;
    assert!((front[5].other / most - 1.0).abs() < 1e-3 && front[5].other <= most);
    let step = (most - front[0].other) / 5.0;
    for (k, pair) in front.windows(2).enumerate() {
        let [one, next] = pair else { unreachable!() };
        assert!(one.best.goal < next.best.goal && one.other < next.other);
        let rest = next.other - one.other - step;
        assert!(k == 4 || rest.abs() < 1e-6 * step, "{k}: {rest}");
        let (peak, stroke) = (
            figure(&Peak(speed()), &next.best.mechanism).0,
            figure(&Stroke(tip()), &next.best.mechanism).0,
        );
        assert!(
            (peak - next.best.goal).abs() < 1e-9 * peak
                && (stroke - next.other).abs() < 1e-9 * stroke
        );
        let limited = problem()
            .want(Peak(speed()).least())
            .want(Stroke(tip()).at_least(next.other * (1.0 - 1e-9)))
            .run()?;
        assert!(
            next.best.goal <= limited.goal * (1.0 + 1e-5),
            "{k}: {} {}",
            next.best.goal,
            limited.goal
        );
    }
    Ok(())
}

/// A wish with variables of its own may be the first goal. Where both agree, one mechanism is all of the front.
#[test]
fn a_front_of_one() -> Result<(), DesignError> {
    let front = design().front(Dwell::longest(tip(), 1.0), Stroke(tip()).greatest(), 4)?;
    assert!(front.len() > 1 && front[0].best.goal > front[front.len() - 1].best.goal);
    let same = design().front(Stroke(tip()).least(), Stroke(tip()).least(), 3)?;
    assert_eq!(same.len(), 1);

    let none = design().front(Stroke(tip()).least(), Peak(speed()).least(), 1);
    let text = none.expect_err("one is no front").to_string();
    assert_eq!(text, "a front: less than two compromises");
    let two =
        design()
            .want(Peak(speed()).least())
            .front(Stroke(tip()).least(), Peak(speed()).least(), 2);
    let text = two.expect_err("a goal more").to_string();
    assert!(
        text.starts_with("2 goals: least peak, least stroke;"),
        "{text}"
    );
    Ok(())
}
