/* The state from which the steps begin; those from the middle of a cell serve other dimensions, too. */
static void own_state_NUMBER(const MECHANISM *m, const real *x, real *state)
{
    own_table_NUMBER(x, state);
    if (DEGREE > 1 && m->moved) own_settle_NUMBER(m, x, state);
}

/* Whether Newton steps reach these dimensions from the centres of all cells that have a solution. */
static int own_serves_NUMBER(const MECHANISM *m, const real *at)
{
    real x[INPUTS], state[SIZE + 1];
    int cell, axis, input;
    for (input = 0; input < INPUTS; input++) x[input] = at[input];
    for (cell = 0; cell < CELLS; cell++) {
        int rest = cell;
        if (own_index_NUMBER[cell] == 0) continue;
        for (axis = AXES - 1; axis >= 0; axis--) {
            const own_axis_NUMBER *const along = &own_axes_NUMBER[axis];
            const int slots = (int)along->slots;
            x[along->input] = along->middle + (((real)(rest % slots) + 0.5) / along->slots - 0.5) * along->length;
            rest /= slots;
        }
        own_table_NUMBER(x, state);
        own_settle_NUMBER(m, x, state);
        if (state[0] != state[0]) return 0;
    }
    return 1;
}
