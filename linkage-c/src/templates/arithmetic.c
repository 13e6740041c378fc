/* Whether numbers are computed as results need it: 0, or the number of what is wrong. Compilers do not know volatile numbers, and leave
   all of this to the processor. */
static int own_arithmetic(void)
{
    volatile real known = 1.0, small = 8.673617379884035e-19, third = 0.3333333333333333, between = 1.75;
    volatile real above, below, within, last, half;
    real one, rest, sum, lost, whole;
    /* Rounded up, down or towards zero, one of them is another number. */
    above = known + small;
    below = -known - small;
    within = known - small;
    if (above != 1.0 || below != -1.0 || within != 1.0) return ROUNDING;
    /* The last digit counts, half of it does not; a third has all of its digits. */
    last = ROUNDOFF;
    half = HALF_ROUNDOFF;
    if ((known + last) - known != ROUNDOFF || (known + half) - known != 0.0 || own_bits(third) != THIRD) return DIGITS;
    /* What a sum loses, and the nearest integer: in another order, nothing is lost or rounded. */
    one = known;
    rest = small;
    sum = one + rest;
    lost = (one - sum) + rest;
    whole = between;
    whole = (whole + ROUND) - ROUND;
    if (lost != 8.673617379884035e-19 || whole != 2.0) return REORDERED;
/* SINE */
    return 0;
}
