//! The drawing in the docs of a mechanism.

use std::fs;
use std::path::Path;

use proc_macro2::TokenStream;
use quote::quote;

/// The drawing in the docs of the first mechanism of a text.
fn drawing(text: TokenStream) -> Option<String> {
    let items = crate::compile(text, |_, _| String::new());
    let file: syn::File = syn::parse2(items).expect("items are Rust");
    let attributes = file.items.iter().find_map(|item| match item {
        syn::Item::Struct(item) => Some(&item.attrs),
        _ => None,
    });
    let only_docs = attributes?
        .iter()
        .find(|attribute| attribute.path().is_ident("cfg_attr"))?;
    let syn::Meta::List(list) = &only_docs.meta else {
        panic!("a list");
    };
    let mut tokens = list.tokens.clone().into_iter();
    let head: TokenStream = tokens.by_ref().take(4).collect();
    assert_eq!(head.to_string(), quote!(doc, doc =).to_string());
    let text: syn::LitStr = syn::parse2(tokens.collect()).expect("a text");
    Some(text.value())
}

/// The ends of a bar in the drawing.
fn bar(drawing: &str, name: &str) -> [[f64; 2]; 2] {
    let end = drawing.find(&format!("<title>{name}</title>"));
    let (before, _) = drawing.split_at(end.expect("a link"));
    let path = before
        .rsplit("d=\"M")
        .next()
        .and_then(|d| d.split('"').next());
    let ends = path.expect("a path").split('L').map(|at| {
        let (x, y) = at.split_once(' ').expect("two numbers");
        [x, y].map(|x| x.parse().expect("a number"))
    });
    let ends: Vec<[f64; 2]> = ends.collect();
    ends.try_into().expect("two ends")
}

#[test]
fn the_drawing_is_the_picture_at_the_reference_inputs() {
    let text = quote! {
        pub struct FourBar {
            unit mm;
            param crank = 50mm;
            param rocker = 100mm;
            input phi = 90deg in 0deg..360deg;
            unknown theta = 40deg;
            unknown psi = 80deg;
            let a = polar(crank, phi);
            loop a + polar(120mm, theta) = (140mm, 0mm) + polar(rocker, psi);
        }
        impl FourBar { pub fn shape(phi) -> Shape { shape: picture() } }
    };
    let drawing = drawing(text).expect("a drawing");
    assert!(drawing.contains("aria-label=\"FourBar at its reference inputs\""));
    assert!(drawing.contains(">a</text>"), "{drawing}");
    assert!(drawing.contains("currentColor") && !drawing.contains("black"));
    // A paragraph that begins after an empty line and has none in it.
    assert!(drawing.starts_with("\n <div>") && drawing.trim().lines().count() == 1);
    let [[x, bottom], [same, top]] = bar(&drawing, "crank");
    assert!((x - same).abs() < 0.11, "the crank is upright: {drawing}");
    let [from, to] = bar(&drawing, "rocker");
    let ratio = (to[0] - from[0]).hypot(to[1] - from[1]) / (top - bottom).abs();
    assert!((ratio - 2.0).abs() < 0.01, "{ratio}");
    // The second axis points up.
    let pivot = drawing.find("l-8 14h16z").expect("a pivot");
    assert!(drawing[..pivot].ends_with(&format!("M{x} {}", bottom.max(top))));
}

/// The point is in the middle of its slot, between the two sides.
#[test]
fn a_curved_slot_has_two_arcs_about_its_point() {
    let text = include_str!("../../../linkage-compiler/tests/drawings/curved_slot.mech");
    let drawing = drawing(text.parse().expect("tokens")).expect("a drawing");
    let (before, _) = drawing.split_once("<title>slot</title>").expect("a slot");
    let path = before.rsplit("d=\"M").next().expect("a path");
    let path = path.split('"').next().expect("a path");
    let pieces: Vec<Vec<f64>> = path
        .trim_end_matches('Z')
        .split('A')
        .map(|piece| {
            piece
                .split(' ')
                .map(|x| x.parse().expect("a number"))
                .collect()
        })
        .collect();
    let [start, outer, first, inner, second] = &pieces[..] else {
        panic!("{path}")
    };
    // Radii and ends of the arcs; the slot is as wide as the round ends are high.
    assert_eq!((first[0], second[0], &second[5..]), (6.0, 6.0, &start[..]));
    assert!((outer[0] - inner[0] - 12.0).abs() < 0.11, "{path}");
    let pin = drawing.find(">pin</text>").expect("a name");
    let at = |value: &str| -> f64 {
        let tag = drawing[..pin].rsplit('<').next().expect("a tag");
        let text = tag.split(&format!("{value}=\"")).nth(1).expect(value);
        text.split('"')
            .next()
            .expect(value)
            .parse()
            .expect("a number")
    };
    // Names are to the right of their points, above them.
    let pin = [at("x") - 7.0, at("y") + 7.0];
    let ends = [start, &outer[5..], &first[5..], &inner[5..]];
    let reach = ends.map(|end| (end[0] - pin[0]).hypot(end[1] - pin[1]));
    let [least, most] = [f64::min, f64::max].map(|pick| reach.into_iter().reduce(pick));
    assert!(
        most.unwrap_or(0.0) - least.unwrap_or(0.0) < 4.0,
        "{reach:?}"
    );
}

#[test]
fn a_mechanism_without_a_picture_has_no_drawing() {
    let text = quote! {
        pub struct Slider {
            unit mm;
            input phi = 90deg in 0deg..360deg;
            unknown theta = 0deg;
            unknown s = 80mm;
            loop polar(20mm, phi) + polar(80mm, theta) = (s, 0mm);
        }
        impl Slider { pub fn stroke(phi) -> Stroke { s } }
    };
    assert_eq!(drawing(text), None);
}

#[test]
fn textbook_mechanisms_are_drawn_in_less_than_ten_kilobytes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../linkage-compiler/tests/drawings");
    let files = fs::read_dir(folder).expect("the folder");
    let files = files.map(|file| file.expect("a file").path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "mech"));
    let mut count = 0;
    for file in files {
        let text = fs::read_to_string(&file).expect("a text");
        let drawing = drawing(text.parse().expect("tokens")).expect("a drawing");
        let name = file.display();
        assert!(drawing.len() < 10_000, "{name}: {} bytes", drawing.len());
        assert!(
            !drawing.contains("NaN") && !drawing.contains("inf"),
            "{name}"
        );
        let titles = drawing.matches("<title>").count();
        assert!(titles > 1, "{name}: {titles} links and guides");
        for tag in ["svg", "g", "path", "title", "text", "div"] {
            let open = [format!("<{tag} "), format!("<{tag}>")];
            let open: usize = open
                .iter()
                .map(|open| drawing.matches(&**open).count())
                .sum();
            let empty = match tag {
                "path" => drawing.matches("/>").count() - drawing.matches("<circle").count(),
                _ => 0,
            };
            let closed = drawing.matches(&format!("</{tag}>")).count();
            assert_eq!(open, closed + empty, "{name}: {tag}");
        }
        count += 1;
    }
    assert!(count >= 25, "{count} mechanisms");
}
