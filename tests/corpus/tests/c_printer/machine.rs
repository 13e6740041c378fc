//! The system's C compiler, and a program that runs printed functions on numbers.

use std::env;
use std::fmt::Write;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A C compiler, by its command.
pub(crate) struct Compiler(String);

impl Compiler {
    /// `CC` or `cc`, if that can be run. Without one tests pass and say so, unless `LINKAGE_CC=required` is in the environment.
    pub(crate) fn find() -> Option<Self> {
        let command = env::var("CC").unwrap_or_else(|_| "cc".to_owned());
        let found = Command::new(&command).arg("--version").output();
        if found.is_ok_and(|output| output.status.success()) {
            return Some(Self(command));
        }
        let required = env::var("LINKAGE_CC").is_ok_and(|word| word == "required");
        assert!(!required, "there is no C compiler `{command}`");
        println!("skipped: there is no C compiler `{command}`");
        None
    }

    /// Compiles a text with a `main` that runs `functions`. Sines and the like come from the library that Rust calls, too: `libm`.
    pub(crate) fn compile(&self, name: &str, text: &str, functions: &[Entry]) -> Executable {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c_printer");
        fs::create_dir_all(&folder).expect("a folder can be made");
        let [source, program] = ["c", "run"].map(|end| folder.join(name).with_extension(end));
        fs::write(&source, text.to_owned() + &main(functions)).expect("C can be written");
        let mut command = Command::new(&self.0);
        command.args(["-std=c11", "-O2", "-ffp-contract=off", "-fno-builtin", "-I"]);
        command.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c_printer"));
        command.arg(&source).arg("-o").arg(&program).arg("-lm");
        let output = command.output().expect("the C compiler runs");
        let messages = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}\n{messages}", source.display());
        Executable(program)
    }
}

/// A function that the program can run.
pub(crate) struct Entry {
    /// A statement that reads numbers from `in` and writes results to `out`.
    pub(crate) call: String,
    /// How many numbers it reads.
    pub(crate) takes: usize,
    /// How many results it writes.
    pub(crate) gives: usize,
}

/// A compiled program.
pub(crate) struct Executable(PathBuf);

impl Executable {
    /// Runs functions by index, each on its numbers; all results, one after the other.
    pub(crate) fn run(&self, requests: &[(usize, Vec<f64>)]) -> Vec<f64> {
        let mut bytes = Vec::new();
        for (index, numbers) in requests {
            bytes.extend((*index as u64).to_ne_bytes());
            bytes.extend(numbers.iter().flat_map(|x| x.to_ne_bytes()));
        }
        let input = self.0.with_extension("in");
        fs::write(&input, bytes).expect("numbers can be written");
        let input = File::open(input).expect("they are there");
        let output = Command::new(&self.0).stdin(input).output();
        let output = output.expect("the program runs");
        assert!(output.status.success(), "{}", output.status);
        let (numbers, rest) = output.stdout.as_chunks();
        assert!(rest.is_empty(), "whole numbers");
        numbers.iter().map(|x| f64::from_ne_bytes(*x)).collect()
    }
}

/// Reads the number of a function and what it takes, writes what it gives, until nothing is left: bits, no digits.
fn main(functions: &[Entry]) -> String {
    let most = |count: fn(&Entry) -> usize| functions.iter().map(count).max().unwrap_or(0).max(1);
    let (takes, gives) = (most(|own| own.takes), most(|own| own.gives));
    let mut text = "\n#include <stdio.h>\n\n".to_owned();
    for (index, own) in functions.iter().enumerate() {
        let _ = writeln!(
            text,
            "static void run_{index}(const double *in, double *out) {{ {} }}",
            own.call
        );
    }
    text += "\nstatic const struct { void (*run)(const double *, double *); size_t takes, gives; } functions[] = {\n";
    for (index, Entry { takes, gives, .. }) in functions.iter().enumerate() {
        let _ = writeln!(text, "    {{ run_{index}, {takes}, {gives} }},");
    }
    let _ = write!(
        text,
        "}};\n
int main(void)
{{
    static double in[{takes}], out[{gives}];
    uint64_t k;
    while (fread(&k, sizeof k, 1, stdin) == 1) {{
        if (fread(in, sizeof *in, functions[k].takes, stdin) != functions[k].takes) return 1;
        functions[k].run(in, out);
        if (fwrite(out, sizeof *out, functions[k].gives, stdout) != functions[k].gives) return 1;
    }}
    return 0;
}}
"
    );
    text
}
