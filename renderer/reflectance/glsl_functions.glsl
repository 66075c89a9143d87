// The names that formulas use and GLSL 3.30 lacks, or computes with too few digits. glsl_functions.h is the
// other half, for C++. In a shader this file, float_functions.glsl and the shared functions precede the
// formulas.
#define real float
#define PI 3.14159265358979323846
#define EPSILON 1.1920929e-7
#define log log_of
#define log1p log1p_of
#define expm1 expm1_of
#define erfc erfc_of
#define sin sin_of
#define cos cos_of
#define atan2 atan2_of
