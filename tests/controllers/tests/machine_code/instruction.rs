//! What an instruction does, as far as the tests ask.

/// Kinds of instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A jump on a condition, or one to a computed address.
    Branch,
    /// A call, or a jump that does not depend on anything.
    Call,
    Return,
    /// A square root in single precision.
    Root,
    /// A division in single precision.
    Division,
    /// Arithmetic or conversion in double precision.
    Double,
    Other,
}

/// How the instructions of a processor are read: the kind of the first one and its bytes.
pub(crate) type Decode = fn(&[u8]) -> (Kind, usize);

/// Thumb-2 with the floating-point instructions of ARM version 7.
pub(crate) fn thumb(code: &[u8]) -> (Kind, usize) {
    let half = |at: usize| u16::from_le_bytes([code[at], code[at + 1]]);
    let first = half(0);
    if first >> 11 < 0b11101 {
        (thumb_short(first), 2)
    } else {
        (thumb_long(first, half(2)), 4)
    }
}

fn thumb_short(code: u16) -> Kind {
    match code {
        // bx lr, pop { .., pc }
        0x4770 | 0xBD00..=0xBDFF => Kind::Return,
        // bx, blx; b with a condition
        0x4700..=0x47FF | 0xD000..=0xDDFF => Kind::Branch,
        0xE000..=0xE7FF => Kind::Call,
        // cbz, cbnz
        _ if code & 0xF500 == 0xB100 => Kind::Branch,
        _ => Kind::Other,
    }
}

fn thumb_long(first: u16, second: u16) -> Kind {
    let code = u32::from(first) << 16 | u32::from(second);
    let is = |mask: u32, bits: u32| code & mask == bits;
    // pop.w { .., pc }, ldr pc, [sp], #4
    if is(0xFFFF_8000, 0xE8BD_8000) || code == 0xF85D_FB04 {
        Kind::Return
    // bl, blx, b.w
    } else if is(0xF800_C000, 0xF000_C000) || is(0xF800_D000, 0xF000_9000) {
        Kind::Call
    // b with a condition (14 and 15 are barriers and the like), tbb and tbh
    } else if is(0xF800_D000, 0xF000_8000) && first >> 7 & 7 != 7 || is(0xFFF0_FFE0, 0xE8D0_F000) {
        Kind::Branch
    } else if is(0xFFBF_0FD0, 0xEEB1_0AC0) {
        Kind::Root
    } else if is(0xFFB0_0F50, 0xEE80_0A00) {
        Kind::Division
    // Arithmetic of coprocessor 11, whose bit 4 is set in what moves only; a conversion by coprocessor 10
    } else if is(0xFF00_0F10, 0xEE00_0B00) || is(0xFFBF_0FD0, 0xEEB7_0AC0) {
        Kind::Double
    } else {
        Kind::Other
    }
}

/// AArch64.
pub(crate) fn aarch64(code: &[u8]) -> (Kind, usize) {
    let code = u32::from_le_bytes([code[0], code[1], code[2], code[3]]);
    let is = |mask: u32, bits: u32| code & mask == bits;
    let kind = if is(0xFFFF_FC1F, 0xD65F_0000) {
        Kind::Return
    // b, bl
    } else if is(0x7C00_0000, 0x1400_0000) {
        Kind::Call
    // b with a condition; cbz, cbnz; tbz, tbnz; br, blr
    } else if is(0xFF00_0000, 0x5400_0000)
        || is(0x7C00_0000, 0x3400_0000)
        || is(0xFFDF_FC1F, 0xD61F_0000)
    {
        Kind::Branch
    // Of a number, of a vector
    } else if is(0xFFFF_FC00, 0x1E21_C000) || is(0xBFFF_FC00, 0x2EA1_F800) {
        Kind::Root
    } else if is(0xFFE0_FC00, 0x1E20_1800) || is(0xBFE0_FC00, 0x2E20_FC00) {
        Kind::Division
    // Numbers of type 1; conversions to them; multiply-adds of them
    } else if is(0xFFE0_0000, 0x1E60_0000)
        || is(0xFFFF_FC00, 0x1E22_C000)
        || is(0xFFC0_0000, 0x1F40_0000)
    {
        Kind::Double
    } else {
        Kind::Other
    };
    (kind, 4)
}

#[cfg(test)]
mod tests {
    use super::{Decode, Kind, aarch64, thumb};

    fn are(decode: Decode, codes: &[(&[u8], Kind)]) {
        for &(code, kind) in codes {
            assert_eq!(decode(code), (kind, code.len()), "{code:02x?}");
        }
    }

    /// As an assembler translates them.
    #[test]
    fn thumb_is_read() {
        are(
            thumb,
            &[
                (&[0x70, 0x47], Kind::Return),               // bx lr
                (&[0x10, 0xBD], Kind::Return),               // pop {r4, pc}
                (&[0xBD, 0xE8, 0x10, 0x81], Kind::Return),   // pop.w {r4, r8, pc}
                (&[0x5D, 0xF8, 0x04, 0xFB], Kind::Return),   // ldr pc, [sp], #4
                (&[0x00, 0xF0, 0x20, 0xF8], Kind::Call),     // bl
                (&[0x00, 0xF0, 0x20, 0xB8], Kind::Call),     // b.w
                (&[0x0A, 0xE0], Kind::Call),                 // b
                (&[0x04, 0xD0], Kind::Branch),               // beq
                (&[0x40, 0xF0, 0x96, 0x80], Kind::Branch),   // bne.w
                (&[0x20, 0xB1], Kind::Branch),               // cbz r0
                (&[0xDF, 0xE8, 0x01, 0xF0], Kind::Branch),   // tbb [pc, r1]
                (&[0x98, 0x47], Kind::Branch),               // blx r3
                (&[0xF1, 0xEE, 0xE1, 0x8A], Kind::Root),     // vsqrt.f32 s17, s3
                (&[0xCF, 0xEE, 0x21, 0x0A], Kind::Division), // vdiv.f32 s1, s30, s3
                (&[0x32, 0xEE, 0x03, 0x1B], Kind::Double),   // vadd.f64 d1, d2, d3
                (&[0xB7, 0xEE, 0xC1, 0x1A], Kind::Double),   // vcvt.f64.f32 d1, s2
                (&[0xB1, 0xEE, 0xC2, 0x1B], Kind::Double),   // vsqrt.f64 d1, d2
                (&[0x71, 0xEE, 0x21, 0x0A], Kind::Other),    // vadd.f32 s1, s2, s3
                (&[0xB7, 0xEE, 0x00, 0x0A], Kind::Other),    // vmov.f32 s0, #1.0
                (&[0x01, 0xEE, 0x10, 0x0B], Kind::Other),    // vmov.32 d1[0], r0
                (&[0x2D, 0xED, 0x02, 0x8B], Kind::Other),    // vpush {d8}
                (&[0xBF, 0xF3, 0x5F, 0x8F], Kind::Other),    // dmb sy
                (&[0x48, 0xBF], Kind::Other),                // it mi
            ],
        );
    }

    #[test]
    fn aarch64_is_read() {
        are(
            aarch64,
            &[
                (&[0xC0, 0x03, 0x5F, 0xD6], Kind::Return),
                (&[0x10, 0x00, 0x00, 0x94], Kind::Call), // bl
                (&[0x10, 0x00, 0x00, 0x14], Kind::Call), // b
                (&[0x40, 0x00, 0x00, 0x54], Kind::Branch), // b.eq
                (&[0x40, 0x00, 0x00, 0xB4], Kind::Branch), // cbz x0
                (&[0x41, 0x00, 0x18, 0x37], Kind::Branch), // tbnz w1, #3
                (&[0x20, 0x00, 0x1F, 0xD6], Kind::Branch), // br x1
                (&[0x40, 0x00, 0x3F, 0xD6], Kind::Branch), // blr x2
                (&[0x41, 0xC0, 0x21, 0x1E], Kind::Root), // fsqrt s1, s2
                (&[0x41, 0xF8, 0xA1, 0x2E], Kind::Root), // fsqrt v1.2s, v2.2s
                (&[0x41, 0x18, 0x23, 0x1E], Kind::Division), // fdiv s1, s2, s3
                (&[0x41, 0xFC, 0x23, 0x6E], Kind::Division), // fdiv v1.4s, v2.4s, v3.4s
                (&[0x41, 0x28, 0x63, 0x1E], Kind::Double), // fadd d1, d2, d3
                (&[0x41, 0xC0, 0x22, 0x1E], Kind::Double), // fcvt d1, s2
                (&[0x41, 0x40, 0x62, 0x1E], Kind::Double), // fcvt s1, d2
                (&[0x41, 0x10, 0x43, 0x1F], Kind::Double), // fmadd d1, d2, d3, d4
                (&[0x41, 0x28, 0x23, 0x1E], Kind::Other), // fadd s1, s2, s3
                (&[0x41, 0x10, 0x03, 0x1F], Kind::Other), // fmadd s1, s2, s3, s4
                (&[0x01, 0x00, 0x40, 0xFD], Kind::Other), // ldr d1, [x0]
                (&[0x20, 0x00, 0x27, 0x1E], Kind::Other), // fmov s0, w1
                (&[0x41, 0xD0, 0x3B, 0xD5], Kind::Other), // mrs x1, tpidr_el0
            ],
        );
    }
}
