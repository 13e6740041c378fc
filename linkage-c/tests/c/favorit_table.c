/* The hook-needle drive against its published tables: 63 columns of 25 rows. The argument is the file of the tables. */
#include "favorit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;
/* The machine's 1000 revolutions per minute were taken for degrees per second; rates are printed in hundredths of a millimetre. */
static const double speed = -1000.0 * 6.0 * (3.14159265358979323846 / 180) * (3.14159265358979323846 / 180);

/* A number of the publication: position, velocity, acceleration of a point's component or of an angle, by the first letter. */
static double of_kind(char kind, double value, double v, double a)
{
    return kind == 'V' || kind == 'o' ? 100 * speed * v : kind == 'A' || kind == 'e' ? 100 * speed * speed * a : value;
}

#define POINT(n) \
    if (strcmp(name + 1, #n "X") == 0) return of_kind(name[0], m.p##n.x, m.v##n.x, m.a##n.x); \
    if (strcmp(name + 1, #n "Y") == 0) return of_kind(name[0], m.p##n.y, m.v##n.y, m.a##n.y);
#define ANGLE(n) \
    if (strcmp(name + strcspn(name, "0123456789"), #n) == 0) return of_kind(name[0], m.phi##n / degree, m.om##n, m.eps##n);

static double computed(const char *name, favorit_motion_result m)
{
    POINT(2) POINT(3) POINT(5) POINT(6) POINT(8) POINT(9) POINT(10)
    ANGLE(23) ANGLE(43) ANGLE(45) ANGLE(56) ANGLE(78) ANGLE(89) ANGLE(910)
    return NAN;
}

int main(int count, char **arguments)
{
    const favorit_dimensions dimensions = FAVORIT_DEFAULTS;
    favorit drive;
    char line[1024];
    int columns = 0, row, wrong = 0;
    FILE *tables = count > 1 ? fopen(arguments[1], "r") : NULL;
    const int code = favorit_assemble(&drive, &dimensions);
    if (code != FAVORIT_OK || tables == NULL) return printf("%s\n", favorit_error(code)), 1;
    while (fgets(line, sizeof line, tables) != NULL) {
        const char *name = strtok(line, ",");
        if (name[0] == '#' || strcmp(name, "label") == 0) continue;
        strtok(NULL, ",");
        for (row = 0; row < 25; row++) {
            /* Row i belongs to -90 + 150 i degrees; two turns are one cycle. */
            const double phi = (fmod(150.0 * row, 720) - 90) * degree;
            double off = computed(name, favorit_motion(&drive, (REAL)phi)) - atof(strtok(NULL, ","));
            if (strncmp(name, "phi", 3) == 0) off -= 360 * floor(off / 360 + 0.5);
            /* Rounded to two digits, and what single precision makes of accelerations. */
            if (!(fabs(off) <= 0.005 + 1e-9 + SLACK)) wrong++, printf("%s, row %d: off by %g\n", name, row, off);
        }
        columns++;
    }
    fclose(tables);
    printf("%d columns, %d numbers wrong\n", columns, wrong);
    return columns != 63 || wrong != 0;
}
