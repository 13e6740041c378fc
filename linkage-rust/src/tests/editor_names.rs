//! Names for editors, of texts that are being written.

use proc_macro2::{TokenStream, TokenTree};

use crate::editor_names::names;

const TEXT: &str = "
    struct Crank { unit mm; param radius = 12mm; input phi = 0deg; let tip = polar(radius, phi); }
    pub struct Machine {
        unit mm;
        /// Length of the rod.
        param rod = 60mm +- 0.1mm;
        input shaft = 0deg in 0deg..360deg at omega;
        part wheel: Crank { phi = 2 * shaft } at (10mm, 0mm);
        unknown s = 50mm;
        unknown theta = 0deg;
        joint a = (0mm, 0mm), b = (20mm, 5mm);
        link frame: a;
        link arm: a, b;
        loop wheel.tip + polar(rod, theta) = (s, 0);
        body piston = slide on frame at (s, 0) along (1, 0), mass 2kg at (s, 0);
    }
    impl Machine { pub fn motion(shaft) -> Motion { s, v: velocity(s), b } }";

/// The text without the tokens after the first `count`, those within brackets counted.
fn shortened(tokens: TokenStream, count: &mut usize) -> TokenStream {
    let mut kept = TokenStream::new();
    for token in tokens {
        if *count == 0 {
            break;
        }
        *count -= 1;
        kept.extend([match token {
            TokenTree::Group(group) => {
                let inner = shortened(group.stream(), count);
                proc_macro2::Group::new(group.delimiter(), inner).into()
            }
            other => other,
        }]);
    }
    kept
}

#[test]
fn half_a_text_has_the_names_of_its_half() {
    let tokens: TokenStream = TEXT.parse().expect("brackets have partners");
    let mut count = 0;
    loop {
        let mut left = count;
        let text = shortened(tokens.clone(), &mut left);
        let printed = names(text.clone());
        let file: syn::File = syn::parse2(printed.clone())
            .unwrap_or_else(|error| panic!("{error}: {printed} of {text}"));
        assert_eq!(file.items.len(), 1);
        if left > 0 {
            break;
        }
        count += 1;
    }
    assert!(count > 150);
}

#[test]
fn accesses_come_before_fields_and_name_every_use() {
    let tokens: TokenStream = TEXT.parse().expect("brackets have partners");
    let printed = names(tokens).to_string();
    let position = |piece: &str| {
        printed
            .find(piece)
            .unwrap_or_else(|| panic!("{piece}: {printed}"))
    };
    assert!(position("__n1 . theta") < position("theta : f64"));
    for piece in [
        "__m0 . radius ;",
        "__n1 . wheel . phi ;",
        "__n1 . wheel . tip ;",
        "__m1 . rod ;",
        "__r0 . s ;",
        "Length of the rod.\\n\\n`param rod = 60mm +- 0.1mm`",
        "__Machine_names :: velocity ;",
        // A keyword of Rust is no field that completions offer.
        "__w ; __k . r#loop ;",
        "__w . param ;",
        "__n1 ; __c1 . mass ;",
        "__w . slide ;",
        "__n1 ; __c0 . frame ;",
        "__n1 ; __u . mm ;",
        // The end of an item and of a block.
        "__n1 ; __c2 ;",
        "__w ; __n1",
        "theta : f64",
        "`unknown s = 50mm`\\n\\na length, in mm",
        "fn polar (& self , r#length : f64 , r#angle : f64)",
        "wheel : __Crank_names ,",
        "arm : __Machine_names_arm ,",
    ] {
        position(piece);
    }
    for piece in [
        "__n1 . velocity",
        "__n1 . mm",
        "__n1 . at ;",
        "__n1 . mass",
        "__n1 . slide",
        "__n1 . frame",
        "__n1 . Crank",
    ] {
        assert!(!printed.contains(piece), "{piece}: {printed}");
    }
}
