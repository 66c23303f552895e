static double minimum_(double a, double b) { return a < b || isnan(a) ? a : b; }

static double maximum_(double a, double b) { return a > b || isnan(a) ? a : b; }

static double sign_(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0 * a + 0.0; }

static double mod_(double a, double b) {
    const double left = fmod(a, b);
    if (left == 0.0) return copysign(0.0, b);
    return (left < 0.0) != (b < 0.0) ? left + b : left;
}

static double floordiv_(double a, double b) {
    const double left = fmod(a, b);
    double ratio = (a - left) / b, whole;
    if (b == 0.0) return a / b;
    if (left != 0.0 && (left < 0.0) != (b < 0.0)) ratio -= 1.0;
    whole = floor(ratio);
    return ratio - whole > 0.5 ? whole + 1.0 : whole;
}

static double pick_(const double *row, int stride, int count, double place) {
    double whole = trunc(place);
    if (whole < 0.0) whole += count;
    return whole >= 0.0 && whole < count ? row[stride * (int)whole] : NAN;
}

static double search_(const double *row, int stride, int count, double value, double right) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        const double number = row[stride * middle];
        if (number < value || (right > 0.5 && number == value)) low = middle + 1;
        else high = middle;
    }
    return low;
}

static double argmin_(const double *row, int stride, int count) {
    int best = 0;
    for (int k = 1; k < count && row[stride * best] == row[stride * best]; k++)
        if (!(row[stride * k] >= row[stride * best])) best = k;
    return best;
}
