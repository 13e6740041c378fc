/* The bits of a number, and the number of bits; by a union, since memcpy would be a call for some compilers. */
typedef union own_either { real number; word bits; } own_either;

static inline word own_bits(real number)
{
    own_either either;
    either.number = number;
    return either.bits;
}

static inline real own_number(word bits)
{
    own_either either;
    either.bits = bits;
    return either.number;
}
