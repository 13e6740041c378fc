/* The nearest integer. */
INLINE real own_whole(real x)
{
    return (x + ROUND) - ROUND;
}
