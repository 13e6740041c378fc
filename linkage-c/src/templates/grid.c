/* The state near these inputs, by the cell of the grid in which they are, then half of the least determinant near it; NaN outside. */
static void own_table_NUMBER(const real *x, real *state)
{
    const own_node_NUMBER *node;
    real offsets[AXES], outside = 0.0;
    uint32_t number = 0;
    int axis, k;
    for (axis = 0; axis < AXES; axis++) {
        const own_axis_NUMBER *const along = &own_axes_NUMBER[axis];
        const real from_middle = x[along->input] - along->middle;
        const real place = from_middle * along->rate - own_whole(from_middle * along->repeats);
        const int slot = (int)own_within(place * along->slots + 0.5 * along->slots, along->slots - 1.0);
        number = number * (uint32_t)along->slots + (uint32_t)slot;
        offsets[axis] = place * along->slots - ((real)slot + 0.5 - 0.5 * along->slots);
        outside += own_select(OUTSIDE - fabs(offsets[axis]), 0.0, own_nan());
    }
    node = &own_nodes_NUMBER[own_index_NUMBER[number]];
    for (k = 0; k < SIZE; k++) state[k] = own_value_NUMBER(node, k, offsets) + outside;
    state[SIZE] = node->floor + outside;
}
