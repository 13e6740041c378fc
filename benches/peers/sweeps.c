/* The kernels as sweeps into columns that the compiler makes vector code of: what can be reached by hand.
 * The sine and cosine are those of the project. Compiled once for each instruction set; SUFFIX tells the names apart. */
#define _GNU_SOURCE
#include <math.h>
#include <string.h>

#define KERNEL static inline __attribute__((always_inline, unused))

#include "own_sine.h"
#include "kernels.c"
#include "space.c"

/* Without the pragma the rows of the largest kernel stay a loop, and nothing becomes vector code. */
#define LANES 8
#define PASTE(a, b) a##b
#define NAME(a, b) PASTE(a, b)

/* n is a multiple of LANES; a column begins every `distance` numbers. */
#define SWEEP(kernel, constants, width)                                                         \
    void NAME(kernel##_sweep, SUFFIX)(const struct constants *restrict k,                        \
                                      const double *restrict phi, size_t n,                      \
                                      double *restrict columns, size_t distance)                 \
    {                                                                                            \
        const struct constants local = *k;                                                       \
        for (size_t start = 0; start < n; start += LANES) {                                      \
            double block[width][LANES];                                                          \
            for (int lane = 0; lane < LANES; lane++) {                                           \
                double out[width];                                                               \
                kernel(&local, phi[start + lane], out);                                          \
                _Pragma("GCC unroll 32")                                                         \
                for (int j = 0; j < width; j++)                                                  \
                    block[j][lane] = out[j];                                                     \
            }                                                                                    \
            for (int j = 0; j < width; j++)                                                      \
                memcpy(columns + j * distance + start, block[j], sizeof block[j]);               \
        }                                                                                        \
    }

/* The same for three inputs. */
#define SWEEP_OF_THREE(kernel, constants, width)                                                \
    void NAME(kernel##_sweep, SUFFIX)(const struct constants *restrict k,                        \
                                      const double *restrict x, const double *restrict y,        \
                                      const double *restrict z, size_t n,                        \
                                      double *restrict columns, size_t distance)                 \
    {                                                                                            \
        const struct constants local = *k;                                                       \
        for (size_t start = 0; start < n; start += LANES) {                                      \
            double block[width][LANES];                                                          \
            for (int lane = 0; lane < LANES; lane++) {                                           \
                double out[width];                                                               \
                kernel(&local, x[start + lane], y[start + lane], z[start + lane], out);          \
                _Pragma("GCC unroll 64")                                                         \
                for (int j = 0; j < width; j++)                                                  \
                    block[j][lane] = out[j];                                                     \
            }                                                                                    \
            for (int j = 0; j < width; j++)                                                      \
                memcpy(columns + j * distance + start, block[j], sizeof block[j]);               \
        }                                                                                        \
    }

SWEEP(k1a, k1, 2)
SWEEP(k1b, k1, 6)
SWEEP(k1c, k1, 16)
SWEEP(k2a, k2, 2)
SWEEP(k2b, k2, 6)
SWEEP(k2c, k2, 26)
SWEEP(k3a, k3, 3)
SWEEP(k3b, k3, 11)
SWEEP(k3c, k3, 27)
SWEEP_OF_THREE(k4a, k4, 3)
SWEEP_OF_THREE(k4b, k4, 12)
SWEEP_OF_THREE(k4c, k4, 39)
