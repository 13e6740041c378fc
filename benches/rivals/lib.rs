//! Nothing: the benchmark `rivals` is all there is.
