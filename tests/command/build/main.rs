//! Writes a module for each mechanism of the folder `mechanisms`, of the golden files, of `kinds.rs`, of some tests and of the corpus: the
//! mechanism as the macro takes it, and how its functions are called with a list of numbers.

mod chosen;
mod written;

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use chosen::{Candidate, chosen, swept};
use linkage_compiler::check;
use linkage_compiler::ir::{CompiledMechanism, Function};
use linkage_corpus::{COUNT, sample};
use proc_macro2::TokenStream;
use written::written;

/// A mechanism, where it stands, and what it became.
struct Entry {
    name: String,
    path: PathBuf,
    number: usize,
    body: String,
    title: String,
    unit: CompiledMechanism,
}

/// Tests by the engine with kinds of groups, tables or operations that nothing else has.
const TESTS: [&str; 8] = [
    "forces/gears.rs",
    "forces/statics.rs",
    "functions/far_sizes.rs",
    "space/sarrus.rs",
    "space/stacked.rs",
    "triads/many_inputs.rs",
    "triads/pinned.rs",
    "triads/scissors.rs",
];

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut entries = Vec::new();
    for (folder, ending) in [
        ("mechanisms", "rs"),
        ("linkage-compiler/tests/golden", "mech"),
    ] {
        println!("cargo:rerun-if-changed={}", root.join(folder).display());
        for path in files(&root.join(folder), ending) {
            entries.extend(calls(ending, &path));
        }
    }
    let kinds = Path::new(env!("CARGO_MANIFEST_DIR")).join("kinds.rs");
    entries.extend(calls("kinds", &kinds));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo says it"));
    let written = entries.len();
    for file in TESTS {
        let path = root.join("tests").join(file);
        println!("cargo:rerun-if-changed={}", path.display());
        let text = fs::read_to_string(path).expect("a test");
        let own = out.join(file.replace('/', "_"));
        fs::write(&own, text.replace("interpreted! {", "mechanism! {")).expect("it can be written");
        entries.extend(calls("tests", &own));
    }
    for seed in 0..COUNT {
        let path = out.join(format!("{seed}.mech"));
        fs::write(&path, sample(seed, &format!("Generated{seed}")).text)
            .expect("it can be written");
        entries.extend(calls("corpus", &path));
    }
    println!("cargo:rerun-if-env-changed=LINKAGE_LONG");
    let long = env::var_os("LINKAGE_LONG").is_some();
    let candidates = entries.iter().enumerate().map(|(k, entry)| Candidate {
        unit: &entry.unit,
        random: k >= written,
    });
    let chosen = chosen(&candidates.collect::<Vec<_>>(), long);
    let chosen = entries.iter().zip(chosen).filter(|(_, own)| *own);
    let chosen: Vec<&Entry> = chosen.map(|(entry, _)| entry).collect();
    let units: Vec<&CompiledMechanism> = chosen.iter().map(|entry| &entry.unit).collect();
    let swept = swept(&units, long);
    let modules = chosen.iter().zip(&swept);
    let mut text: String = modules.map(|(entry, swept)| module(entry, swept)).collect();
    let calls = chosen
        .iter()
        .map(|entry| format!("    {}::subject(),\n", entry.name));
    let list = calls.collect::<String>();
    let _ = write!(
        text,
        "\n/// All of them.\npub fn all() -> Vec<Subject> {{\n    vec![\n{list}    ]\n}}\n"
    );
    fs::write(out.join("mechanisms.rs"), text).expect("it can be written");
}

/// The mechanisms of a file.
fn calls(kind: &str, path: &Path) -> Vec<Entry> {
    let text = fs::read_to_string(path).expect("a file");
    let calls = written(&text).into_iter().enumerate();
    calls
        .map(|(number, tokens)| entry(kind, path, number, &text, tokens))
        .collect()
}

fn entry(ending: &str, path: &Path, number: usize, text: &str, tokens: TokenStream) -> Entry {
    let checked = check(tokens.clone());
    let tokens: Vec<_> = tokens.into_iter().collect();
    let first = tokens.first().expect("a token").span().byte_range().start;
    let last = tokens.last().expect("a token").span().byte_range().end;
    let stem = path.file_stem().expect("a name").to_string_lossy();
    Entry {
        name: format!("{ending}_{stem}_{number}"),
        path: path.canonicalize().expect("it is there"),
        number,
        body: text[first..last].to_owned(),
        title: checked.name.expect("it has a name"),
        unit: checked.unit.expect("an example has no mistake"),
    }
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let files = fs::read_dir(folder).expect("the folder can be read");
    let paths = files.map(|file| file.expect("a file").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|own| own == ending))
        .collect();
    paths.sort();
    paths
}

fn module(entry: &Entry, swept: &[bool]) -> String {
    let Entry {
        name,
        path,
        number,
        body,
        title,
        unit,
    } = entry;
    let count = unit.scalars().count();
    let functions = || unit.functions.iter().enumerate();
    let calls: String = functions().map(call).collect();
    let swept_functions = || functions().filter(|(number, _)| swept[*number]);
    let sweeps: String = swept_functions()
        .filter_map(|one| sweep(one, "sweep", ""))
        .collect();
    let sets: String = match count {
        0 => String::new(),
        _ => swept_functions()
            .filter_map(|one| sweep(one, "sweep_sets", "&sets, "))
            .collect(),
    };
    let circuits = match has_circuits(unit) {
        true => {
            "Some(own.circuits().map_or_else(|error| error.to_string(), |all| all.to_string()))"
        }
        false => "None",
    };
    let at = (0..unit.inputs.len()).map(|k| format!("unit.inputs[{k}]"));
    let at = at.collect::<Vec<_>>().join(", ");
    let listed = match unit.inputs.is_empty() {
        true => "own.assemblies()".to_owned(),
        false => {
            format!("{{ let unit = Reference::of({title}::INPUTS); own.assemblies_at({at}) }}")
        }
    };
    format!(
        "
mod {name} {{
    #![allow(dead_code, deprecated, unused_variables, unreachable_pub, missing_docs, clippy::all)]
    use super::*;
    linkage::mechanism! {{
{body}
    }}

    fn mechanism(dimensions: &[f64]) -> {title} {{
        let values: &[f64; {count}] = dimensions.try_into().expect(\"all dimensions\");
        <{title} as linkage::Dimensions<{count}>>::from_values(values)
    }}

    fn called(linkage: &{title}Assembly, function: usize, x: &[f64]) -> Vec<f64> {{
        let mut out = Vec::new();
        match function {{
{calls}            _ => unreachable!(\"no such function\"),
        }}
        out
    }}

    pub fn subject() -> Subject {{
        Subject {{
            name: \"{name}\",
            path: {path:?},
            number: {number},
            assembled: |dimensions| {{
                let linkage = mechanism(dimensions).assemble().map_err(|error| error.to_string())?;
                Ok(Box::new(move |function, x| called(&linkage, function, x)))
            }},
            assembled_from: |from, to| {{
                let from = mechanism(from).assemble().map_err(|error| error.to_string())?;
                let linkage = mechanism(to).assemble_from(&from).map_err(|error| error.to_string())?;
                Ok(Box::new(move |function, x| called(&linkage, function, x)))
            }},
            swept: |dimensions, function, x| {{
                let linkage = mechanism(dimensions).assemble().expect(\"it closes\");
                match function {{
{sweeps}                    _ => None,
                }}
            }},
            swept_sets: |dimensions, function, sets, x| {{
                let linkage = mechanism(dimensions).assemble().expect(\"it closes\");
                let sets: Vec<{title}> = sets.iter().map(|set| mechanism(set)).collect();
                match function {{
{sets}                    _ => None,
                }}
            }},
            listed: || {{
                let own = {title}::default();
                let all = {listed};
                let modes = all.iter().flatten().map(|own| own.modes().to_vec());
                modes.collect()
            }},
            circuits: || {{
                let own = {title}::default();
                {circuits}
            }},
            structure: || {title}::STRUCTURE.to_string(),
            is_swept: &{swept:?},
        }}
    }}
}}
"
    )
}

fn has_circuits(unit: &CompiledMechanism) -> bool {
    unit.inputs.len() == 1 && !unit.groups.is_empty()
}

/// The arguments of a function in a call.
fn arguments(function: &Function) -> String {
    let arguments = (0..function.arguments.len()).map(|k| format!("x[{k}]"));
    arguments.collect::<Vec<_>>().join(", ")
}

/// The numbers of a result behind those of `out`.
fn flat(function: &Function) -> String {
    let fields = function.fields.iter();
    fields
        .map(|field| format!(" result.{}.flat(&mut out);", field.name))
        .collect()
}

fn call((number, function): (usize, &Function)) -> String {
    format!(
        "            {number} => {{ let result = linkage.{}({});{} }}\n",
        function.name,
        arguments(function),
        flat(function)
    )
}

/// The rows of a sweep; `None` for a function without arguments, which has none.
fn sweep((number, function): (usize, &Function), kind: &str, first: &str) -> Option<String> {
    (!function.arguments.is_empty()).then(|| {
        format!(
            "                    {number} => Some(linkage.{}_{kind}({first}{}).iter().map(|result| {{ let mut out = Vec::new();{} out }}).collect()),\n",
            function.name,
            arguments(function),
            flat(function)
        )
    })
}
