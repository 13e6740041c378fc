/* What is optimised for speed has no call of these. */
#if defined __GNUC__ && defined __OPTIMIZE__ && !defined __OPTIMIZE_SIZE__
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif
