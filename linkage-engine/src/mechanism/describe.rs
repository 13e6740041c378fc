//! The runtime's descriptions of a unit, as generated code has them as constants.

use linkage_compiler::ir::{CompiledMechanism, Function, Meaning, Picture, plain};
use linkage_runtime::support::{self, Along, Angle, Description, GroupData, SurveyedUnknown};
use linkage_runtime::{
    AssemblyMode, Axis, Column, FunctionInfo, Group, Guide, Heading, Input, Operations, Parameter,
    PictureColumns, PictureJoint, PictureLink, PicturePart, PicturePoint, Structure,
};
use linkage_symbolic::count::Count;

use super::describe_coupled;
use super::forever::forever;

/// The data that its assembly needs.
pub(super) fn description(
    name: &'static str,
    groups: &'static [Group],
    unit: &CompiledMechanism,
) -> Description {
    let needed = unit.groups.iter().flat_map(|group| &group.parameters);
    let units = unit.groups.iter();
    let units = units.map(|group| forever(group.gap_unit.as_str()));
    let modes = unit.modes().into_iter().map(|plus| match plus {
        true => AssemblyMode::Plus,
        false => AssemblyMode::Minus,
    });
    // Those with numbers are the mechanism's: a text whose dimensions change takes no more memory.
    let names = parameters(unit).into_iter().map(|parameter| Parameter {
        nominal: 0.0,
        tolerance: 0.0,
        ..parameter
    });
    Description {
        name,
        inputs: inputs(unit),
        parameters: forever(names.collect::<Vec<_>>()),
        groups,
        needed: forever(needed.copied().collect::<Vec<_>>()),
        gap_units: forever(units.collect::<Vec<_>>()),
        prepared: unit.slots(),
        modes: forever(modes.collect::<Vec<_>>()),
        angles: angles(unit),
    }
}

/// The data that searches for its assemblies need.
pub(super) fn group_data(
    name: &'static str,
    described: &'static [Group],
    unit: &CompiledMechanism,
) -> GroupData {
    let slacks = unit.groups.iter().map(|group| group.slack);
    GroupData {
        levels: forever(unit.levels()),
        slacks: forever(slacks.collect::<Vec<_>>()),
        coupled: describe_coupled::groups(name, described, unit),
        surveying: unit.surveying,
        unknowns: surveyed(unit),
        repeats: unit.repeats(),
        cycle: match &unit.inputs[..] {
            [input] => Some(input.cycle()),
            _ => None,
        },
    }
}

fn inputs(unit: &CompiledMechanism) -> &'static [Input] {
    let inputs = unit.inputs.iter().map(|input| Input {
        name: forever(plain(&input.name)),
        unit: forever(input.unit.as_str()),
        reference: input.reference,
        range: input.range,
    });
    forever(inputs.collect::<Vec<_>>())
}

/// Its scalar parameters with defaults and tolerances.
pub(super) fn parameters(unit: &CompiledMechanism) -> Vec<Parameter> {
    let parameters = unit.scalars().map(|scalar| Parameter {
        name: forever(scalar.name.as_str()),
        unit: forever(scalar.unit.as_str()),
        nominal: scalar.nominal,
        tolerance: scalar.tolerance,
    });
    parameters.collect()
}

pub(super) fn structure(unit: &CompiledMechanism) -> &'static Structure {
    let groups = unit.groups.iter().map(|group| Group {
        class: group.class,
        order: group.order,
        kind: forever(group.kind.as_str()),
        loops: forever(group.loops.as_slice()),
        joints: forever(group.joints.as_str()),
        unknowns: names(&group.unknowns),
        mode: group.mode,
        method: forever(group.method.as_str()),
    });
    let functions = unit.functions.iter().map(|function| FunctionInfo {
        name: forever(plain(&function.name)),
        operations: operations(&function.called.count),
    });
    let structure = Structure {
        mobility: unit.mobility,
        groups: forever(groups.collect::<Vec<_>>()),
        functions: forever(functions.collect::<Vec<_>>()),
        prepare: operations(&Count::of_program(&unit.prepare)),
    };
    forever(structure)
}

fn operations(count: &Count) -> Operations {
    support::operations(count.by_class())
}

pub(super) fn headings(unit: &CompiledMechanism) -> Vec<&'static Heading> {
    let picture = unit.picture.as_ref().map(picture);
    let functions = unit.functions.iter();
    functions
        .map(|function| forever(heading(unit, function, picture)))
        .collect()
}

fn heading(
    unit: &CompiledMechanism,
    function: &Function,
    picture: Option<&'static linkage_runtime::Picture>,
) -> Heading {
    let inputs = unit.inputs.iter().map(|input| input.name.as_str());
    let behind = unit.arguments.iter().map(|argument| argument.name.as_str());
    let all: Vec<&str> = inputs.chain(behind).collect();
    let arguments = function.arguments.iter();
    let arguments = arguments.map(|&index| forever(plain(all[index])));
    let mut meanings = function.columns.iter().map(|column| column.meaning);
    let first = meanings.position(|meaning| meaning == Meaning::Picture);
    let columns = function.columns.iter().map(|column| Column {
        name: forever(column.name.as_str()),
        unit: forever(column.unit.as_str()),
        meaning: column.meaning,
    });
    let shown = first.zip(picture);
    Heading {
        function: forever(plain(&function.name)),
        arguments: forever(arguments.collect::<Vec<_>>()),
        columns: forever(columns.collect::<Vec<_>>()),
        picture: shown.map(|(first, picture)| PictureColumns { first, picture }),
    }
}

fn picture(drawn: &Picture) -> &'static linkage_runtime::Picture {
    let points = drawn.points.iter().map(|point| PicturePoint {
        name: forever(point.name.as_str()),
        kind: point.kind,
    });
    let links = drawn.links.iter().map(|link| PictureLink {
        name: forever(link.name.as_str()),
        points: forever(link.points.as_slice()),
    });
    let guides = drawn.guides.iter().map(|guide| Guide {
        name: forever(guide.name.as_str()),
        origin: guide.origin,
        direction: guide.direction,
        slider: guide.slider,
        on: guide.on,
        shape: guide.shape,
    });
    let axes = drawn.axes.iter();
    let axes = axes.map(|&(point, direction)| Axis { point, direction });
    let joints = drawn.joints.iter().map(|joint| PictureJoint {
        point: joint.point,
        shape: joint.shape,
    });
    let parts = drawn.parts.iter().map(|part| PicturePart {
        name: forever(part.name.as_str()),
        points: forever(part.points.as_slice()),
        links: forever(part.links.as_slice()),
        guides: forever(part.guides.as_slice()),
    });
    forever(linkage_runtime::Picture {
        dimension: drawn.dimension,
        points: forever(points.collect::<Vec<_>>()),
        directions: names(&drawn.directions),
        links: forever(links.collect::<Vec<_>>()),
        guides: forever(guides.collect::<Vec<_>>()),
        axes: forever(axes.collect::<Vec<_>>()),
        joints: forever(joints.collect::<Vec<_>>()),
        gears: forever(drawn.gears.clone()),
        drives: forever(drawn.drives.clone()),
        undrawn: forever(drawn.undrawn.clone()),
        parts: forever(parts.collect::<Vec<_>>()),
    })
}

fn angles(unit: &CompiledMechanism) -> &'static [Angle] {
    let angle = |angle_of_unit: &linkage_compiler::ir::ContinuousAngle| {
        let along = angle_of_unit.inputs.iter().map(|&input| {
            let (low, high) = unit.inputs[input].followed;
            Along {
                input,
                low,
                high,
                rates: forever(unit.inputs[input].rates.as_slice()),
            }
        });
        let phases = angle_of_unit.phases.iter();
        let phases = phases.map(|phase| phase.turns.as_deref().map(forever));
        Angle {
            unknown: forever(unit.unknowns[angle_of_unit.unknown].name.as_str()),
            estimate: angle_of_unit.estimate,
            along: forever(along.collect::<Vec<_>>()),
            phases: forever(phases.collect::<Vec<_>>()),
        }
    };
    forever(unit.angles.iter().map(angle).collect::<Vec<_>>())
}

/// The unknowns in the order of their numbers in a survey.
fn surveyed(unit: &CompiledMechanism) -> &'static [SurveyedUnknown] {
    let unknowns = unit.surveyed.iter().map(|surveyed| {
        let unknown = &unit.unknowns[surveyed.unknown];
        SurveyedUnknown {
            name: forever(unknown.name.as_str()),
            unit: match surveyed.angle {
                true => "",
                false => forever(unknown.unit.as_str()),
            },
            angle: surveyed.angle,
            numbers: surveyed.numbers,
        }
    });
    forever(unknowns.collect::<Vec<_>>())
}

fn names(texts: &[String]) -> &'static [&'static str] {
    let names = texts.iter().map(|name| forever(name.as_str()));
    forever(names.collect::<Vec<_>>())
}
