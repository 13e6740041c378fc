//! `linkage urdf`, `linkage mjcf`: a mechanism as a robot description.
//!
//! A description consists of the bodies and joints that the mechanism declares. It needs the text
//! of these declarations and the engine, so it is a part of the command and no crate of printers.

mod bars;
mod closures;
mod coordinates;
mod coupling;
mod declared;
mod declared_wheels;
mod driven_joints;
mod expression_text;
mod heading;
mod inertial;
mod joint_polynomials;
mod joint_relations;
mod jointed_links;
mod mass;
mod metres;
mod minimax;
mod mjcf;
mod options;
mod remarks;
mod results;
mod skeleton;
mod slot_bodies;
mod space_vectors;
mod urdf;
mod wheel_relations;
mod xml;

use clap::Args;
use linkage_engine::{Mechanism, Source};
use linkage_page::{selections, with_further_functions};
use linkage_runtime::Input;

use super::output::put;
use super::range;
use super::sweep::{all_arguments, running, still};
use crate::failure::Failure;
use crate::normal::normal;
use coupling::couplings;
use declared::Declared;
use driven_joints::{Motion, RunningName};
use heading::{Driver, Heading, TURN};
use inertial::inertials;
use joint_polynomials::{exact_tree, with_polynomials};
use mjcf::Equations;
use options::{Common, allowed};
use remarks::{Format, closed, missed, remarks};
use skeleton::{CONSTANTS, ChosenInput, POSITIONS, Skeleton};
use slot_bodies::put_slots_second;
use wheel_relations::relations;

/// Options of `linkage urdf`.
#[derive(Debug, Args)]
pub(super) struct UrdfOptions {
    #[command(flatten)]
    common: Common,
    /// The largest error of a joint, an angle or a length; may be given once for each
    #[arg(long, value_name = "VALUE", value_parser = normal)]
    error: Vec<String>,
}

/// Options of `linkage mjcf`.
#[derive(Debug, Args)]
pub(super) struct MjcfOptions {
    #[command(flatten)]
    common: Common,
    /// Couples the joints by polynomials with this largest error, an angle or a length, instead of
    /// loops that are constraints; may be given once for each
    #[arg(long, value_name = "VALUE", value_parser = normal)]
    error: Vec<String>,
}

/// Writes URDF.
pub(super) fn write_urdf(options: &UrdfOptions) -> Result<(), Failure> {
    write(&options.common, Format::Urdf, &options.error)
}

/// Writes MJCF.
pub(super) fn write_mjcf(options: &MjcfOptions) -> Result<(), Failure> {
    write(&options.common, Format::Mjcf, &options.error)
}

fn write(options: &Common, format: Format, errors: &[String]) -> Result<(), Failure> {
    let source = Source::read(options.chosen.file())?;
    let name = options.only(&source)?;
    let declared = Declared::read(&source, name)?;
    let mechanism = with_functions(&source, name, &declared)?;
    let assembly = range::assembled(&options.dimensions, &mechanism)?;
    let function = mechanism.function(POSITIONS);
    let function = function.map_err(|error| Failure::Told(error.to_string()))?;
    let Some((running, input)) = running(&mechanism, function, options.over.as_deref())? else {
        return Err(Failure::Told(format!(
            "{name} has no input, so nothing drives it"
        )));
    };
    still(input, &options.at)?;
    let arguments = all_arguments(&mechanism, function, &options.at)?;
    let course = ChosenInput { arguments, running };
    let mut skeleton = Skeleton::new(&declared, &mechanism, &assembly, course)?;
    put_slots_second(&mut skeleton);
    let named = RunningName {
        name: input.name,
        unit: input.unit,
    };
    let ends = options.range(&mechanism, input, skeleton.reference())?;
    let motion = Motion::over(&skeleton, ends, named, options.drive.as_deref())?;
    let inertials = inertials(&skeleton);
    let mut remarks = remarks(&declared, &skeleton, &motion, ends, named);
    remarks.extend(inertials.completed(&skeleton));
    remarks.extend(inertials.remarks.iter().cloned());
    for remark in &inertials.remarks {
        eprintln!("note: {name}: {remark}");
    }
    let free = match format == Format::Urdf && errors.is_empty() && options.moves_all_inputs() {
        true => exact_tree(&mechanism, &skeleton, &motion, format.degree()),
        false => None,
    };
    let is_coupled = format == Format::Urdf || !errors.is_empty();
    let equations = match (free, is_coupled) {
        (Some(relations), _) => {
            remarks.push("each input moves a joint; the others follow them exactly".to_owned());
            Equations::Loops(relations)
        }
        (None, true) => {
            let allowed = allowed(&mechanism, errors, &skeleton)?;
            let found = couplings(&motion, format.degree(), allowed, skeleton.size());
            let found = found.map_err(|all| missed(&all, &motion, named, format))?;
            remarks.push(format!(
                "the joints follow `{}` by polynomials, whose errors hold for {} from {} to {}",
                motion.coordinates[motion.driver].name,
                named.name,
                named.written(ends[0]),
                named.written(ends[1])
            ));
            Equations::Polynomials(found)
        }
        (None, false) => {
            let wheels = relations(&declared, &mechanism, &assembly, &skeleton, &motion);
            let found = with_polynomials(wheels, &mechanism, &skeleton, &motion, format.degree());
            closed(&mechanism, &skeleton, &found, &motion)?;
            remarks.push(
                "loops are constraints between sites, which meet in this position; MuJoCo's constraints are soft"
                    .to_owned(),
            );
            Equations::Loops(found)
        }
    };
    let zero = match format {
        Format::Urdf => 0.0,
        Format::Mjcf => shift(&motion, input, skeleton.reference()),
    };
    let heading = model_heading(name, zero, &motion, ends, remarks, input);
    let coordinates = &motion.coordinates;
    let text = match format {
        Format::Urdf => urdf::text(&skeleton, &heading, &inertials, coordinates, &equations),
        Format::Mjcf => mjcf::text(&skeleton, &heading, &inertials, &equations, coordinates),
    };
    put(options.output.as_deref(), options.chosen.file(), |out| {
        out.write_all(text.as_bytes())
    })
}

/// The mechanism with functions for positions and masses.
fn with_functions(source: &Source, name: &str, declared: &Declared) -> Result<Mechanism, Failure> {
    let plain = super::choose::checked(source)?;
    let plain = plain.iter().find(|mechanism| mechanism.name() == name);
    let inputs = plain.map_or(&[][..], Mechanism::inputs);
    let inputs: Vec<&str> = inputs.iter().map(|input| input.name).collect();
    let constants = declared.constants();
    let constants = match constants.is_empty() {
        true => String::new(),
        false => format!("fn {CONSTANTS}() -> RobotConstants {{ {constants} }}"),
    };
    let positions = declared.positions();
    let found = selections(&inputs).into_iter().find_map(|inputs| {
        let inputs = inputs.join(", ");
        let positions = format!("fn {POSITIONS}({inputs}) -> RobotPositions {{ {positions} }}");
        with_further_functions(source, name, &format!("{positions} {constants}"))
    });
    found.ok_or_else(|| {
        Failure::Told(format!(
            "the bodies of {name} have no constant masses, or their positions depend on loads\nhelp: write masses and inertias with parameters and constants only"
        ))
    })
}

/// The value of the driving joint at the reference, if it is the angle of the input itself.
fn shift(motion: &Motion, input: &Input, reference: f64) -> f64 {
    let is_input = |rate: f64| input.unit == "rad" && (rate - 1.0).abs() < TURN;
    match motion.rate.is_some_and(is_input) {
        true => reference,
        false => 0.0,
    }
}

/// The heading of a description.
fn model_heading(
    name: &str,
    zero: f64,
    motion: &Motion,
    ends: [f64; 2],
    remarks: Vec<String>,
    input: &Input,
) -> Heading {
    let values = &motion.values[motion.driver];
    let [first, last] = [values[0], values[values.len() - 1]];
    let is_turn = input.unit == "rad" && ends[1] - ends[0] > core::f64::consts::TAU - TURN;
    Heading {
        name: name.to_owned(),
        driver: Driver {
            name: motion.coordinates[motion.driver].name.clone(),
            zero,
            limits: (!is_turn).then(|| [first.min(last), first.max(last)]),
        },
        remarks,
    }
}
