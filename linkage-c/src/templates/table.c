/* The state near an input, by polynomials in cells of its range, then half of the least determinant near it; NaN outside. */
static void own_table_NUMBER(const real *x, real *state)
{
    const real from_middle = x[INPUT] - MIDDLE;
    const real place = from_middle * RATE - own_whole(from_middle * REPEATS);
    const real slot = own_within(place * SLOTS + HALF_SLOTS, LAST_SLOT);
    const own_cell_NUMBER *const cell = &own_cells_NUMBER[own_index_NUMBER[(int)slot]];
    const real t = (place - cell->centre) * cell->inverse;
    const real guard = own_select(OUTSIDE - fabs(t), 0.0, own_nan());
    int k, power;
    for (k = 0; k < SIZE; k++) {
        real value = cell->state[DEGREE][k];
        for (power = DEGREE - 1; power >= 0; power--) value = value * t + cell->state[power][k];
        state[k] = value + guard;
    }
    state[SIZE] = cell->floor + guard;
}
