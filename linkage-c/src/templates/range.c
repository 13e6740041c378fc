/* How far a group is from its dead point at a position of the input. */
typedef struct own_range_level {
    real level;
    int known; /* whether all groups before it close */
} own_range_level;

/* The group that is looked at, with what its slack is divided by. */
typedef struct own_range_search {
    const MECHANISM *m;
    real x[INPUTS];
    real scale[GROUPS];
    int group;
} own_range_search;

/* The slacks of all groups at a position of the input. That of a group with a table is 1, NaN where nothing is prepared. */
static void own_range_slacks_at(own_range_search *s, real at, real *slacks)
{
    static const int tables[] = TABLES;
    const real first = LOW + END * (HIGH - LOW), last = HIGH - END * (HIGH - LOW);
    int k, defined = 1;
    s->x[INPUT] = at;
    own_range_slacks(s->m, s->x, slacks);
    for (k = 0; k < GROUPS; k++) defined = defined && slacks[k] == slacks[k];
    if (!defined && !(at > first && at < last)) {
        /* An arc function may reach the end of its range at that of the input's, apart from rounding. */
        s->x[INPUT] = at > first ? last : first;
        own_range_slacks(s->m, s->x, slacks);
    }
    for (k = 0; k < GROUPS; k++) {
        if (!tables[k]) slacks[k] /= s->scale[k];
        else if (slacks[k] == slacks[k]) slacks[k] = 1.0;
    }
}

static own_range_level own_range_level_at(own_range_search *s, real at)
{
    real slacks[GROUPS];
    own_range_level found;
    int k;
    own_range_slacks_at(s, at, slacks);
    found.known = 1;
    for (k = 0; k < s->group; k++) if (!(slacks[k] >= -ROUNDING)) found.known = 0;
    found.level = slacks[s->group];
    if (at - LOW > END * (HIGH - LOW) && HIGH - at > END * (HIGH - LOW)) found.level -= DEAD;
    return found;
}

static int own_range_works(own_range_level own) { return own.known && own.level >= -ROUNDING; }
static int own_range_fails(own_range_level own) { return own.known && !(own.level >= -ROUNDING); }

/* Where it stops working between a place that works and one that does not. */
static real own_range_edge(own_range_search *s, real works, real broken)
{
    int k;
    for (k = 0; k < 64; k++) {
        const real middle = 0.5 * (works + broken);
        const own_range_level own = own_range_level_at(s, middle);
        if (own.known && own.level > 0.0) works = middle;
        else broken = middle;
    }
    return broken;
}

/* By how much the group misses closing, at least 0. */
static real own_range_miss(own_range_search *s, real at)
{
    real gaps[GROUPS];
    s->x[INPUT] = at;
    own_gaps(s->m, s->x, gaps);
    return gaps[s->group] > 0.0 ? gaps[s->group] : 0.0;
}

/* What is searched for a lowest place: a level, its negative, or the negative miss. */
static real own_range_depth(own_range_search *s, int what, real at)
{
    own_range_level own;
    if (what == 2) return -own_range_miss(s, at);
    own = own_range_level_at(s, at);
    /* The search for a hill among places that fail does not end at what is no number. */
    if (!own.known || (what == 1 && own.level != own.level)) return LARGEST;
    return what == 1 ? -own.level : own.level;
}

/* The lowest place between two: golden sections. */
static real own_range_lowest(own_range_search *s, int what, real low, real high)
{
    const real golden = 0.6180339887498949;
    real left = high - golden * (high - low), right = low + golden * (high - low);
    real at_left = own_range_depth(s, what, left), at_right = own_range_depth(s, what, right);
    real best = at_left <= at_right ? left : right, least = at_left <= at_right ? at_left : at_right;
    int k;
    for (k = 0; k < 70 && left < right; k++) {
        if (at_left != at_left) return left;
        if (at_right != at_right) return right;
        if (at_left <= at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - golden * (high - low);
            at_left = own_range_depth(s, what, left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + golden * (high - low);
            at_right = own_range_depth(s, what, right);
        }
        if (at_left <= least) {
            best = left;
            least = at_left;
        }
        if (at_right <= least) {
            best = right;
            least = at_right;
        }
    }
    return best;
}

/* The position of a sample, the reference being one of them. */
static real own_range_place(int k)
{
    if (k <= BELOW) return BELOW == 0 ? LOW : LOW + (REFERENCE - LOW) * ((real)k / (real)(BELOW == 0 ? 1 : BELOW));
    if (k >= BELOW + ABOVE) return HIGH;
    return REFERENCE + (HIGH - REFERENCE) * ((real)(k - BELOW) / (real)(ABOVE == 0 ? 1 : ABOVE));
}

static real own_range_snapped(real x)
{
    if (fabs(x - LOW) < AT_END * (HIGH - LOW)) return LOW;
    if (fabs(HIGH - x) < AT_END * (HIGH - LOW)) return HIGH;
    return x;
}

/* Writes what a stretch is that does not work; how many findings there are then. */
static int own_range_add(own_range_search *s, FINDING *findings, int room, int count, real from, real to, int works, int finite)
{
    static const int single[] = SINGLE;
    const real step = (to - from) / 180.0;
    const real low = from - (to - from) < LOW ? LOW : from - (to - from);
    const real high = to + (to - from) > HIGH ? HIGH : to + (to - from);
    const real lowest = own_range_lowest(s, 0, low, high);
    const int touches = own_range_level_at(s, lowest).level > -2.0 * DEAD;
    real at = from;
    FINDING own;
    int k;
    own.group = s->group;
    own.miss = 0.0;
    /* A slack that is negative by no more than rounding touches zero. */
    for (k = 0; k <= 180 && !touches; k++) {
        const real next = from + step * (real)k, miss = own_range_miss(s, next);
        if (miss > own.miss) {
            own.miss = miss;
            at = next;
        }
    }
    if (own.miss > 0.0) {
        const real miss = own_range_miss(s, own_range_lowest(s, 2, at - step < from ? from : at - step, at + step > to ? to : at + step));
        if (miss > own.miss) own.miss = miss;
    }
    if (!finite) own.kind = UNDEFINED;
    else if (own.miss > 0.0) own.kind = works ? GAP : DEAD_POINT;
    else own.kind = single[s->group] ? DEAD_POINT : CHANGE_POINT;
    if (own.kind == CHANGE_POINT) from = lowest;
    if (finite && !(own.miss > 0.0)) to = from;
    own.from = own_range_snapped(from);
    own.to = own_range_snapped(to);
    /* Without a range, to end at a dead point is no mistake, and the ends of a turn are one position. */
    if (!DECLARED && (own.kind != CHANGE_POINT || own.from == HIGH)) return count;
    if (count < room) findings[count] = own;
    return count + 1;
}

static void own_range_measure(own_range_search *s)
{
    static const int relative[] = RELATIVE, single[] = SINGLE;
    real slacks[GROUPS], largest[GROUPS];
    int g, k;
    for (g = 0; g < GROUPS; g++) {
        s->scale[g] = 1.0;
        largest[g] = 0.0;
    }
    for (k = 0; k <= BELOW + ABOVE; k++) {
        own_range_slacks_at(s, own_range_place(k), slacks);
        for (g = 0; g < GROUPS; g++) if (fabs(slacks[g]) > largest[g]) largest[g] = fabs(slacks[g]);
    }
    own_range_slacks_at(s, REFERENCE, slacks);
    for (g = 0; g < GROUPS; g++) {
        if (!relative[g] || !(largest[g] > 0.0)) continue;
        s->scale[g] = single[g] && slacks[g] < 0.0 ? -largest[g] : largest[g];
    }
}

/* All that is found of a group, behind `count` findings of groups before it. */
static int own_range_search_group(own_range_search *s, FINDING *findings, int room, int count)
{
    const int last = BELOW + ABOVE;
    own_range_level a, b, c;
    real from = LOW;
    int k, open = 0, before = 0, finite = 1;
    b = own_range_level_at(s, LOW);
    a = b;
    for (k = 0; k <= last; k++) {
        const real at = own_range_place(k), left = own_range_place(k == 0 ? 0 : k - 1), right = own_range_place(k == last ? last : k + 1);
        const int fail = own_range_fails(b);
        const real sign = fail ? -1.0 : 1.0;
        real fall, rise, dip = at;
        own_range_level found = b;
        c = k == last ? b : own_range_level_at(s, right);
        fall = sign * (a.level - b.level);
        rise = sign * (c.level - b.level);
        if (a.known && b.known && c.known && own_range_fails(a) == fail && own_range_fails(c) == fail
            && fall >= 0.0 && rise >= 0.0 && fall + rise > 0.0) {
            dip = own_range_lowest(s, fail, left, right);
            found = own_range_level_at(s, dip);
        }
        if (fail && !open) {
            open = 1;
            before = own_range_works(a);
            finite = 1;
            from = before ? own_range_edge(s, left, at) : at;
        }
        if (fail && b.level != b.level) finite = 0;
        if (open && !fail) {
            const int works = own_range_works(b);
            count = own_range_add(s, findings, room, count, from, works ? own_range_edge(s, at, left) : left, before && works, finite);
            open = 0;
        }
        if (fail && own_range_works(found)) {
            count = own_range_add(s, findings, room, count, from, own_range_edge(s, dip, left), before, finite);
            from = own_range_edge(s, dip, right);
            before = 1;
        } else if (own_range_works(b) && own_range_fails(found)) {
            const real first = own_range_edge(s, dip > at ? at : left, dip), second = own_range_edge(s, dip < at ? at : right, dip);
            count = own_range_add(s, findings, room, count, first, second, 1, found.level == found.level);
        }
        a = b;
        b = c;
    }
    if (open) count = own_range_add(s, findings, room, count, from, HIGH, 0, finite);
    return count;
}

API int CHECK(const MECHANISM *m, FINDING *findings, int room)
{
    static const real at[] = AT;
    own_range_search s;
    int k, count = 0;
    s.m = m;
    for (k = 0; k < INPUTS; k++) s.x[k] = at[k];
    own_range_measure(&s);
    for (s.group = 0; s.group < GROUPS; s.group++) count = own_range_search_group(&s, findings, room, count);
    return count;
}
