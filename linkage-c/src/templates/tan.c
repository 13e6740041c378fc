static inline real own_tan(real x)
{
    const own_pair pair = own_sin_cos(x);
    return pair.sine / pair.cosine;
}
