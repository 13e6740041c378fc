/* An angle that is followed along one input: the inputs, of which that one changes, and the angle's value where it starts. */
typedef struct own_path { const MECHANISM *m; real *x; int input, angle; real reference, estimate; } own_path;

/* A position of the input, and the angle there; NaN where there is none. */
typedef struct own_place { real x, angle; } own_place;

/* How far an angle strays from a line of a given rate. */
typedef struct own_stray { real rate, least, most; } own_stray;

static own_stray own_stray_from(real rate)
{
    own_stray own;
    own.rate = rate;
    own.least = (real)INFINITY;
    own.most = -(real)INFINITY;
    return own;
}

static real own_width(const own_stray *own)
{
    return 0.5 * (own->most - own->least);
}

static void own_include(own_stray *strays, int count, own_place at)
{
    int k;
    for (k = 0; k < count; k++) {
        const real rest = at.angle - strays[k].rate * at.x;
        strays[k].least = rest < strays[k].least ? rest : strays[k].least;
        strays[k].most = rest > strays[k].most ? rest : strays[k].most;
    }
}

/* Whether another line is better: among those that the angle strays little from a whole rate, which serves beyond the range, too, then
   the slower one; else the one that it strays less from. */
static int own_better(const own_stray *other, const own_stray *own)
{
    const real mine = own_width(own);
    const real its = own_width(other);
    const int whole = own_whole(own->rate) == own->rate;
    const int its_whole = own_whole(other->rate) == other->rate;
    const real faster = fabs(other->rate) - fabs(own->rate);
    if (mine < COMFORT && its < COMFORT) {
        if (whole != its_whole) return !whole;
        return faster < 0.0 || (faster == 0.0 && its < mine);
    }
    if (mine < COMFORT) return 0;
    return its < COMFORT || its < mine;
}

/* The angle at x that is nearest to guide; NaN where there is none. */
static real own_near(const own_path *path, real x, real guide)
{
    real vectors[DIRECTIONS], cosine, sine, turn;
    path->x[path->input] = x;
    own_directions(path->m, path->x, vectors);
    cosine = vectors[2 * path->angle];
    sine = vectors[2 * path->angle + 1];
    if (own_infinite(cosine) || own_infinite(sine) || (cosine == 0.0 && sine == 0.0)) return own_nan();
    turn = own_atan2(sine, cosine) - guide;
    return guide + (turn - TURN * own_whole(turn / TURN));
}

/* A step towards target, halved while the angle turns by much: the nearest of the angles that fit is the one that was meant. */
static own_place own_advance(const own_path *path, own_place from, real target)
{
    own_place next;
    int halvings;
    next.x = target;
    next.angle = own_near(path, target, from.angle);
    for (halvings = 0; halvings < 30; halvings++) {
        const real middle = from.x + 0.5 * (next.x - from.x);
        if (fabs(next.angle - from.angle) <= 0.5 || middle == from.x || middle == next.x) break;
        next.x = middle;
        next.angle = own_near(path, middle, from.angle);
    }
    return next;
}

/* Follows the angle from the reference to one end, as far as it exists. */
static own_place own_one_way(const own_path *path, real end, real step, real angle, own_stray *strays, int count)
{
    const real run = end - path->reference;
    const int steps = step > 0.0 ? (int)(fabs(run) / step) + 1 : 1;
    own_place last;
    int k;
    last.x = path->reference;
    last.angle = angle;
    own_include(strays, count, last);
    for (k = 1; k <= steps; k++) {
        const real target = k == steps ? end : path->reference + run * ((real)k / (real)steps);
        while (last.x != target) {
            const own_place next = own_advance(path, last, target);
            if (next.angle != next.angle) return last;
            last = next;
            own_include(strays, count, last);
        }
    }
    return last;
}

/* Follows the angle to both ends; its mean slope, NaN if it does not exist at the reference. */
static real own_walk(const own_path *path, real low, real high, real step, own_stray *strays, int count)
{
    const real angle = own_near(path, path->reference, path->estimate);
    own_place lower, upper;
    if (angle != angle) return angle;
    lower = own_one_way(path, low, step, angle, strays, count);
    upper = own_one_way(path, high, step, angle, strays, count);
    return upper.x > lower.x ? (upper.angle - lower.angle) / (upper.x - lower.x) : 0.0;
}

/* The line of one of these rates, or of the mean slope, from which the angle strays by less than half a turn over the range. Returns 0 if there is
   none. */
static int own_follow(const own_path *path, real low, real high, const real *rates, int count, own_stray *best)
{
    own_stray strays[RATES];
    real fastest = 0.0, step, slope;
    int k;
    for (k = 0; k < count; k++) {
        fastest = fabs(rates[k]) > fastest ? fabs(rates[k]) : fastest;
        strays[k] = own_stray_from(rates[k]);
    }
    /* Thousands of turns are not followed. */
    if ((high - low) * fastest > 16384.0) return 0;
    /* A part of the range, short enough that the fastest rate turns by a quarter radian. */
    step = 0.25 / (fastest > 1.0 ? fastest : 1.0);
    step = (high - low) / 256.0 < step ? (high - low) / 256.0 : step;
    step = (high - low) / 65536.0 > step ? (high - low) / 65536.0 : step;
    slope = own_walk(path, low, high, step, strays, count);
    if (slope != slope) return 0;
    *best = own_stray_from(slope);
    if (count > 0) *best = strays[0];
    for (k = 1; k < count; k++) {
        if (own_better(&strays[k], best)) *best = strays[k];
    }
    if (count == 0 || own_width(best) >= MOST_STRAY) {
        *best = own_stray_from(slope);
        own_walk(path, low, high, step, best, 1);
    }
    return own_width(best) < MOST_STRAY;
}
