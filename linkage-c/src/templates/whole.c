/* The nearest integer. */
static inline real own_whole(real x)
{
    return (x + ROUND) - ROUND;
}
