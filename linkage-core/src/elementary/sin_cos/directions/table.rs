//! The directions of a turn.

/// Directions in a turn.
pub(super) const DIRECTIONS: usize = 128;
/// The row behind them, of NaN.
pub(super) const NOWHERE: usize = DIRECTIONS;
/// Directions of an eighth of a turn, both ends included.
const EIGHTH: usize = DIRECTIONS / 8 + 1;

/// Cosine and its rounding error, sine and its rounding error.
type Direction = [f64; 4];

/// Directions of a whole turn from the first axis on, then [`NOWHERE`]; 4 KB.
pub(super) static TABLE: [Direction; DIRECTIONS + 1] = turn();

/// All directions by those of an eighth.
const fn turn() -> [Direction; DIRECTIONS + 1] {
    const RIGHT_ANGLE: usize = DIRECTIONS / 4;
    let mut turn = [[f64::NAN; 4]; DIRECTIONS + 1];
    let mut n = 0;
    while n < DIRECTIONS {
        let within = n % RIGHT_ANGLE;
        let [c, c_rest, s, s_rest] = if within < EIGHTH {
            first(within)
        } else {
            let [s, s_rest, c, c_rest] = first(RIGHT_ANGLE - within);
            [c, c_rest, s, s_rest]
        };
        turn[n] = match n / RIGHT_ANGLE {
            0 => [c, c_rest, s, s_rest],
            1 => [-s, -s_rest, c, c_rest],
            2 => [-c, -c_rest, -s, -s_rest],
            _ => [s, s_rest, -c, -c_rest],
        };
        n += 1;
    }
    turn
}

/// The direction of `n` steps, of the first eighth.
const fn first(n: usize) -> Direction {
    let [c, c_rest, s, s_rest] = BITS[n];
    [
        f64::from_bits(c),
        f64::from_bits(c_rest),
        f64::from_bits(s),
        f64::from_bits(s_rest),
    ]
}

/// Multiples of pi/64, each word rounded to nearest.
const BITS: [[u64; 4]; EIGHTH] = [
    [
        0x3FF0_0000_0000_0000,
        0x0000_0000_0000_0000,
        0x0000_0000_0000_0000,
        0x0000_0000_0000_0000,
    ],
    [
        0x3FEF_F621_E379_6D7E,
        0xBC6C_57BC_2E24_AA15,
        0x3FA9_1F65_F10D_D814,
        0xBC29_12BD_0D56_9A90,
    ],
    [
        0x3FEF_D88D_A3D1_2526,
        0xBC88_7DF6_3788_11C7,
        0x3FB9_17A6_BC29_B42C,
        0xBC3E_2718_D26E_D688,
    ],
    [
        0x3FEF_A755_7F08_A517,
        0xBC87_A0A8_CA13_571F,
        0x3FC2_C810_6E8E_613A,
        0x3C51_3000_A89A_11E0,
    ],
    [
        0x3FEF_6297_CFF7_5CB0,
        0x3C75_6217_2A36_1FD3,
        0x3FC8_F8B8_3C69_A60B,
        0xBC62_6D19_B9FF_8D82,
    ],
    [
        0x3FEF_0A7E_FB92_30D7,
        0x3C75_2C7A_DC6B_4989,
        0x3FCF_19F9_7B21_5F1B,
        0xBC64_2DEE_F11D_A2C4,
    ],
    [
        0x3FEE_9F41_56C6_2DDA,
        0x3C87_60B1_E2E3_F81E,
        0x3FD2_9406_2ED5_9F06,
        0xBC75_D28D_A2C4_612D,
    ],
    [
        0x3FEE_2121_04F6_86E5,
        0xBC80_14C7_6C12_6527,
        0x3FD5_8F9A_75AB_1FDD,
        0xBC1E_FDC0_D58C_F620,
    ],
    [
        0x3FED_906B_CF32_8D46,
        0x3C74_57E6_1023_1AC2,
        0x3FD8_7DE2_A6AE_A963,
        0xBC67_2CED_D3D5_A610,
    ],
    [
        0x3FEC_ED7A_F43C_C773,
        0xBC5E_7B6B_B5AB_58AE,
        0x3FDB_5D10_09E1_5CC0,
        0x3C65_B362_CB97_4183,
    ],
    [
        0x3FEC_38B2_F180_BDB1,
        0xBC76_E0B1_757C_8D07,
        0x3FDE_2B5D_3806_F63B,
        0x3C5E_0D89_1D3C_6841,
    ],
    [
        0x3FEB_7283_4519_6E3E,
        0xBC8B_C69F_324E_6D61,
        0x3FE0_7387_9922_FFEE,
        0xBC8A_5A01_4347_406C,
    ],
    [
        0x3FEA_9B66_290E_A1A3,
        0x3C39_F630_E8B6_DAC8,
        0x3FE1_C73B_39AE_68C8,
        0x3C8B_25DD_267F_6600,
    ],
    [
        0x3FE9_B3E0_47F3_8741,
        0xBC83_0EE2_8671_2474,
        0x3FE3_0FF7_FCE1_7035,
        0xBC6E_FCC6_26F7_4A6F,
    ],
    [
        0x3FE8_BC80_6B15_1741,
        0xBC82_C5E1_2ED1_336D,
        0x3FE4_4CF3_2509_1DD6,
        0x3C68_076A_2CFD_C6B3,
    ],
    [
        0x3FE7_B5DF_226A_AFAF,
        0xBC70_F537_ACDF_0AD7,
        0x3FE5_7D69_348C_ECA0,
        0xBC87_5720_992B_FBB2,
    ],
    [
        0x3FE6_A09E_667F_3BCD,
        0xBC8B_DD34_13B2_6456,
        0x3FE6_A09E_667F_3BCD,
        0xBC8B_DD34_13B2_6456,
    ],
];
