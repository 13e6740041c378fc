/* The kernels in space, written as those of kernels.c: textbook forms, differentiated by hand. Vectors
 * have components x, y, z.
 *
 * sweeps.c includes this file as it does kernels.c. */
#ifndef KERNEL
#include "sine.h"
#endif

/* K3, RSSR: crank a about the z axis, coupler l with ball joints, rocker r at the pivot p about the axis
 * k = (sin t cos z, sin t sin z, cos t). The rocker's angle counts from e = dk/dt, f = k x e. */
struct k3 {
    double a, l, r;
    double px, py, pz;
    double kx, ky, kz, ex, ey, ez, fx, fy;
    double gx, gy, gz, hx, hy; /* r e, r f */
    double ax, ay, a0;         /* the equation's coefficients: a0 + ax cos + ay sin, */
    double bx, by, b0;
    double cx, cy, c0;
};

KERNEL void k3_prepare(struct k3 *k, double a, double l, double r, double px, double py, double pz,
                double t, double z)
{
    k->a = a;
    k->l = l;
    k->r = r;
    k->px = px;
    k->py = py;
    k->pz = pz;
    k->kx = sin(t) * cos(z);
    k->ky = sin(t) * sin(z);
    k->kz = cos(t);
    k->ex = cos(t) * cos(z);
    k->ey = cos(t) * sin(z);
    k->ez = -sin(t);
    k->fx = -sin(z);
    k->fy = cos(z);
    k->gx = r * k->ex;
    k->gy = r * k->ey;
    k->gz = r * k->ez;
    k->hx = r * k->fx;
    k->hy = r * k->fy;
    k->ax = -a * k->gx;
    k->ay = -a * k->gy;
    k->a0 = k->gx * px + k->gy * py + k->gz * pz;
    k->bx = -a * k->hx;
    k->by = -a * k->hy;
    k->b0 = k->hx * px + k->hy * py;
    k->cx = a * px;
    k->cy = a * py;
    k->c0 = (l * l - r * r - a * a - px * px - py * py - pz * pz) / 2;
}

/* A cos psi + B sin psi = C, the left side's derivative by psi being -h; the end at p + (sx, sy, sz). */
#define K3_LINK                                              \
    double ys, yc;                                           \
    sine_cosine(phi, &ys, &yc);                              \
    const double a1 = k->ax * yc + k->ay * ys, a = k->a0 + a1; \
    const double b1 = k->bx * yc + k->by * ys, b = k->b0 + b1; \
    const double c1 = k->cx * yc + k->cy * ys, c = k->c0 + c1; \
    const double l2 = a * a + b * b;                         \
    const double h = sqrt(l2 - c * c);                       \
    const double il2 = 1 / l2;                               \
    const double uc = (a * c - b * h) * il2;                 \
    const double us = (b * c + a * h) * il2;                 \
    const double sx = k->gx * uc + k->hx * us;               \
    const double sy = k->gy * uc + k->hy * us;               \
    const double sz = k->gz * uc;

/* The end, turned by 90 degrees about the axis. */
#define K3_TURNED                                            \
    const double tx = k->hx * uc - k->gx * us;               \
    const double ty = k->hy * uc - k->gy * us;               \
    const double tz = -k->gz * us;

KERNEL void k3a(const struct k3 *restrict k, double phi, double *restrict out)
{
    K3_LINK
    out[0] = k->px + sx;
    out[1] = k->py + sy;
    out[2] = k->pz + sz;
}

/* The end with both derivatives, and those of psi. */
KERNEL void k3b(const struct k3 *restrict k, double phi, double *restrict out)
{
    K3_LINK
    K3_TURNED
    const double ih = -1 / h;
    const double a2 = k->ay * yc - k->ax * ys;
    const double b2 = k->by * yc - k->bx * ys;
    const double c2 = k->cy * yc - k->cx * ys;
    const double w = (c2 - a2 * uc - b2 * us) * ih;
    const double ww = w * w;
    const double e = (a1 * uc + b1 * us - c1 + 2 * w * (a2 * us - b2 * uc) + ww * c) * ih;
    out[0] = k->px + sx;
    out[1] = k->py + sy;
    out[2] = k->pz + sz;
    out[3] = w * tx;
    out[4] = w * ty;
    out[5] = w * tz;
    out[6] = e * tx - ww * sx;
    out[7] = e * ty - ww * sy;
    out[8] = e * tz - ww * sz;
    out[9] = w;
    out[10] = e;
}

/* Sensitivities of the end by a, l, r, px, py, pz, t, z, each x, y and z. A dimension turns the rocker
 * by its component along the coupler (lx, ly, lz) over h. */
KERNEL void k3c(const struct k3 *restrict k, double phi, double *restrict out)
{
    K3_LINK
    K3_TURNED
    const double ih = 1 / h;
    const double lx = k->px - k->a * yc + sx;
    const double ly = k->py - k->a * ys + sy;
    const double lz = k->pz + sz;
    const double wx = k->ex * uc + k->fx * us;
    const double wy = k->ey * uc + k->fy * us;
    const double wz = k->ez * uc;
    const double qa = -(lx * yc + ly * ys) * ih;
    const double ql = -k->l * ih;
    const double qr = (lx * wx + ly * wy + lz * wz) * ih;
    const double qx = lx * ih, qy = ly * ih, qz = lz * ih;
    const double ruc = k->r * uc;
    const double qt = -ruc * (k->kx * lx + k->ky * ly + k->kz * lz) * ih;
    const double qz0 = (sx * ly - sy * lx) * ih;
    out[0] = k->px + sx;
    out[1] = k->py + sy;
    out[2] = k->pz + sz;
    out[3] = qa * tx;
    out[4] = qa * ty;
    out[5] = qa * tz;
    out[6] = ql * tx;
    out[7] = ql * ty;
    out[8] = ql * tz;
    out[9] = wx + qr * tx;
    out[10] = wy + qr * ty;
    out[11] = wz + qr * tz;
    out[12] = 1 + qx * tx;
    out[13] = qx * ty;
    out[14] = qx * tz;
    out[15] = qy * tx;
    out[16] = 1 + qy * ty;
    out[17] = qy * tz;
    out[18] = qz * tx;
    out[19] = qz * ty;
    out[20] = 1 + qz * tz;
    out[21] = qt * tx - ruc * k->kx;
    out[22] = qt * ty - ruc * k->ky;
    out[23] = qt * tz - ruc * k->kz;
    out[24] = qz0 * tx - sy;
    out[25] = qz0 * ty + sx;
    out[26] = qz0 * tz;
}

/* K4, the delta robot: three arms of length a that turn about tangents of a circle of radius b in the plane
 * z = 0, at 0, 120 and 240 degrees, upwards positive angles downwards; three forearms l to a platform
 * of radius p, whose centre is wanted, below the elbows. */
struct k4 {
    double a, b, ll; /* arm, base - platform, forearm^2 */
};

KERNEL void k4_prepare(struct k4 *k, double base, double arm, double forearm, double platform)
{
    k->a = arm;
    k->b = base - platform;
    k->ll = forearm * forearm;
}

#define HALF_ROOT_3 0.86602540378443864676

/* The elbows e1, e2 = e1 + u, e3 = e1 + v, moved inwards by the platform's radius; n = u x v; the first
 * forearm (x1, y1, z1) ends in the centre of the platform: the centre of the circle through the elbows,
 * and rise n below. */
#define K4_TRILATERATION                                     \
    double s1, c1, s2, c2, s3, c3;                           \
    sine_cosine(phi1, &s1, &c1);                             \
    sine_cosine(phi2, &s2, &c2);                             \
    sine_cosine(phi3, &s3, &c3);                             \
    const double r1 = k->b + k->a * c1, r2 = k->b + k->a * c2, r3 = k->b + k->a * c3; \
    const double ez = -k->a * s1;                            \
    const double ux = -0.5 * r2 - r1, uy = HALF_ROOT_3 * r2; \
    const double vx = -0.5 * r3 - r1, vy = -HALF_ROOT_3 * r3; \
    const double uz = -k->a * s2 - ez, vz = -k->a * s3 - ez; \
    const double nx = uy * vz - uz * vy;                     \
    const double ny = uz * vx - ux * vz;                     \
    const double nz = ux * vy - uy * vx;                     \
    const double nn = nx * nx + ny * ny + nz * nz;           \
    const double uu = ux * ux + uy * uy + uz * uz;           \
    const double vv = vx * vx + vy * vy + vz * vz;           \
    const double uv = ux * vx + uy * vy + uz * vz;           \
    const double inn = 1 / nn;                               \
    const double f = 0.5 * inn * vv * (uu - uv);             \
    const double g = 0.5 * inn * uu * (vv - uv);             \
    const double rr = 0.25 * uu * vv * (uu + vv - 2 * uv) * inn; \
    const double rise = sqrt((k->ll - rr) * inn);            \
    const double x1 = f * ux + g * vx - rise * nx;           \
    const double y1 = f * uy + g * vy - rise * ny;           \
    const double z1 = f * uz + g * vz - rise * nz;

KERNEL void k4a(const struct k4 *restrict k, double phi1, double phi2, double phi3,
                double *restrict out)
{
    K4_TRILATERATION
    out[0] = r1 + x1;
    out[1] = y1;
    out[2] = ez + z1;
}

/* L2 = L1 - u and L3 = L1 - v are the other forearms. An arm moves its elbow by m along its forearm, so that the
 * point moves along the cross product F of the other two forearms; these add up to n, and their
 * determinant is -rise nn. */
#define K4_JACOBIAN                                          \
    const double x2 = x1 - ux, y2 = y1 - uy, z2 = z1 - uz;   \
    const double x3 = x1 - vx, y3 = y1 - vy, z3 = z1 - vz;   \
    const double fx2 = y1 * vz - z1 * vy, fy2 = z1 * vx - x1 * vz, fz2 = x1 * vy - y1 * vx; \
    const double fx3 = z1 * uy - y1 * uz, fy3 = x1 * uz - z1 * ux, fz3 = y1 * ux - x1 * uy; \
    const double fx1 = nx - fx2 - fx3, fy1 = ny - fy2 - fy3, fz1 = nz - fz2 - fz3; \
    const double id = 1 / (rise * nn), m = k->a * id;        \
    const double o2 = HALF_ROOT_3 * y2 - 0.5 * x2;           \
    const double o3 = -HALF_ROOT_3 * y3 - 0.5 * x3;          \
    const double m1 = m * (s1 * x1 + c1 * z1);               \
    const double m2 = m * (s2 * o2 + c2 * z2);               \
    const double m3 = m * (s3 * o3 + c3 * z3);               \
    const double jx1 = m1 * fx1, jy1 = m1 * fy1, jz1 = m1 * fz1; \
    const double jx2 = m2 * fx2, jy2 = m2 * fy2, jz2 = m2 * fz2; \
    const double jx3 = m3 * fx3, jy3 = m3 * fy3, jz3 = m3 * fz3; \
    out[0] = r1 + x1;                                        \
    out[1] = y1;                                             \
    out[2] = ez + z1;                                        \
    out[3] = jx1;                                            \
    out[4] = jy1;                                            \
    out[5] = jz1;                                            \
    out[6] = jx2;                                            \
    out[7] = jy2;                                            \
    out[8] = jz2;                                            \
    out[9] = jx3;                                            \
    out[10] = jy3;                                           \
    out[11] = jz3;

/* The centre and its derivatives by the three angles. */
KERNEL void k4b(const struct k4 *restrict k, double phi1, double phi2, double phi3,
                double *restrict out)
{
    K4_TRILATERATION
    K4_JACOBIAN
}

/* The second derivative by angles i and j: what the centre's velocities miss of each forearm's circle. */
#define K4_SECOND(i, j, at, more)                            \
    {                                                        \
        const double g = jx##i * jx##j + jy##i * jy##j + jz##i * jz##j; \
        const double hx = g * wx + more(x, i, j);            \
        const double hy = g * wy + more(y, i, j);            \
        const double hz = g * wz + more(z, i, j);            \
        out[at] = hx;                                        \
        out[at + 1] = hy;                                    \
        out[at + 2] = hz;                                    \
    }
#define K4_SAME(x, i, j) q##i##i * f##x##i
#define K4_MIXED(x, i, j) q##i##j * f##x##i + q##j##i * f##x##j
#define K4_COPY(from, to) out[to] = out[from], out[to + 1] = out[from + 1], out[to + 2] = out[from + 2]

/* The centre with its first derivatives and all 3 x 3 second ones. */
KERNEL void k4c(const struct k4 *restrict k, double phi1, double phi2, double phi3,
                double *restrict out)
{
    K4_TRILATERATION
    K4_JACOBIAN
    const double wx = nx * id, wy = ny * id, wz = nz * id;
    /* q_ij: what elbow i's velocity along that of the centre by angle j adds along the forearm, over the
     * determinant; q_ii with the forearm's share of the elbow's acceleration. */
    const double t2x = -0.5 * s2, t2y = HALF_ROOT_3 * s2, t3x = -0.5 * s3, t3y = -HALF_ROOT_3 * s3;
    const double q12 = m * (s1 * jx2 + c1 * jz2), q13 = m * (s1 * jx3 + c1 * jz3);
    const double q21 = m * (t2x * jx1 + t2y * jy1 + c2 * jz1);
    const double q23 = m * (t2x * jx3 + t2y * jy3 + c2 * jz3);
    const double q31 = m * (t3x * jx1 + t3y * jy1 + c3 * jz1);
    const double q32 = m * (t3x * jx2 + t3y * jy2 + c3 * jz2);
    const double q11 = m * (2 * (s1 * jx1 + c1 * jz1) + k->a + c1 * x1 - s1 * z1);
    const double q22 = m * (2 * (t2x * jx2 + t2y * jy2 + c2 * jz2) + k->a + c2 * o2 - s2 * z2);
    const double q33 = m * (2 * (t3x * jx3 + t3y * jy3 + c3 * jz3) + k->a + c3 * o3 - s3 * z3);
    K4_SECOND(1, 1, 12, K4_SAME)
    K4_SECOND(1, 2, 15, K4_MIXED)
    K4_SECOND(1, 3, 18, K4_MIXED)
    K4_SECOND(2, 2, 24, K4_SAME)
    K4_SECOND(2, 3, 27, K4_MIXED)
    K4_SECOND(3, 3, 36, K4_SAME)
    K4_COPY(15, 21);
    K4_COPY(18, 30);
    K4_COPY(27, 33);
}
