/* The value of a polynomial of up to seven terms, pairs of powers side by side. */
static real own_pairs_NUMBER(const real *c, int terms, real t)
{
    const real t2 = t * t;
    real sums[TERMS];
    int k;
    for (k = 0; k < terms; k += 2) sums[k] = k + 1 < terms ? c[k] + c[k + 1] * t : c[k];
    if (terms > 2) sums[0] += sums[2] * t2;
    if (terms > 6) sums[4] += sums[6] * t2;
    if (terms > 4) sums[0] += sums[4] * (t2 * t2);
    return sums[0];
}

/* A number of the state at these offsets from the centre of a cell. */
static real own_value_NUMBER(const own_node_NUMBER *node, int k, const real *offsets)
{
    real rows[TERMS], row[TERMS];
    int first, second, place = 0;
    for (second = 0; second < TERMS; second++) {
        for (first = 0; first < TERMS - second; first++) row[first] = node->state[place++][k];
        rows[second] = own_pairs_NUMBER(row, TERMS - second, offsets[0]);
    }
    return own_pairs_NUMBER(rows, TERMS, offsets[1]);
}

