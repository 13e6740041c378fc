/* The kernels as an engineer writes them for speed: unit vectors, closed-form dyads, loops
 * differentiated by hand, what depends on dimensions alone computed beforehand, and the sine and
 * cosine of the C library.
 *
 * Vectors are complex numbers: x + i y; "turned" means multiplied by i.
 *
 * sweeps.c includes this file with another sine and cosine and with KERNEL set to "static inline".
 */
#ifndef KERNEL
#include "sine.h"
#endif

/* K1: crank a on the origin, coupler b, rocker c on the pivot d; the tracer is carried by the
 * coupler, p from the crank pin and turned by u against the coupler. The coupler-rocker pin lies to
 * the left of the line from crank pin to pivot. */
struct k1 {
    double a, b, c, p, dx, dy;
    double bb;     /* b^2 */
    double k;      /* (b^2 - c^2) / 2 */
    double aa;     /* a^2 */
    double zx, zy; /* tracer over coupler: p / b at the angle u */
    double rb, rp; /* 1 / b, 1 / p */
};

KERNEL void k1_prepare(struct k1 *k, double a, double b, double c, double dx, double dy, double p,
                double u)
{
    k->a = a;
    k->b = b;
    k->c = c;
    k->p = p;
    k->dx = dx;
    k->dy = dy;
    k->bb = b * b;
    k->k = (b - c) * (b + c) / 2;
    k->aa = a * a;
    k->zx = p * cos(u) / b;
    k->zy = p * sin(u) / b;
    k->rb = 1 / b;
    k->rp = 1 / p;
}

/* The dyad: crank direction (ux, uy) and pin (ax, ay), coupler e, rocker f, height h of the triangle
 * times its base, N = coupler . base, t = the tracer from the crank pin. */
#define K1_DYAD                                              \
    double uy, ux;                                           \
    sine_cosine(phi, &uy, &ux);                              \
    const double ax = k->a * ux, ay = k->a * uy;             \
    const double cx = k->dx - ax, cy = k->dy - ay;           \
    const double l2 = cx * cx + cy * cy;                     \
    const double n = 0.5 * l2 + k->k;                        \
    const double h = sqrt(k->bb * l2 - n * n);               \
    const double il2 = 1 / l2;                               \
    const double ex = (n * cx - h * cy) * il2;               \
    const double ey = (n * cy + h * cx) * il2;               \
    const double tx = k->zx * ex - k->zy * ey;               \
    const double ty = k->zx * ey + k->zy * ex;

KERNEL void k1a(const struct k1 *restrict k, double phi, double *restrict out)
{
    K1_DYAD
    out[0] = ax + tx;
    out[1] = ay + ty;
}

KERNEL void k1b(const struct k1 *restrict k, double phi, double *restrict out)
{
    K1_DYAD
    const double ih = 1 / h;
    const double fx = ex - cx, fy = ey - cy;
    const double w = (fx * ay - fy * ax) * ih;
    const double ww = w * w;
    const double e = (fx * ax + fy * ay - k->aa - ww * n - 2 * w * (ex * ax + ey * ay)) * ih;
    out[0] = ax + tx;
    out[1] = ay + ty;
    out[2] = -ay - w * ty;
    out[3] = ax + w * tx;
    out[4] = -ax - e * ty - ww * tx;
    out[5] = -ay + e * tx - ww * ty;
}

/* Sensitivities by a, b, c, dx, dy, p, u, each x and y. A dimension turns the coupler by so much. */
KERNEL void k1c(const struct k1 *restrict k, double phi, double *restrict out)
{
    K1_DYAD
    const double ih = 1 / h;
    const double fx = ex - cx, fy = ey - cy;
    const double wa = -(fx * ux + fy * uy) * ih;
    const double wb = (n * k->rb - k->b) * ih;
    const double wc = k->c * ih;
    const double wx = fx * ih, wy = fy * ih;
    out[0] = ax + tx;
    out[1] = ay + ty;
    out[2] = ux - wa * ty;
    out[3] = uy + wa * tx;
    out[4] = -wb * ty;
    out[5] = wb * tx;
    out[6] = -wc * ty;
    out[7] = wc * tx;
    out[8] = -wx * ty;
    out[9] = wx * tx;
    out[10] = -wy * ty;
    out[11] = wy * tx;
    out[12] = tx * k->rp;
    out[13] = ty * k->rp;
    out[14] = -ty;
    out[15] = tx;
}

/* K2: crank l12 on the origin, coupler l23, rocker l34 on p4; a guide fixed on the rocker, whose
 * direction is the rocker's turned by `guide` and which passes p4 at the distance `offset`; crank l78
 * on p7 at 15 degrees - phi / 2, rod l89 to the slider; the needle's point is l910 back along the
 * guide. */
struct k2 {
    double p4x, p4y, dx, dy; /* d = p7 - p4 */
    double l12, l23, l34, l89, l910;
    double a2;     /* l12^2 */
    double bb;     /* l23^2 */
    double k;      /* (l23^2 - l34^2) / 2 */
    double rr;     /* l89^2 */
    double gx, gy; /* guide direction over rocker vector */
    double qx, qy; /* l78 at 15 degrees */
    double r78, r34;
    double offset; /* guide direction x its pivot, from p4 */
    double slope;  /* d offset / d l45 */
};

KERNEL void k2_prepare(struct k2 *k, double p4x, double p4y, double p7x, double p7y, double l12, double l23,
                double l34, double l45, double l78, double l89, double l910, double angle_345)
{
    const double right = acos(-1) / 2, guide = angle_345 + right, start = right / 6;
    k->p4x = p4x;
    k->p4y = p4y;
    k->dx = p7x - p4x;
    k->dy = p7y - p4y;
    k->l12 = l12;
    k->l23 = l23;
    k->l34 = l34;
    k->l89 = l89;
    k->l910 = l910;
    k->a2 = l12 * l12;
    k->bb = l23 * l23;
    k->k = (l23 - l34) * (l23 + l34) / 2;
    k->rr = l89 * l89;
    k->gx = cos(guide) / l34;
    k->gy = sin(guide) / l34;
    k->qx = l78 * cos(start);
    k->qy = l78 * sin(start);
    k->r78 = 1 / l78;
    k->r34 = 1 / l34;
    k->offset = -l45;
    k->slope = -1;
}

/* First dyad: crank pin a, base c, rocker f, h and m as in K1; guide g. Second dyad: v = p8 - p7,
 * b = p8 - p4, y and x its parts along and across the guide, z the distance of p8 from the guide, s
 * half of the chord; t = the needle along the guide, from the foot of p4. One sine pair, of the half
 * angle, serves both cranks. */
#define K2_DYADS                                              \
    double hs, hc;                                            \
    sine_cosine(0.5 * phi, &hs, &hc);                         \
    const double ux = 1 - 2 * hs * hs, uy = 2 * hs * hc;      \
    const double ax = k->l12 * ux, ay = k->l12 * uy;          \
    const double cx = k->p4x - ax, cy = k->p4y - ay;          \
    const double l2 = cx * cx + cy * cy;                      \
    const double n = 0.5 * l2 + k->k, m = n - l2;             \
    const double h = sqrt(k->bb * l2 - n * n);                \
    const double il2 = 1 / l2;                                \
    const double fx = (m * cx + h * cy) * il2;                \
    const double fy = (m * cy - h * cx) * il2;                \
    const double gx = k->gx * fx - k->gy * fy;                \
    const double gy = k->gx * fy + k->gy * fx;                \
    const double vx = k->qx * hc + k->qy * hs;                \
    const double vy = k->qy * hc - k->qx * hs;                \
    const double bx = k->dx + vx, by = k->dy + vy;            \
    const double y = gx * bx + gy * by;                       \
    const double x = gx * by - gy * bx;                       \
    const double z = x - k->offset;                           \
    const double s = sqrt(k->rr - z * z);                     \
    const double t = y - s - k->l910;                         \
    const double rx = t * gx - k->offset * gy;                \
    const double ry = t * gy + k->offset * gx;

KERNEL void k2a(const struct k2 *restrict k, double phi, double *restrict out)
{
    K2_DYADS
    out[0] = k->p4x + rx;
    out[1] = k->p4y + ry;
}

KERNEL void k2b(const struct k2 *restrict k, double phi, double *restrict out)
{
    K2_DYADS
    const double ih = -1 / h, is = 1 / s;
    const double ex = fx + cx, ey = fy + cy;
    const double w = (ex * ay - ey * ax) * ih;
    const double ww = w * w;
    const double e = (ex * ax + ey * ay + k->a2 - ww * m - 2 * w * (fx * ax + fy * ay)) * ih;
    /* b' = -v turned / 2, b'' = -v / 4, along and across the guide. */
    const double gv = gx * vx + gy * vy, gxv = gx * vy - gy * vx;
    const double along = 0.5 * gxv, across = -0.5 * gv;
    const double y1 = along + w * x;
    const double x1 = across - w * y;
    const double y2 = -0.25 * gv + w * across + e * x + w * x1;
    const double x2 = -0.25 * gxv - w * along - e * y - w * y1;
    const double s1 = -z * x1 * is;
    const double s2 = -(x1 * x1 + z * x2 + s1 * s1) * is;
    const double t1 = y1 - s1, t2 = y2 - s2, v = 2 * w * t1;
    out[0] = k->p4x + rx;
    out[1] = k->p4y + ry;
    out[2] = t1 * gx - w * ry;
    out[3] = t1 * gy + w * rx;
    out[4] = t2 * gx - v * gy - e * ry - ww * rx;
    out[5] = t2 * gy + v * gx + e * rx - ww * ry;
}

/* Sensitivities by p4, p7, l12, l23, l34, l45, l78, l89, l910, angle_345, each x and y. */
KERNEL void k2c(const struct k2 *restrict k, double phi, double *restrict out)
{
    K2_DYADS
    const double ih = -1 / h, is = 1 / s;
    const double ex = fx + cx, ey = fy + cy;
    /* Per turn of the guide: (jx, jy). Per shift of p8: along g by its part along (kx, ky). */
    const double q = z * is;
    const double o = x - q * y;
    const double jx = o * gx - ry, jy = o * gy + rx;
    const double kx = gx - q * gy, ky = gy + q * gx;
    const double w4x = ex * ih, w4y = ey * ih;
    const double w12 = -(ex * ux + ey * uy) * ih;
    const double w23 = -k->l23 * ih;
    const double w34 = (k->l34 + m * k->r34) * ih;
    const double w78 = (vx * kx + vy * ky) * k->r78;
    const double w89 = -k->l89 * is;
    out[0] = k->p4x + rx;
    out[1] = k->p4y + ry;
    out[2] = 1 + w4x * jx - kx * gx;
    out[3] = w4x * jy - kx * gy;
    out[4] = w4y * jx - ky * gx;
    out[5] = 1 + w4y * jy - ky * gy;
    out[6] = kx * gx;
    out[7] = kx * gy;
    out[8] = ky * gx;
    out[9] = ky * gy;
    out[10] = w12 * jx;
    out[11] = w12 * jy;
    out[12] = w23 * jx;
    out[13] = w23 * jy;
    out[14] = w34 * jx;
    out[15] = w34 * jy;
    out[16] = -k->slope * (q * gx + gy);
    out[17] = -k->slope * (q * gy - gx);
    out[18] = w78 * gx;
    out[19] = w78 * gy;
    out[20] = w89 * gx;
    out[21] = w89 * gy;
    out[22] = -gx;
    out[23] = -gy;
    out[24] = jx;
    out[25] = jy;
}
