/* The state for these dimensions. */
static void own_state_NUMBER(const MECHANISM *m, const real *x, real *state)
{
    own_table_NUMBER(x, state);
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
