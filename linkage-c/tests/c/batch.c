#include <stdint.h>
#include <stdio.h>
#include <string.h>
/* INCLUDES */
/* FUNCTIONS */
static const struct { void (*run)(const REAL *, REAL *); size_t takes, gives; } functions[] = {
/* TABLE */
};

int main(void)
{
    static REAL in[1024], out[4096];
    uint64_t k;
    while (fread(&k, sizeof k, 1, stdin) == 1) {
        if (fread(in, sizeof *in, functions[k].takes, stdin) != functions[k].takes) return 1;
        functions[k].run(in, out);
        if (fwrite(out, sizeof *out, functions[k].gives, stdout) != functions[k].gives) return 1;
    }
    return 0;
}
