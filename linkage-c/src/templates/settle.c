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
