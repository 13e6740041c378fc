/* The sine and cosine of the C library, for single calls. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <math.h>
#ifndef KERNEL
#define KERNEL
#endif

static inline void sine_cosine(double x, double *s, double *c)
{
#ifdef __GLIBC__
    sincos(x, s, c);
#else
    *s = sin(x);
    *c = cos(x);
#endif
}
