//! Emission of a mechanism written by hand, read back as Rust.

mod drawing;
mod editor_names;
mod programs;
mod sample;

use linkage_symbolic::count::Count;
use linkage_symbolic::program::{Instruction, Program, Source, Value};
use proc_macro2::TokenStream;
use quote::quote;

use self::sample::{Sample, derive, slider_crank};
use super::body::Runs;
use super::items::emit;
use super::skeleton::skeleton;
use super::{attribute, body, code, literal};
use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax;

fn pretty(tokens: TokenStream) -> String {
    let file: syn::File = syn::parse2(tokens).expect("generated items are Rust");
    prettyplease::unparse(&file)
}

fn emitted(sample: &Sample) -> String {
    pretty(emit(
        &quote!(::linkage),
        &sample.def,
        &sample.unit,
        &|_, _| String::new(),
    ))
}

#[track_caller]
fn assert_contains(text: &str, pieces: &[&str]) {
    for piece in pieces {
        assert!(text.contains(piece), "`{piece}` is missing in\n{text}");
    }
}

#[test]
fn the_surface_is_complete() {
    assert_contains(
        &emitted(&slider_crank()),
        &[
            "pub struct SliderCrank<T = ::core::primitive::f64> {",
            "pub pivot: ::linkage::__private::Vector2<T>,",
            "__p::Vector2::new(__number(0), __number(1)),",
            "__p::parameter(\"pivot.y\", \"mm\", (-2.0f64), 0.0f64)",
            "/// Length of the crank.\n    ///\n    /// In mm; default 10.\n    pub crank: T,",
            "/// `pivot`, in mm; default (1, -2), tolerance (0.5, 0).",
            "pub const INDEX_PIVOT_Y: __p::usize = 1;",
            "__p::parameter(\"pivot.x\", ",
            "kind: \"RRP\",",
            "pub struct Turning<T = ::core::primitive::f64> {",
            "pub v: [::linkage::__private::Vector2<T>; 2],",
            "pub fn path(&self, phi: T) -> Path<T> {",
            "pub fn fixed(&self) -> Fixed<T> {",
        ],
    );
}

#[test]
fn equal_input_gives_equal_output() {
    assert_eq!(emitted(&slider_crank()), emitted(&slider_crank()));
}

#[test]
fn an_argument_may_be_called_columns() {
    let Sample { mut def, unit } = slider_crank();
    def.functions[0].inputs = vec![quote::format_ident!("columns")];
    let text = emit(&quote!(::linkage), &def, &unit, &|_, _| String::new()).to_string();
    let sweeps = quote! {
        (pub fn) "path" (columns) -> PathColumns of [Path; 3] by __p::sweeps,
        [path_sweep, path_sweep_into, path_sweep_slices, path_sweep_parallel_into], [__columns, slices]
    };
    let doc = "`path_sweep_into(columns, __columns)`";
    assert_contains(&text, &[&sweeps.to_string(), doc]);
}

#[test]
fn index_names_stay_distinct() {
    let text = emitted(&slider_crank());
    assert_contains(
        &text,
        &["pub const INDEX_CRANK: ", "pub const INDEX_Crank: "],
    );
}

#[test]
fn a_user_function_takes_the_name_of_an_accessor() {
    let text = emitted(&slider_crank());
    assert_eq!(text.matches("pub fn modes(").count(), 1, "{text}");
    assert_contains(&text, &["pub const fn mechanism("]);
}

#[test]
fn sine_and_cosine_share_a_call() {
    let printed = |second: bool, outputs: &[usize]| {
        let mut program = Program::default();
        let angle = program.push(Instruction::Load(Source::Input(0)));
        let sine = program.push(Instruction::SinCos(angle));
        if second {
            program.push(Instruction::Second(sine));
        }
        program.outputs = outputs.iter().map(|&k| Value(k)).collect();
        assert_eq!(Count::of_program(&program).sin_cos, 1);
        body::statements(&program, Runs::Once, &|_, code| code.push('x'))
    };
    let both = "let (__v1,__v2)=T::sin_cos_with::<__FUSED>(x);\n";
    assert_eq!(printed(true, &[1, 2]), both);
    let cosine = "let (_,__v2)=T::sin_cos_with::<__FUSED>(x);\n";
    assert_eq!(printed(true, &[2]), cosine);
    let sine = "let (__v1,_)=T::sin_cos_with::<__FUSED>(x);\n";
    assert_eq!(printed(false, &[1]), sine);
}

#[test]
fn sines_of_calls_are_rounded_in_their_own_way_where_no_direction_is_compared() {
    let ways = |body: TokenStream| {
        let text = crate::compile(body, |_, _| String::new()).to_string();
        assert!(!text.contains("compile_error"), "{text}");
        ["sin_cos_in_rows", "sin_cos_shortest"].map(|name| text.contains(name))
    };
    let guides = quote! {
        pub struct Guides {
            unit mm;
            param beta = 100deg;
            param end = (70mm, 30mm);
            input phi = 10deg in 0deg..90deg;
            unknown s = 75mm;
            unknown t = 17mm;
            loop polar(s, phi) + polar(t, beta) = end;
        }
        impl Guides { pub fn slide(phi) -> Slide { s } }
    };
    assert_eq!(ways(guides), [true, false]);
    let four_bar = quote! {
        pub struct FourBar {
            unit mm;
            param frame = 140mm;
            input phi = 30deg in 0deg..360deg;
            unknown theta = 40deg;
            unknown psi = 80deg;
            loop polar(50mm, phi) + polar(120mm, theta) = (frame, 0mm) + polar(100mm, psi);
            let pin = polar(50mm, phi) + polar(60mm, theta);
        }
        impl FourBar { pub fn path(phi) -> Path { pin } }
    };
    assert_eq!(ways(four_bar), [false, true]);
}

#[test]
fn literals_read_back_the_same() {
    for x in [
        0.0,
        1.5,
        0.1,
        1e300,
        5e-324,
        f64::MAX,
        1e16,
        1e-7,
        f64::EPSILON,
    ] {
        let text = literal::float(x).to_string();
        let digits = text.strip_suffix("f64").expect("suffixed");
        assert_eq!(digits.parse::<f64>(), Ok(x), "{text}");
        assert!(text.len() < 30, "{text}");
    }
    assert_eq!(
        literal::float(-1.5).to_string(),
        quote!((-1.5f64)).to_string()
    );
    assert_eq!(
        literal::float(-0.0).to_string(),
        quote!((-0.0f64)).to_string()
    );
    assert!(literal::float(f64::NAN).to_string().ends_with("NAN"));
}

#[test]
fn derives_of_the_user_are_not_repeated() {
    let user = [
        derive(quote!(std::clone::Clone, serde::Serialize)),
        derive(quote!(Copy,)),
    ];
    let derives = |ours| code::text(&attribute::derives(&user, ours));
    let rest = |text| code::text(&code::tokens(text));
    let all = rest("#[derive(::core::fmt::Debug,::core::cmp::PartialEq)]");
    assert_eq!(derives(&[]), all);
    let equality = rest("#[derive(::core::cmp::PartialEq)]");
    assert_eq!(derives(&["Debug"]), equality);
}

#[test]
fn the_skeleton_has_the_same_items() {
    let Sample { def, .. } = slider_crank();
    let mechanism = sample::mechanism();
    let guessed = pretty(skeleton(&quote!(::linkage), &def, None));
    assert_contains(
        &guessed,
        &[
            "pub pivot: ::linkage::__private::Vector2<T>,",
            "pub crank: T,",
            "pub a: ::linkage::__private::Vector2<T>,",
            "pub s: T,",
            "pub fn path(&self, phi: T) -> Path<T> {\n            ::core::unimplemented!",
        ],
    );
    let known = pretty(skeleton(&quote!(::linkage), &def, Some(&mechanism)));
    assert_contains(&known, &["pub pivot: ::linkage::__private::Vector2<T>,"]);
}

#[test]
fn the_skeleton_has_a_follower_if_there_are_several_inputs() {
    // Within a macro nothing is laid out.
    let packed = |text: &str| text.replace(|c: char| c.is_whitespace(), "");
    let skeleton = |inputs: TokenStream| {
        let tokens = quote! {
            pub struct Rocker { unit mm; #inputs unknown s = 1mm; loop s = wrong; }
            impl Rocker { pub fn path(phi) -> Path { s } }
        };
        let def = syntax::parse(tokens, &mut Diagnostics::default()).pop();
        packed(&pretty(skeleton(
            &quote!(::linkage),
            &def.expect("a mechanism"),
            None,
        )))
    };
    let one = skeleton(quote!(input phi = 0deg;));
    assert!(!one.contains("RockerFollower"), "{one}");
    let several = skeleton(quote!(input phi = 0deg; input theta = 0deg;));
    let pieces = [
        "pub struct RockerFollower<'a, T = ::core::primitive::f64>",
        "pub fn follower(&self, phi: T, theta: T)",
        "pub fn follow(&mut self, phi: T, theta: T)",
        "pub fn inputs(&self) -> [T; 2] { ::core::unimplemented!",
        "pub fn path(&self,) -> Path<T> { ::core::unimplemented!",
    ];
    let pieces = pieces.map(packed);
    assert_contains(&several, &pieces.each_ref().map(String::as_str));
}

#[test]
fn the_skeleton_leaves_out_second_items_of_one_name() {
    let mut sample = slider_crank();
    let double = slider_crank().def;
    sample.def.items.extend(double.items);
    sample.def.functions.extend(double.functions);
    let text = pretty(skeleton(&quote!(::linkage), &sample.def, None));
    assert_eq!(text.matches("pub crank: T").count(), 1, "{text}");
    assert_eq!(text.matches("pub fn path(").count(), 1, "{text}");
}
