/* The kernels for dimensions that the compiler knows, as single calls for the machine that compiles them: all that depends on
 * dimensions alone is folded into constants. Compiled twice, with the sine of the C library and with that of the project (OWN_SINE). */
#define _GNU_SOURCE
#include <math.h>

#define KERNEL static inline __attribute__((always_inline, unused))
#ifdef OWN_SINE
#include "own_sine.h"
#define NAME(kernel) kernel##_own
#else
#include "sine.h"
#define NAME(kernel) kernel##_library
#endif

#include "kernels.c"
#include "space.c"

#define DEGREES * (3.14159265358979323846 / 180)
/* Those of the mechanisms in src/mechanisms.rs and src/space.rs: the benchmark compares the results. */
#define K1 50, 120, 100, 140, 0, 70, 25 DEGREES
#define K2 5, 150, 112.5, 3.5, 5, 46.5, 123, 13.5, 10, 160, 122.5, -62.5 DEGREES
#define K3 50, 150, 90, 130, 40, 30, 65 DEGREES, -70 DEGREES
#define K4 120, 150, 320, 45

#define FOLDED(kernel, constants, ...)                                                          \
    void NAME(kernel)(double phi, double *restrict out)                                         \
    {                                                                                           \
        struct constants k;                                                                     \
        constants##_prepare(&k, __VA_ARGS__);                                                   \
        kernel(&k, phi, out);                                                                   \
    }

#define FOLDED_OF_THREE(kernel, constants, ...)                                                 \
    void NAME(kernel)(double x, double y, double z, double *restrict out)                       \
    {                                                                                           \
        struct constants k;                                                                     \
        constants##_prepare(&k, __VA_ARGS__);                                                   \
        kernel(&k, x, y, z, out);                                                               \
    }

FOLDED(k1a, k1, K1)
FOLDED(k1b, k1, K1)
FOLDED(k1c, k1, K1)
FOLDED(k2a, k2, K2)
FOLDED(k2b, k2, K2)
FOLDED(k2c, k2, K2)
FOLDED(k3a, k3, K3)
FOLDED(k3b, k3, K3)
FOLDED(k3c, k3, K3)
FOLDED_OF_THREE(k4a, k4, K4)
FOLDED_OF_THREE(k4b, k4, K4)
FOLDED_OF_THREE(k4c, k4, K4)
