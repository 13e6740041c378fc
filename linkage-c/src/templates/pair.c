typedef struct own_pair { real sine, cosine; } own_pair;
