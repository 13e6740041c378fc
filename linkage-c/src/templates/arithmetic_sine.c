    /* A sine of a large angle is made of such sums. */
    {
        volatile real angle = 98766.25;
        const own_pair pair = own_sin_cos(angle);
        const real sine_off = pair.sine - 0.7579446236004318;
        const real cosine_off = pair.cosine - 0.6523189001977482;
        if (!(fabs(sine_off) <= EIGHT_ROUNDOFFS && fabs(cosine_off) <= EIGHT_ROUNDOFFS)) return REORDERED;
    }
