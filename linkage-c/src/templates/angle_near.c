/* The direction of (x, y), with the whole turns that bring it nearest to guide. */
static inline real own_angle_near(real y, real x, real guide)
{
    const real angle = own_atan2(y, x);
    const real turns = ((guide - angle) * TURNS + ROUND) - ROUND;
    return (angle + turns * TURN_LOW) + turns * TURN_HIGH;
}
