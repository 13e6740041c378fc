/* 0, or the number of what is wrong with the first group that does not close at these inputs. */
static int own_close(MECHANISM *m, const real *at)
{
    static const int open[] = OPEN, undefined[] = UNDEFINED;
    real gaps[GROUPS];
    int k;
    own_gaps(m, at, gaps);
    for (k = 0; k < GROUPS; k++) {
        if (gaps[k] != gaps[k]) return own_overflows(&m->dimensions) ? TOO_LARGE : undefined[k];
        if (gaps[k] > 0.0) {
            m->miss = gaps[k];
            return open[k];
        }
    }
    return 0;
}
