/* Each angle at its estimate, and no turns: right at the reference position. */
static void own_no_turns(own_turns *turns)
{
    int angle, input;
    for (angle = 0; angle < ANGLES; angle++) {
        turns->centre[angle] = own_estimates[angle];
        for (input = 0; input < INPUTS; input++) turns->winding[angle][input] = 0.0;
    }
}

/* Centre and turns of an angle by a vector of fixed length that is longer than all others together, if there is one and it turns with the
   inputs alone: the angle turns with it. Returns 0 if no vector decides. */
static int own_uniform(int angle, const real *vectors, const real *at, real here, own_turns *turns)
{
    const int first = own_first_phase[angle];
    const int last = own_first_phase[angle + 1];
    real all = 0.0, turned = 0.0, centre;
    int k, input;
    for (k = first; k < last; k++) all += own_hypot(vectors[2 * k], vectors[2 * k + 1]);
    for (k = first; k < last; k++) {
        const real length = own_hypot(vectors[2 * k], vectors[2 * k + 1]);
        /* The others turn the sum by less than 0.45 pi, and the angle keeps within a quarter turn of the sum. */
        if (length > 0.0 && all - length <= 0.9876883405951378 * length) break;
    }
    if (k == last || !own_turning[k]) return 0;
    for (input = 0; input < INPUTS; input++) turned += own_phase_turns[k][input] * at[input];
    centre = own_atan2(vectors[2 * k + 1], vectors[2 * k]);
    turns->centre[angle] = centre + TURN * own_whole((here - (centre + turned)) / TURN);
    for (input = 0; input < INPUTS; input++) turns->winding[angle][input] = own_phase_turns[k][input];
    return 1;
}

/* The same by following the angle along each of its inputs. The middles of these motions add up. */
static int own_follow_inputs(const MECHANISM *m, int angle, const real *at, real here, own_turns *turns)
{
    real middle = 0.0, turned = 0.0;
    int k, input, inputs = 0;
    for (input = 0; input < INPUTS; input++) turns->winding[angle][input] = 0.0;
    for (k = own_first_along[angle]; k < own_first_along[angle + 1]; k++) {
        const own_along along = own_all_along[k];
        const real x = at[along.input];
        const real low = along.low < x ? along.low : x;
        const real high = along.high > x ? along.high : x;
        real inputs_there[INPUTS];
        own_path path;
        own_stray best;
        if (low == high) continue;
        for (input = 0; input < INPUTS; input++) inputs_there[input] = at[input];
        path.m = m;
        path.x = inputs_there;
        path.input = along.input;
        path.angle = angle;
        path.reference = x;
        path.estimate = here;
        if (!own_follow(&path, low, high, own_rates + along.first_rate, along.rates, &best)) return 0;
        turns->winding[angle][along.input] = best.rate;
        middle += 0.5 * (best.least + best.most) + best.rate * x - here;
        turned += best.rate * x;
        inputs++;
    }
    /* A larger sum would leave the angle at the start too little of its half turn. */
    if (fabs(middle) > MOST_MIDDLE) middle = middle / (real)inputs;
    turns->centre[angle] = here + middle - turned;
    return 1;
}

/* Finds the turns of all angles, one after the other. Returns the number of the one that cannot be followed, or else how many there are. */
static int own_wind(MECHANISM *m, const real *at, own_turns *turns)
{
    real directions[DIRECTIONS], vectors[BEARINGS];
    int angle;
    own_bearings(m, vectors);
    for (angle = 0; angle < ANGLES; angle++) {
        real here;
        own_prepare(m, turns);
        own_directions(m, at, directions);
        here = own_angle_near(directions[2 * angle + 1], directions[2 * angle], own_estimates[angle]);
        if (own_infinite(here)) return angle;
        if (!own_uniform(angle, vectors, at, here, turns) && !own_follow_inputs(m, angle, at, here, turns)) return angle;
    }
    return ANGLES;
}

/* 0, or the number of what is wrong: an angle that cannot be followed, or a loop that does not close, if that is why. */
static int own_turn(MECHANISM *m, const real *at, own_turns *turns)
{
    int angle, code;
    own_no_turns(turns);
    angle = own_wind(m, at, turns);
    if (angle == ANGLES) return 0;
    own_no_turns(turns);
    own_prepare(m, turns);
    code = own_close(m, at);
    return code != 0 ? code : NO_TURNS + angle;
}
