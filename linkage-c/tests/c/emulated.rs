//! Programs for an emulated Cortex-M4.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, sources};

use crate::machine::{self, Compiler};
use linkage_corpus::given::Given;

pub(crate) const COMPILER: &str = "arm-none-eabi-gcc";
const EMULATOR: &str = "qemu-system-arm";

/// The processor, and what the page advises.
pub(crate) const FLAGS: [&str; 8] = [
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfpu=fpv4-sp-d16",
    "-mfloat-abi=hard",
    "-std=c99",
    "-O2",
    "-fno-math-errno",
    "-ffunction-sections",
];

/// Compiler, its C library and emulator. Without them tests pass and say so, unless `LINKAGE_EMULATOR=required` is in the environment.
pub(crate) fn tools() -> Option<Compiler> {
    let compiler = Compiler::named(COMPILER).filter(|_| {
        // A library that it does not find has no folder.
        let library = printed(COMPILER, Path::new("."), &["-print-file-name=libc.a"]);
        library.contains('/')
    });
    if let (Some(compiler), Some(_)) = (compiler, Compiler::named(EMULATOR)) {
        return Some(compiler);
    }
    let missing = format!("there is no `{COMPILER}` with its C library, or no `{EMULATOR}`");
    let required = env::var("LINKAGE_EMULATOR").is_ok_and(|word| word == "required");
    assert!(!required, "{missing}");
    println!("skipped: {missing}");
    None
}

/// What a compiler or a tool beside it prints.
pub(crate) fn printed(tool: &str, folder: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(tool);
    let output = command.current_dir(folder).args(arguments).output();
    let output = output.expect("it is there");
    assert!(output.status.success(), "{tool} {arguments:?}");
    String::from_utf8(output.stdout).expect("a text")
}

/// Writes the program, compiles it and links it: for memory from 0 on, as the board has it.
pub(crate) fn build(compiler: &Compiler, flags: &[&str], folder: &Path, all: &[Given]) {
    let [mut includes, mut functions, mut table] = [const { String::new() }; 3];
    let mut files = vec!["main.c".to_owned()];
    let mut count = 0;
    for (index, Given { name, unit }) in all.iter().enumerate() {
        let name = format!("M{index}{name}");
        let sources = sources(&name, unit, Real::Single).expect("it can be exported");
        machine::write(folder, &sources);
        let own = &sources.name;
        files.push(format!("{own}.c"));
        let width = unit.scalars().count();
        let _ = writeln!(includes, "#include \"{own}.h\"");
        let _ = writeln!(
            functions,
            "static {own} of_{own};\n\nstatic uint32_t assemble_{own}(const float *in)\n{{\n    {own}_dimensions d;\n    \
             memcpy(&d, in, {width} * sizeof *in);\n    return (uint32_t){own}_assemble(&of_{own}, &d);\n}}\n"
        );
        for function in &unit.functions {
            let call = format!("{own}_{}", function.name);
            let takes = function.arguments.len();
            let types = ", float".repeat(takes);
            let values: String = (0..takes).map(|k| format!(", in[{k}]")).collect();
            let gives = function.called.program.outputs.len();
            let _ = writeln!(
                functions,
                "static uint32_t call_{count}(address what, const float *in, float *out)\n{{\n    \
                 {call}_result (*const function)(const {own} *{types}) = ({call}_result (*)(const {own} *{types}))what;\n    \
                 const uint32_t before = now();\n    const {call}_result r = function(&of_{own}{values});\n    const uint32_t after = now();\n    \
                 memcpy(out, &r, {gives} * sizeof *out);\n    return between(before, after);\n}}\n"
            );
            let _ = writeln!(
                table,
                "    {{ assemble_{own}, call_{count}, (address){call}, {width}, {takes}, {gives} }},"
            );
            count += 1;
        }
    }
    let main = include_str!("emulated.c")
        .replace("/* INCLUDES */", &includes)
        .replace("/* FUNCTIONS */", &functions)
        .replace("/* TABLE */", &table);
    fs::write(folder.join("main.c"), main).expect("C can be written");
    let mut all = flags.to_vec();
    all.extend(files.iter().map(String::as_str));
    all.extend(["-nostartfiles", "-Wl,-e,start", "-o", "program"]);
    all.extend([
        "-Wl,--section-start=.vectors=0",
        "-Wl,-Ttext=0x400",
        "-Wl,-Tdata=0x20000000",
        // Roots, where the processor has none.
        "-lm",
    ]);
    compiler.run(folder, &all);
}

/// Runs it with requests; the words that it writes.
pub(crate) fn emulate(folder: &Path, requests: &[u8]) -> Vec<u32> {
    fs::write(folder.join("requests"), requests).expect("numbers can be written");
    let mut command = Command::new(EMULATOR);
    // Time goes on by 2^10 ns in each instruction.
    command.args([
        "-M",
        "mps2-an386",
        "-icount",
        "shift=10",
        "-display",
        "none",
    ]);
    command.args(["-monitor", "none", "-serial", "none"]);
    command.args(["-semihosting-config", "enable=on,target=native"]);
    let output = command
        .current_dir(folder)
        .args(["-kernel", "program"])
        .output();
    let output = output.expect("the emulator runs");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {messages}", output.status);
    let bytes = fs::read(folder.join("results")).expect("there are results");
    let (words, rest) = bytes.as_chunks();
    assert!(rest.is_empty(), "whole words");
    words.iter().map(|x| u32::from_le_bytes(*x)).collect()
}
