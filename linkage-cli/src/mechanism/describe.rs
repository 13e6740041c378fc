//! The runtime's descriptions of a unit, as generated code has them as constants.

use linkage_compiler::ir::{CompiledMechanism, Coupled, Function, Meaning, Picture, Shown};
use linkage_runtime::generated::{
    Along, Angle, CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown, Range, Term,
};
use linkage_runtime::{
    Axis, Column, FunctionInfo, Group, Guide, Heading, Input, Operations, Parameter,
    PictureColumns, PictureJoint, PictureLink, PicturePart, PicturePoint, Structure,
};
use linkage_symbolic::count::Count;

use super::{forever, plain};

pub(super) fn inputs(unit: &CompiledMechanism) -> &'static [Input] {
    let inputs = unit.inputs.iter().map(|own| Input {
        name: forever(plain(&own.name)),
        unit: forever(own.unit.as_str()),
        reference: own.reference,
        range: own.range,
    });
    forever(inputs.collect::<Vec<_>>())
}

pub(super) fn parameters(unit: &CompiledMechanism) -> &'static [Parameter] {
    let parameters = unit.scalars().map(|own| Parameter {
        name: forever(own.name.as_str()),
        unit: forever(own.unit.as_str()),
        nominal: own.nominal,
        tolerance: own.tolerance,
    });
    forever(parameters.collect::<Vec<_>>())
}

pub(super) fn structure(unit: &CompiledMechanism) -> &'static Structure {
    let groups = unit.groups.iter().map(|own| Group {
        class: own.class,
        order: own.order,
        kind: forever(own.kind.as_str()),
        loops: forever(own.loops.as_slice()),
        unknowns: names(&own.unknowns),
        mode: own.mode,
        method: forever(own.method.as_str()),
    });
    let functions = unit.functions.iter().map(|own| FunctionInfo {
        name: forever(plain(&own.name)),
        operations: operations(&own.called.count),
    });
    let structure = Structure {
        mobility: unit.mobility,
        groups: forever(groups.collect::<Vec<_>>()),
        functions: forever(functions.collect::<Vec<_>>()),
        prepare: operations(&Count::of(&unit.prepare)),
    };
    forever(structure)
}

fn operations(count: &Count) -> Operations {
    let Count {
        add,
        mul,
        div,
        sqrt,
        sin_cos,
        atan2,
        other,
    } = *count;
    Operations {
        add,
        mul,
        div,
        sqrt,
        sin_cos,
        atan2,
        other,
    }
}

pub(super) fn headings(unit: &CompiledMechanism) -> Vec<&'static Heading> {
    let picture = unit.picture.as_ref().map(picture);
    let functions = unit.functions.iter();
    functions
        .map(|own| forever(heading(unit, own, picture)))
        .collect()
}

fn heading(
    unit: &CompiledMechanism,
    function: &Function,
    picture: Option<&'static linkage_runtime::Picture>,
) -> Heading {
    let inputs = unit.inputs.iter().map(|own| own.name.as_str());
    let behind = unit.arguments.iter().map(|own| own.name.as_str());
    let all: Vec<&str> = inputs.chain(behind).collect();
    let arguments = function.arguments.iter();
    let arguments = arguments.map(|&place| forever(plain(all[place])));
    let mut meanings = function.columns.iter().map(|own| own.meaning);
    let first = meanings.position(|meaning| meaning == Meaning::Picture);
    let columns = function.columns.iter().map(|own| Column {
        name: forever(own.name.as_str()),
        unit: forever(own.unit.as_str()),
        meaning: own.meaning,
    });
    let shown = first.zip(picture);
    Heading {
        function: forever(plain(&function.name)),
        arguments: forever(arguments.collect::<Vec<_>>()),
        columns: forever(columns.collect::<Vec<_>>()),
        picture: shown.map(|(first, picture)| PictureColumns { first, picture }),
    }
}

fn picture(own: &Picture) -> &'static linkage_runtime::Picture {
    let points = own.points.iter().map(|point| PicturePoint {
        name: forever(point.name.as_str()),
        kind: point.kind,
    });
    let links = own.links.iter().map(|link| PictureLink {
        name: forever(link.name.as_str()),
        points: forever(link.points.as_slice()),
    });
    let guides = own.guides.iter().map(|guide| Guide {
        name: forever(guide.name.as_str()),
        origin: guide.origin,
        direction: guide.direction,
        slider: guide.slider,
        on: guide.on,
        shape: guide.shape,
    });
    let axes = own.axes.iter();
    let axes = axes.map(|&(point, direction)| Axis { point, direction });
    let joints = own.joints.iter().map(|joint| PictureJoint {
        point: joint.point,
        shape: joint.shape,
    });
    let parts = own.parts.iter().map(|part| PicturePart {
        name: forever(part.name.as_str()),
        points: forever(part.points.as_slice()),
        links: forever(part.links.as_slice()),
        guides: forever(part.guides.as_slice()),
    });
    forever(linkage_runtime::Picture {
        dimension: own.dimension,
        points: forever(points.collect::<Vec<_>>()),
        directions: names(&own.directions),
        links: forever(links.collect::<Vec<_>>()),
        guides: forever(guides.collect::<Vec<_>>()),
        axes: forever(axes.collect::<Vec<_>>()),
        joints: forever(joints.collect::<Vec<_>>()),
        gears: forever(own.gears.clone()),
        drives: forever(own.drives.clone()),
        undrawn: forever(own.undrawn.clone()),
        parts: forever(parts.collect::<Vec<_>>()),
    })
}

pub(super) fn angles(unit: &CompiledMechanism) -> Vec<Angle<Vec<f64>>> {
    let angle = |own: &linkage_compiler::ir::ContinuousAngle| {
        let along = own.inputs.iter().map(|&input| {
            let (low, high) = unit.inputs[input].followed;
            Along {
                input,
                low,
                high,
                rates: forever(unit.inputs[input].rates.as_slice()),
            }
        });
        let phases = own.phases.iter().map(|phase| phase.turns.clone());
        Angle {
            unknown: forever(unit.unknowns[own.unknown].name.as_str()),
            estimate: own.estimate,
            along: forever(along.collect::<Vec<_>>()),
            phases: forever(phases.collect::<Vec<_>>()),
        }
    };
    unit.angles.iter().map(angle).collect()
}

pub(super) fn groups(mechanism: &'static str, unit: &CompiledMechanism) -> &'static [CoupledGroup] {
    let groups = unit.coupled.iter();
    let groups = groups.map(|own| group(mechanism, unit, own));
    forever(groups.collect::<Vec<_>>())
}

fn group(mechanism: &'static str, unit: &CompiledMechanism, coupled: &Coupled) -> CoupledGroup {
    let own = &unit.groups[coupled.group];
    let unknowns = coupled.unknowns.iter().map(|placed| {
        let Shown { name, unit, scale } = placed.shown(unit);
        CoupledUnknown {
            name: forever(name),
            estimate: placed.estimate,
            scale,
            unit: forever(unit),
            angle: placed.angle,
        }
    });
    let terms = coupled.terms.iter().map(|(equation, exponents)| Term {
        equation: *equation,
        exponents: forever(exponents.as_slice()),
    });
    let inputs = coupled.inputs.iter().map(|&index| {
        let own = &unit.inputs[index];
        let (low, high) = own.followed;
        CoupledInput {
            name: forever(own.name.as_str()),
            unit: forever(own.unit.as_str()),
            index,
            declared: own.range.is_some(),
            range: Range {
                low,
                high,
                turn: own.angle,
            },
        }
    });
    let missed = coupled.missed_loops.iter().map(|own| CoupledLoop {
        number: own.number,
        rows: own.rows,
        unit: forever(own.unit.as_str()),
        scale: own.scale,
    });
    CoupledGroup {
        mechanism,
        group: coupled.group,
        kind: forever(own.kind.as_str()),
        loops: forever(own.loops.as_slice()),
        names: names(&own.unknowns),
        unknowns: forever(unknowns.collect::<Vec<_>>()),
        variables: forever(coupled.variables.as_slice()),
        terms: forever(terms.collect::<Vec<_>>()),
        missed: forever(missed.collect::<Vec<_>>()),
        inputs: forever(inputs.collect::<Vec<_>>()),
        in_cells: coupled.in_cells,
    }
}

fn names(own: &[String]) -> &'static [&'static str] {
    let names = own.iter().map(|name| forever(name.as_str()));
    forever(names.collect::<Vec<_>>())
}
