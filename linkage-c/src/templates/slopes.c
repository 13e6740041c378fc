/* A number of the state at these offsets from the centre of a cell. */
static real own_value_NUMBER(const own_node_NUMBER *node, int k, const real *offsets)
{
    real value = node->state[0][k];
    int axis;
    for (axis = 0; axis < AXES; axis++) value += node->state[1 + axis][k] * offsets[axis];
    return value;
}

