//! Names of the user that JavaScript or a module has itself.

use linkage_corpus::given::Given;
use linkage_js::{Module, module, modules};

/// Words that are no names of variables, in modules and for TypeScript, as far as Rust has them as names.
const WORDS: &str = "arguments case catch class debugger default delete eval export extends finally function globalThis implements \
    import instanceof interface new null package private protected public switch this throw undefined var void with";

/// A mechanism with these inputs, functions and results.
fn mechanism(name: &str, inputs: &[&str], function: &str, result: &str) -> Given {
    let declared: String = inputs
        .iter()
        .map(|own| format!("input {own} = 3mm;\n"))
        .collect();
    let sum: String = inputs.iter().map(|own| format!(" + {own}")).collect();
    let takes = inputs.join(", ");
    Given::text(&format!(
        "pub struct {name} {{ unit mm; param length = 30mm; {declared} let sum__of = length{sum}; }}
         impl {name} {{ pub fn {function}({takes}) -> Result1 {{ {result}: sum__of }} }}"
    ))
}

fn printed(own: &Given) -> Module {
    module(&own.name, &own.unit)
}

#[test]
fn words_of_javascript_are_exported_by_other_names() {
    for word in WORDS.split_whitespace().chain(["Error", "AssemblyError"]) {
        let own = printed(&mechanism(word, &["s"], "f", "r"));
        assert_eq!(own.name, format!("{word}_"));
        assert!(
            own.script.contains(&format!(
                "export {{ mechanism as {word}_, AssemblyError }};"
            )),
            "{word}"
        );
        assert!(
            own.script.contains(&format!(
                "the name {word} itself, or its modules have: this one exports {word}_."
            )),
            "{word}"
        );
        assert!(
            own.types.contains(&format!(
                "export declare const {word}_: Mechanism<Dimensions, Assembly>;"
            )),
            "{word}"
        );
    }
    for name in ["Press", "Math", "Object", "Mechanism", "É"] {
        let own = printed(&mechanism(name, &["s"], "f", "r"));
        assert_eq!(own.name, name);
        assert!(!own.script.contains("this one exports"), "{name}");
    }
}

/// In the types each argument has a name of its own, and `new` is a function.
#[test]
fn words_of_javascript_are_arguments_functions_and_results() {
    let words: Vec<&str> = WORDS.split_whitespace().collect();
    let own = printed(&mechanism("Words", &words, "new", "class"));
    let arguments: Vec<String> = words.iter().map(|own| format!("{own}_: number")).collect();
    let line = format!("  \"new\"({}): {{ class: number }};", arguments.join(", "));
    assert!(own.types.contains(&line), "{line}\n{}", own.types);
    let own = printed(&mechanism(
        "Twice",
        &["this", "this_", "this__", "that"],
        "function",
        "default",
    ));
    let line = "  function(this_: number, this__: number, this___: number, that: number): { default: number };";
    assert!(own.types.contains(line), "{}", own.types);
}

#[test]
fn two_mechanisms_with_one_file_are_refused() {
    let of = |names: [&str; 2]| {
        let given = names.map(|name| mechanism(name, &["s"], "f", "r"));
        let named: Vec<_> = given.iter().map(|own| (&own.name[..], &own.unit)).collect();
        modules(&named)
            .map(|all| all.len())
            .map_err(|clash| clash.to_string())
    };
    for (names, files) in [
        (
            ["SliderCrank", "SLIDERCRANK"],
            "`SliderCrank.js` and `SLIDERCRANK.js`",
        ),
        (["class", "class_"], "`class_.js` and `class_.js`"),
        (["Class", "class"], ""),
        (["É", "é"], "`É.js` and `é.js`"),
    ] {
        let [first, second] = names;
        match (of(names), files) {
            (Ok(count), "") => assert_eq!(count, 2),
            (Err(text), files) => {
                let start =
                    format!("`{first}` and `{second}` would have the files {files}, which are one");
                assert!(!files.is_empty() && text.starts_with(&start), "{text}");
            }
            (Ok(_), files) => panic!("{files} are two files"),
        }
    }
    // Other letters are other files.
    assert_eq!(of(["SliderCrank", "Slider_Crank"]), Ok(2));
}
