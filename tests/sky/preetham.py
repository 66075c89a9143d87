#!/usr/bin/env python3
"""Prints values of the daylight model of Preetham, Shirley and Smits (1999), evaluated from the paper's formulas and
tables, and of the sun's light, which daylight_test.cpp compares with the program's. It shares no code with it.

    tests/sky/preetham.py > tests/sky/preetham.csv

Columns: elevation of the sun and turbidity; zenith angle of a direction and its angle from the sun, all in degrees;
x and y; Y in kcd/m2. Lines with a zenith angle of -1 are of the sun: X, Y and Z of its irradiance, in klux.
"""
import math

# Appendix A.2, table by table: columns T and 1.
LUMINANCE = [[0.1787, -1.4630], [-0.3554, 0.4275], [-0.0227, 5.3251], [0.1206, -2.5771], [-0.0670, 0.3703]]
SMALL_X = [[-0.0193, -0.2592], [-0.0665, 0.0008], [-0.0004, 0.2125], [-0.0641, -0.8989], [-0.0033, 0.0452]]
SMALL_Y = [[-0.0167, -0.2608], [-0.0950, 0.0092], [-0.0079, 0.2102], [-0.0441, -1.6537], [-0.0109, 0.0529]]
ZENITH_X = [[0.00166, -0.00375, 0.00209, 0], [-0.02903, 0.06377, -0.03202, 0.00394],
            [0.11693, -0.21196, 0.06052, 0.25886]]
ZENITH_Y = [[0.00275, -0.00610, 0.00317, 0], [-0.04214, 0.08970, -0.04153, 0.00516],
            [0.15346, -0.26756, 0.06670, 0.26688]]


def perez(table, turbidity, theta, gamma):
    a, b, c, d, e = [t * turbidity + one for t, one in table]
    return (1 + a * math.exp(b / math.cos(theta))) * (1 + c * math.exp(d * gamma) + e * math.cos(gamma) ** 2)


def zenith_chromaticity(matrix, turbidity, sun):
    powers_of_t = [turbidity ** 2, turbidity, 1]
    powers_of_sun = [sun ** 3, sun ** 2, sun, 1]
    return sum(t * m * s for t, row in zip(powers_of_t, matrix) for m, s in zip(row, powers_of_sun))


def sky(elevation, turbidity, theta, gamma):
    sun = math.radians(90 - elevation)
    chi = (4 / 9 - turbidity / 120) * (math.pi - 2 * sun)
    zeniths = [zenith_chromaticity(ZENITH_X, turbidity, sun), zenith_chromaticity(ZENITH_Y, turbidity, sun),
               (4.0453 * turbidity - 4.9710) * math.tan(chi) - 0.2155 * turbidity + 2.4192]
    return [zenith * perez(table, turbidity, theta, gamma) / perez(table, turbidity, 0, sun)
            for zenith, table in zip(zeniths, [SMALL_X, SMALL_Y, LUMINANCE])]


def observer(nm):
    """Wyman, Sloan and Shirley 2013, table 1, in the form that they print."""
    def g(mean, left, right):
        t = (nm - mean) * (left if nm < mean else right)
        return math.exp(-0.5 * t * t)
    return [0.362 * g(442.0, 0.0624, 0.0374) + 1.056 * g(599.8, 0.0264, 0.0323) - 0.065 * g(501.1, 0.0490, 0.0382),
            0.821 * g(568.8, 0.0213, 0.0247) + 0.286 * g(530.9, 0.0613, 0.0322),
            1.217 * g(437.0, 0.0845, 0.0278) + 0.681 * g(459.0, 0.0385, 0.0725)]


def sun(elevation, turbidity):
    """A black body of 5778 K with 127.5 klux, through molecules and aerosols (appendix A.1), by 1 nm."""
    mass = 1 / (math.sin(math.radians(elevation)) + 0.15 * (93.885 - (90 - elevation)) ** -1.253)
    beta = 0.04608 * turbidity - 0.04586
    above, arriving = 0, [0, 0, 0]
    for nm in range(360, 831):
        micrometres = nm / 1000
        black_body = nm ** -5 / (math.exp(1.438776877e7 / (nm * 5778)) - 1)
        molecules = math.exp(-0.008735 * micrometres ** (-4.08) * mass)
        aerosols = math.exp(-beta * micrometres ** -1.3 * mass)
        matched = observer(nm)
        above += black_body * matched[1]
        arriving = [sum_ + black_body * m * molecules * aerosols for sum_, m in zip(arriving, matched)]
    return [127.5 * each / above for each in arriving]


def main():
    print("elevation,turbidity,theta,gamma,x,y,Y")
    for elevation in (10, 30, 60, 85):
        for turbidity in (2, 3.5, 6):
            print(elevation, turbidity, -1, 0, *(f"{v:.6g}" for v in sun(elevation, turbidity)), sep=",")
            for theta in (0, 40, 75, 89):
                for azimuth in (0, 50, 180):
                    zenith_angle, sun_angle = math.radians(theta), math.radians(90 - elevation)
                    cosine = math.cos(zenith_angle) * math.cos(sun_angle) + math.sin(zenith_angle) * math.sin(
                        sun_angle) * math.cos(math.radians(azimuth))
                    gamma = math.acos(max(-1, min(1, cosine)))
                    values = sky(elevation, turbidity, zenith_angle, gamma)
                    print(elevation, turbidity, theta, f"{math.degrees(gamma):.9g}", *(f"{v:.6g}" for v in values),
                          sep=",")


main()
