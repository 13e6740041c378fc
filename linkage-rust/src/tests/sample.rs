//! A slider-crank, written by hand in every form that emission reads.

use linkage_core::range_check::Slack;
use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};

use super::programs;
use linkage_compiler::ir::{CompiledMechanism, Group, Input, Parameter, Scalar, Unknown};
use linkage_language::diagnostic::{Diagnostics, OriginId, SourceSpan};
use linkage_language::model::{
    self, Dimension, LengthUnit, Mechanism, ScalarParameterId, Shape, Type,
};
use linkage_language::syntax::{
    self, Attribute, FunctionDef, InputItem, Item, MechanismDef, NamedItem, ParamItem, QuantityDef,
    Toleranced,
};

/// The syntax tree and the unit of one mechanism.
pub(crate) struct Sample {
    pub(crate) def: MechanismDef,
    pub(crate) unit: CompiledMechanism,
}

/// Crank about `pivot`, rod to a slider on the x axis; `theta` is the direction of the rod, `wheel`
/// turns with the crank.
pub(crate) fn slider_crank() -> Sample {
    Sample {
        def: def(),
        unit: unit(),
    }
}

const LENGTH: Dimension = Dimension::LENGTH;
const ANGLE: Dimension = Dimension::ANGLE;

fn here() -> SourceSpan {
    SourceSpan {
        first: Span::call_site(),
        last: Span::call_site(),
    }
}

fn doc(text: &str) -> Attribute {
    let tokens = quote!(#[doc = #text]);
    Attribute {
        name: "doc".to_owned(),
        tokens,
        arguments: quote!(= #text),
        span: here(),
    }
}

pub(crate) fn derive(traits: TokenStream) -> Attribute {
    let tokens = quote!(#[derive(#traits)]);
    Attribute {
        name: "derive".to_owned(),
        tokens,
        arguments: quote!((#traits)),
        span: here(),
    }
}

fn number(text: &str) -> syntax::Expr {
    let kind = syntax::ExprKind::Number {
        text: text.to_owned(),
        suffix: String::new(),
    };
    syntax::Expr { kind, span: here() }
}

pub(crate) fn name(name: &str) -> syntax::Expr {
    syntax::Expr {
        kind: syntax::ExprKind::Name(format_ident!("{name}")),
        span: here(),
    }
}

fn call(function: &str, arguments: Vec<syntax::Expr>) -> syntax::Expr {
    syntax::Expr {
        kind: syntax::ExprKind::Call(format_ident!("{function}"), arguments),
        span: here(),
    }
}

fn param(name: &str, attributes: Vec<Attribute>, nominal: syntax::Expr) -> Item {
    let value = Toleranced::Single {
        nominal,
        tolerance: None,
    };
    Item::Param(ParamItem {
        attributes,
        name: format_ident!("{name}").into(),
        value,
    })
}

fn function(
    name: &str,
    result: &str,
    inputs: &[&str],
    quantities: Vec<QuantityDef>,
) -> FunctionDef {
    FunctionDef {
        attributes: vec![doc(" A function.")],
        visibility: quote!(pub),
        name: format_ident!("{name}"),
        inputs: inputs
            .iter()
            .map(|input| format_ident!("{input}"))
            .collect(),
        result: format_ident!("{result}"),
        quantities,
    }
}

fn quantity(field: &str, value: syntax::Expr) -> QuantityDef {
    QuantityDef {
        attributes: vec![],
        field: format_ident!("{field}"),
        value,
    }
}

fn def() -> MechanismDef {
    let pivot = Toleranced::Components {
        components: vec![(number("1"), Some(number("0.5"))), (number("-2"), None)],
        span: here(),
    };
    let a = NamedItem {
        name: format_ident!("a").into(),
        value: call("polar", vec![name("crank"), name("phi")]),
    };
    let rates = call("velocity", vec![name("a")]);
    MechanismDef {
        attributes: vec![
            doc(" A slider-crank."),
            derive(quote!(Clone, ::core::fmt::Debug)),
        ],
        visibility: quote!(pub),
        name: format_ident!("SliderCrank"),
        items: vec![
            Item::Param(ParamItem {
                attributes: vec![],
                name: format_ident!("pivot").into(),
                value: pivot,
            }),
            param("crank", vec![doc(" Length of the crank.")], number("10")),
            param("Crank", vec![], number("30")),
            Item::Input(InputItem {
                name: format_ident!("phi"),
                value: number("0.5"),
                range: None,
                speed: None,
                acceleration: None,
            }),
            Item::Let(a),
        ],
        functions: vec![
            function(
                "path",
                "Path",
                &["phi"],
                vec![quantity("a", name("a")), quantity("s", name("s"))],
            ),
            function(
                "modes",
                "Turning",
                &["phi"],
                vec![
                    quantity("len", name("theta")),
                    quantity("wheel", name("wheel")),
                    quantity("v", rates),
                ],
            ),
            function("fixed", "Fixed", &[], vec![quantity("rod2", name("rod2"))]),
        ],
        links: None,
        link_elements: syntax::LinkElements::default(),
        warnings: Diagnostics::default(),
        links_are_lost: false,
        link_names_are_lost: false,
    }
}

fn zero() -> model::Expr {
    model::Expr {
        kind: model::ExprKind::Number(0.0),
        ty: Type::Zero(1),
        origin: OriginId(0),
    }
}

/// The model, as far as a skeleton needs it.
pub(crate) fn mechanism() -> Mechanism {
    let parameter = |name: &str, ty: Type, components: usize, first: usize| model::Parameter {
        name: name.to_owned(),
        documentation: String::new(),
        ty,
        origin: OriginId(0),
        may_be_unused: false,
        nominal: zero(),
        tolerances: vec![None; components],
        first_scalar: ScalarParameterId(first),
    };
    let scalar = |name: &str, parameter: usize| model::ScalarParameter {
        name: name.to_owned(),
        parameter,
        dimension: LENGTH,
    };
    let unknown = |name: &str| model::Unknown {
        name: name.to_owned(),
        ty: Type::Scalar(ANGLE),
        estimate: Some(zero()),
        of_part: false,
        origin: OriginId(0),
    };
    let evaluator = |name: &str, result: &str, inputs: Vec<usize>| model::EvaluatorDef {
        name: name.to_owned(),
        documentation: String::new(),
        result: result.to_owned(),
        input_origins: vec![OriginId(0); inputs.len()],
        inputs,
        quantities: vec![],
        origin: OriginId(0),
    };
    Mechanism {
        name: "SliderCrank".to_owned(),
        documentation: String::new(),
        unit: LengthUnit::Millimetre,
        constants: vec![],
        redundant: vec![],
        leaves: vec![],
        parameters: vec![
            parameter("pivot", Type::Vector(2, LENGTH), 2, 0),
            parameter("crank", Type::Scalar(LENGTH), 1, 2),
            parameter("Crank", Type::Scalar(LENGTH), 1, 3),
        ],
        scalar_parameters: vec![
            scalar("pivot.x", 0),
            scalar("pivot.y", 0),
            scalar("crank", 1),
            scalar("Crank", 2),
        ],
        inputs: vec![model::Input {
            name: "phi".to_owned(),
            dimension: ANGLE,
            reference: zero(),
            range: None,
            speed: None,
            acceleration: None,
            origin: OriginId(0),
        }],
        unknowns: vec![unknown("theta"), unknown("wheel")],
        lets: vec![],
        loops: vec![],
        arguments: vec![],
        parts: vec![],
        placed: vec![],
        gravity: None,
        bodies: vec![],
        joints: vec![],
        loads: vec![],
        elements: vec![],
        frictions: vec![],
        arcs: vec![],
        links: None,
        link_elements: model::LinkElements::default(),
        evaluators: vec![
            evaluator("path", "Path", vec![0]),
            evaluator("modes", "Turning", vec![0]),
            evaluator("fixed", "Fixed", vec![]),
        ],
        origin: OriginId(0),
    }
}

fn unit() -> CompiledMechanism {
    let scalar = |name: &str, nominal, tolerance| Scalar {
        name: name.to_owned(),
        unit: "mm".to_owned(),
        nominal,
        tolerance,
    };
    let unknown = |name: &str| Unknown {
        name: name.to_owned(),
        unit: "rad".to_owned(),
        is_number: true,
    };
    let alone = |scalar: Scalar| Parameter {
        name: scalar.name.clone(),
        documentation: String::new(),
        shape: Shape::Scalar,
        is_link_length: true,
        scalars: vec![scalar],
    };
    CompiledMechanism {
        parameters: vec![
            Parameter {
                name: "pivot".to_owned(),
                documentation: String::new(),
                shape: Shape::Vector(2),
                is_link_length: false,
                scalars: vec![scalar("pivot.x", 1.0, 0.5), scalar("pivot.y", -2.0, 0.0)],
            },
            alone(scalar("crank", 10.0, 0.0)),
            alone(scalar("Crank", 30.0, 0.0)),
        ],
        inputs: vec![Input {
            name: "phi".to_owned(),
            unit: "rad".to_owned(),
            angle: true,
            reference: 0.5,
            range: None,
            followed: (0.0, 0.0),
            rates: vec![0.0, 1.0, -1.0],
        }],
        unknowns: vec![unknown("theta"), unknown("wheel")],
        groups: vec![Group {
            class: 2,
            order: 2,
            kind: "RRP".to_owned(),
            loops: vec![1],
            joints: String::new(),
            unknowns: vec!["theta".to_owned()],
            mode: Some(0),
            coupled: false,
            plus: true,
            method: "closed form".to_owned(),
            gap_unit: "mm".to_owned(),
            slack: Slack::Number,
            parameters: vec![0],
        }],
        mobility: 1,
        longest: 1.0,
        ..programs::unit()
    }
}
