/* Brings a state of the table to these dimensions, by Newton steps each of which is much smaller than the one before, while the
   determinant keeps its sign: then they reach the solution that lies nearest. NaN where they do not. */
static void own_settle_NUMBER(const MECHANISM *m, const real *x, real *state)
{
    const real least = LIMIT * LIMIT;
    real next[STEPPED], guard, allowed = FIRST * FIRST;
    int step, k;
    guard = least;
    for (step = 0; step < STEPS; step++) {
        own_correct_NUMBER(m, x, state, next);
        guard = own_min(guard, own_min((step + 1 < STEPS ? allowed : least) - next[SIZE], next[SIZE + 1] * state[SIZE]));
        for (k = 0; k < SIZE; k++) state[k] = next[k];
        allowed = own_max(CONTRACTION * next[SIZE], least);
    }
    guard = own_select(guard, 0.0, own_nan());
    for (k = 0; k < SIZE; k++) state[k] += guard;
    state[SIZE] = 0.5 * next[SIZE + 1] + guard;
}

/* The state for these dimensions. */
static void own_state_NUMBER(const MECHANISM *m, const real *x, real *state)
{
    own_table_NUMBER(x[INPUT], state);
    if (m->moved) own_settle_NUMBER(m, x, state);
}

/* Whether the table serves these dimensions in the middle and at both ends of each of its cells. */
static int own_serves_NUMBER(const MECHANISM *m, const real *at)
{
    real x[INPUTS], state[SIZE + 1];
    int cell, side, input;
    for (input = 0; input < INPUTS; input++) x[input] = at[input];
    for (cell = 0; cell < CELLS; cell++) {
        const own_cell_NUMBER *const own = &own_cells_NUMBER[cell];
        for (side = -1; side <= 1; side++) {
            const real within = own->inverse > 0.0 ? (real)side / own->inverse : 0.0;
            x[INPUT] = MIDDLE + (own->centre + within) * LENGTH;
            own_state_NUMBER(m, x, state);
            if (state[0] != state[0]) return 0;
        }
    }
    return 1;
}
