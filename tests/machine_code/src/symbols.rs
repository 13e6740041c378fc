//! Functions of this program by its symbol table, and elementary functions of the C library.

use crate::decode::destination;
use std::collections::BTreeMap;
use std::ffi::c_double;
use std::sync::OnceLock;

// The functions of this program: its symbol table, in the format of ELF.

/// A function of this program.
#[derive(Clone, Debug)]
pub(crate) struct Symbol {
    pub(crate) start: u64,
    pub(crate) end: u64,
    pub(crate) name: String,
}

/// The function that begins at an address of this process.
pub(crate) fn at(address: u64) -> Option<&'static Symbol> {
    static ALL: OnceLock<BTreeMap<u64, Symbol>> = OnceLock::new();
    ALL.get_or_init(|| read().expect("this program has a symbol table"))
        .get(&address)
}

fn read() -> Option<BTreeMap<u64, Symbol>> {
    let path = std::fs::read_link("/proc/self/exe").ok()?;
    let file = File(std::fs::read(&path).ok()?);
    let base = base(path.to_str()?)?;
    let sections = file.number::<8>(0x28)? as usize;
    let size = file.number::<2>(0x3A)? as usize;
    let count = file.number::<2>(0x3C)? as usize;
    let section = |index: usize| sections + index * size;
    const SYMBOLS: u64 = 2;
    let table = (0..count).find(|&k| file.number::<4>(section(k) + 4) == Some(SYMBOLS))?;
    let names = file.number::<4>(section(table) + 0x28)? as usize;
    let names = file.number::<8>(section(names) + 0x18)? as usize;
    let start = file.number::<8>(section(table) + 0x18)? as usize;
    let length = file.number::<8>(section(table) + 0x20)? as usize;
    let symbols = (start..start + length).step_by(24);
    symbols
        .filter_map(|at| file.function(at, names, base))
        .map(|symbol| Some((symbol.start, symbol)))
        .collect()
}

/// Where this program is loaded.
fn base(path: &str) -> Option<u64> {
    let maps = std::fs::read_to_string("/proc/self/maps").ok()?;
    let first = maps.lines().find(|line| line.ends_with(path))?;
    u64::from_str_radix(first.split('-').next()?, 16).ok()
}

struct File(Vec<u8>);

impl File {
    /// A number of `N` bytes.
    fn number<const N: usize>(&self, at: usize) -> Option<u64> {
        let bytes = self.0.get(at..)?.first_chunk::<N>()?;
        Some(
            bytes
                .iter()
                .rev()
                .fold(0, |sum, &byte| sum << 8 | u64::from(byte)),
        )
    }

    /// The symbol at `at` if it is a function that is here.
    fn function(&self, at: usize, names: usize, base: u64) -> Option<Symbol> {
        const FUNCTION: u64 = 2;
        let kind = self.number::<1>(at + 4)? & 15;
        let [value, size] = [8, 16].map(|offset| self.number::<8>(at + offset));
        let (value, size) = (value?, size?);
        if kind != FUNCTION || size == 0 {
            return None;
        }
        let name = &self.0[names + self.number::<4>(at)? as usize..];
        let end = name.iter().position(|&byte| byte == 0)?;
        Some(Symbol {
            start: base + value,
            end: base + value + size,
            name: String::from_utf8_lossy(&name[..end]).into_owned(),
        })
    }
}

// Elementary functions of the C library.

#[allow(unsafe_code, reason = "only their addresses are used")]
unsafe extern "C" {
    safe fn sin(x: c_double) -> c_double;
    safe fn cos(x: c_double) -> c_double;
    safe fn tan(x: c_double) -> c_double;
    safe fn asin(x: c_double) -> c_double;
    safe fn acos(x: c_double) -> c_double;
    safe fn atan(x: c_double) -> c_double;
    safe fn atan2(y: c_double, x: c_double) -> c_double;
    safe fn hypot(x: c_double, y: c_double) -> c_double;
    safe fn fma(x: c_double, y: c_double, z: c_double) -> c_double;
    fn sincos(x: c_double, sin: *mut c_double, cos: *mut c_double);
}

/// Names of the functions by address.
pub(crate) fn library_functions() -> BTreeMap<u64, &'static str> {
    let functions = [
        (sin as *const (), "sin"),
        (cos as *const (), "cos"),
        (sincos as *const (), "sincos"),
        (tan as *const (), "tan"),
        (asin as *const (), "asin"),
        (acos as *const (), "acos"),
        (atan as *const (), "atan"),
        (atan2 as *const (), "atan2"),
        (hypot as *const (), "hypot"),
        (fma as *const (), "fma"),
    ];
    functions
        .map(|(function, name)| (destination(function as u64), name))
        .into()
}
