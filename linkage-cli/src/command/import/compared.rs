//! An import compared with its file: the assembled mechanism has its joints where the file draws
//! them, and moves its inputs as they are set.

use linkage_engine::{Assembly, Mechanism};
use linkage_import::{Drawn, Drive, Import, Measure};

/// Values of an input, besides the drawn one, at which the driven coordinate is compared.
const VALUES: usize = 8;

/// Larger drawings take minutes to be compiled, and the user of an import waits for seconds.
const MOST_POINTS: usize = 400;

/// Distances below this part of the size are the rounding of the computation.
const ROUNDING: f64 = 1e-10;

/// The results of a comparison, one sentence each.
pub(super) struct Comparison {
    /// How well the drawn pose is met, if it is met.
    pub(super) note: Option<String>,
    /// Points and inputs that are elsewhere.
    pub(super) warnings: Vec<String>,
}

/// Compiles an imported text, assembles it, and compares it with the drawing.
pub(super) fn compared(imported: &Import) -> Comparison {
    let drawn = &imported.drawn;
    let count = drawn.points.len();
    if count > MOST_POINTS {
        return Comparison {
            note: Some(format!(
                "not compared with the drawing, because it has more than {MOST_POINTS} points: {count}"
            )),
            warnings: Vec::new(),
        };
    }
    let mechanism = match Mechanism::compile(&imported.text) {
        Ok(mechanism) => mechanism,
        Err(error) => return not_compared(&error.to_string()),
    };
    let assembly = match mechanism.assemble(&mechanism.dimensions()) {
        Ok(assembly) => assembly,
        Err(error) => return not_compared(&error.to_string()),
    };
    let reference = mechanism.reference();
    let pose = points(&assembly, drawn, &reference);
    let (note, mut warnings) = match drawn.farthest(&pose) {
        Some((point, distance)) if distance > drawn.tolerance() => {
            let unit = drawn.unit;
            let band = match drawn.band == 0.0 {
                true => "the file has all digits".to_owned(),
                false => format!(
                    "the rounding of the file is {}{unit}",
                    few_digits(drawn.band)
                ),
            };
            let warning = format!(
                "the point `{}` is assembled {}{unit} from where the file draws it, and {band}",
                point.name,
                few_digits(distance)
            );
            (None, vec![warning])
        }
        Some((_, distance)) if distance <= ROUNDING * drawn.size() => {
            let note = "assembled as drawn: all points are where the file has them";
            (Some(note.to_owned()), Vec::new())
        }
        Some((point, distance)) => {
            let note = format!(
                "assembled as drawn: `{}` has the largest distance from its drawing, {}{}",
                point.name,
                few_digits(distance),
                drawn.unit
            );
            (Some(note), Vec::new())
        }
        None => (None, Vec::new()),
    };
    for drive in &drawn.drives {
        warnings.extend(drive_missed(&mechanism, &assembly, drawn, drive));
    }
    Comparison { note, warnings }
}

/// A distance with two digits.
fn few_digits(distance: f64) -> String {
    match distance {
        0.0 => "0".to_owned(),
        0.01..1000.0 => format!("{distance:.3}"),
        _ => format!("{distance:.1e}"),
    }
}

/// The text must be edited first.
fn not_compared(error: &str) -> Comparison {
    let first = error.lines().next().unwrap_or_default();
    let first = first.trim_start_matches("error: ");
    Comparison {
        note: None,
        warnings: vec![format!(
            "the text cannot be assembled before it is edited, see `linkage check`: {first}"
        )],
    }
}

/// All points of the drawing at some inputs.
fn points(assembly: &Assembly, drawn: &Drawn, inputs: &[f64]) -> Vec<[f64; 3]> {
    if drawn.points.iter().all(|point| point.is_fixed) {
        return drawn.points.iter().map(|point| point.position).collect();
    }
    let results = assembly.results(drawn.function, inputs);
    let points = drawn.points.iter().map(|point| match point.is_fixed {
        true => point.position,
        false => {
            let mut position = [0.0; 3];
            let numbers = results.field(&point.name).iter();
            position
                .iter_mut()
                .zip(numbers)
                .for_each(|(coordinate, number)| *coordinate = *number);
            position
        }
    });
    points.collect()
}

/// A warning if a driven coordinate does not follow its input from the drawing over the range.
fn drive_missed(
    mechanism: &Mechanism,
    assembly: &Assembly,
    drawn: &Drawn,
    drive: &Drive,
) -> Option<String> {
    let mut inputs = mechanism.inputs().iter();
    let index = inputs.position(|input| input.name == drive.input)?;
    let reference = mechanism.reference();
    let (low, high) = mechanism.inputs()[index].ends();
    let parts = (0..=VALUES).map(|number| number as f64 / VALUES as f64);
    let values = parts.map(|part| low + part * (high - low));
    let misses = values.map(|value| {
        let mut inputs = reference.clone();
        inputs[index] = value;
        let found = points(assembly, drawn, &inputs);
        let change = value - reference[index];
        let missed = drawn.missed(drive, change, &found);
        let got = drawn.change(&drive.measure, &found);
        (drive.rate * change, got, missed)
    });
    // A position that is no number is missed.
    let is_worse = |missed: f64| missed.is_nan() || missed > drawn.allowed(&drive.measure);
    let (asked, got, _) = misses.into_iter().find(|(.., missed)| is_worse(*missed))?;
    let shown = |change: f64| match drive.measure {
        Measure::Turn { .. } => format!("{:.6}deg", change.to_degrees()),
        Measure::Distance(_) | Measure::Shift { .. } => format!("{change:.6}{}", drawn.unit),
    };
    Some(format!(
        "the input `{}` asks for a change of {} from the drawing, and the assembled mechanism makes {}",
        drive.input,
        shown(asked),
        shown(got)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkage_import::{Options, import};

    const TABLE: &str = "name,kind,x (mm),y (mm),links\n\
                         o,motor,0.00,0.00,frame crank\n\
                         a,pin,0.00,40.00,crank rod\n\
                         b,pin,100.00,60.00,rod lever\n\
                         c,pin,110.00,0.00,frame lever\n";

    /// Compares a table whose text has another clause for the crank.
    fn edited(clause: &str) -> Comparison {
        let mut imported =
            import(TABLE.as_bytes(), "a.csv", &Options::default()).expect("a mechanism");
        let text = imported.text.replace(" at phi;", clause);
        assert_ne!(text, imported.text);
        imported.text = text;
        compared(&imported)
    }

    #[test]
    fn a_text_as_imported_is_assembled_as_drawn() {
        let imported = import(TABLE.as_bytes(), "a.csv", &Options::default()).expect("a mechanism");
        let Comparison { note, warnings } = compared(&imported);
        assert_eq!(warnings, [""; 0]);
        let note = note.expect("a note");
        assert_eq!(
            note,
            "assembled as drawn: all points are where the file has them"
        );
    }

    #[test]
    fn another_pose_names_the_joint_and_the_input() {
        let Comparison { note, warnings } = edited(" at phi + 0.9deg;");
        assert_eq!(note, None);
        let [point, input] = &warnings[..] else {
            panic!("{warnings:?}");
        };
        assert!(point.contains("` is assembled 0.6"), "{point}");
        assert!(
            point.ends_with("the rounding of the file is 5.0e-3mm"),
            "{point}"
        );
        assert!(
            input.starts_with("the input `phi` asks for a change of "),
            "{input}"
        );
    }

    #[test]
    fn an_input_that_is_not_followed_is_a_warning() {
        let Comparison { note, warnings } = edited(" at 90deg + 2 * (phi - 90deg);");
        assert!(note.is_some(), "{warnings:?}");
        let expected = "the input `phi` asks for a change of -90.000000deg from the drawing, and \
                        the assembled mechanism makes -180.000000deg";
        assert_eq!(warnings, [expected]);
    }

    #[test]
    fn a_text_that_must_be_edited_is_a_warning() {
        let Comparison { note, warnings } = edited(";");
        assert_eq!((note, warnings.len()), (None, 1));
        assert!(warnings[0].starts_with("the text cannot be assembled before it is edited"));
    }

    #[test]
    fn large_drawings_are_not_compiled() {
        let mut imported =
            import(TABLE.as_bytes(), "a.csv", &Options::default()).expect("a mechanism");
        let point = imported.drawn.points[0].clone();
        imported.drawn.points.resize(MOST_POINTS + 1, point);
        let Comparison { note, warnings } = compared(&imported);
        assert_eq!(warnings, [""; 0]);
        assert!(note.expect("a note").ends_with("more than 400 points: 401"));
    }
}
