//! The drives and the machine that they are parts of.

include!("../../../mechanisms/knitting_machine.rs");
