/* By how much rounding may turn negative what was computed from terms of the size x; NaN where that is infinite. */
static inline real own_slack(real x)
{
    return EIGHT_ROUNDOFFS * fabs(x) + 0.0 * x;
}
