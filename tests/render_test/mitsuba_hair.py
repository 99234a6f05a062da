#!/usr/bin/env python3
"""Values of Mitsuba 3's hair BSDF, and of the same equations in double precision.

Usage: mitsuba_hair.py [--each N] > values.csv     (needs: pip install mitsuba)

Each line: beta_m, beta_n, tilt (radian), sigma_a, eta, the sine of the viewer's
inclination, h, the light's direction in Lancret's local axes (render_test/material/hair_bsdf.h),
Mitsuba's value, the value in double, and the same with Mitsuba's own Bessel function.
Values are f times cosine, 1/sr. Numbers
that go in are those of single precision, so that all sides start from the same bits; but
Mitsuba takes h from the viewer's direction about the strand's normal, and so its
directions are turned by asin(h) and rounded once more.
"""

import argparse
import math
import random
import struct
import sys

# (beta_m, beta_n, tilt in radian, sigma_a, eta); each parameter is moved by itself.
SETTINGS = [
    (0.3, 0.3, 0.035, 0.0, 1.55),
    (0.3, 0.3, 0.035, 0.25, 1.55),
    (0.3, 0.3, 0.035, 2.0, 1.55),
    (0.3, 0.3, 0.0, 0.25, 1.55),
    (0.3, 0.3, -0.15, 0.25, 1.55),
    (0.3, 0.3, 0.15, 0.25, 1.55),
    (0.1, 0.1, 0.035, 0.25, 1.55),
    (0.05, 0.3, 0.035, 0.25, 1.55),
    (0.3, 0.05, 0.035, 0.25, 1.55),
    (0.6, 0.6, 0.035, 0.25, 1.55),
    (1.0, 1.0, 0.035, 0.25, 1.55),
    (0.3, 0.3, 0.035, 0.25, 1.33),
    (0.3, 0.3, 0.035, 0.25, 2.0),
]


def single(x):
    """x as a number of single precision."""
    return struct.unpack("f", struct.pack("f", x))[0]


def bessel_i0_scaled(x):
    """I0(x) exp(-x), x >= 0, to rounding: the series, or its asymptote to 20 terms."""
    term = total = 1.0
    if x < 30:
        k = 1
        while term > 1e-18 * total:
            term *= (x / (2 * k)) ** 2
            total += term
            k += 1
        return total * math.exp(-x)
    for k in range(1, 21):
        term *= (2 * k - 1) ** 2 / (8 * x * k)
        total += term
    return total / math.sqrt(2 * math.pi * x)


def longitudinal(x, y, v):
    """M for x = ci co / v and y = si so / v."""
    return bessel_i0_scaled(x) * math.exp(x - y - 1 / v) / (v * -math.expm1(-2 / v))


def mitsuba_longitudinal(x, y, v):
    """The same with what Mitsuba takes for I0: ten terms of its series up to x = 12, then
    an asymptote of which the second term is half of what it should be; and 0.6931 for
    ln 2 where v < 0.1. Both are 0.6 % too small where they meet."""
    if x > 12:
        log_i0 = x + (-math.log(2 * math.pi * x) + 1 / (8 * x)) / 2
    else:
        log_i0 = math.log(sum((x / 2) ** (2 * k) / math.factorial(k) ** 2 for k in range(11)))
    if 1 / v > 10:
        return math.exp(-y + log_i0 - 1 / v + 0.6931 + math.log(0.5 / v))
    return math.exp(log_i0 - y) / (2 * v * math.sinh(1 / v))


def fresnel(cosine, eta):
    inside = math.sqrt(1 - (1 - cosine**2) / eta**2)
    s = (cosine - eta * inside) / (cosine + eta * inside)
    p = (eta * cosine - inside) / (eta * cosine + inside)
    return (s * s + p * p) / 2


def exact(setting, sine_o, h, wi, m=longitudinal):
    """The model of Chiang et al. 2016 in double precision."""
    beta_m, beta_n, tilt, sigma_a, eta = setting
    cosine_o = math.sqrt(1 - sine_o**2)
    sine_i, cosine_i = wi[0], math.hypot(wi[1], wi[2])
    v0 = (0.726 * beta_m + 0.812 * beta_m**2 + 3.7 * beta_m**20) ** 2
    s = math.sqrt(math.pi / 8) * (0.265 * beta_n + 1.194 * beta_n**2 + 5.372 * beta_n**22)
    cosine_t = math.sqrt(1 - (sine_o / eta) ** 2)
    sine_gamma_t = h * cosine_o / math.sqrt(eta**2 - sine_o**2)
    path = 2 * math.sqrt(1 - sine_gamma_t**2) / cosine_t
    gamma_o, gamma_t = math.asin(h), math.asin(sine_gamma_t)
    transmitted = math.exp(-sigma_a * path)
    f = fresnel(cosine_o * math.sqrt(1 - h * h), eta)
    a = [f, (1 - f) ** 2 * transmitted, (1 - f) ** 2 * f * transmitted**2]
    a.append(a[2] * f * transmitted / (1 - f * transmitted))
    turn = [2 * tilt, -tilt, -4 * tilt, 0]
    variance = [v0, v0 / 4, 4 * v0, 4 * v0]
    phi = math.atan2(wi[2], wi[1]) - math.pi / 2
    value = 0
    for p in range(4):
        sine = sine_o * math.cos(turn[p]) + cosine_o * math.sin(turn[p])
        cosine = abs(cosine_o * math.cos(turn[p]) - sine_o * math.sin(turn[p]))
        v = variance[p]
        n = 1 / (2 * math.pi)
        if p < 3:
            off = math.remainder(phi - (2 * p * gamma_t - 2 * gamma_o + p * math.pi), 2 * math.pi)
            e = math.exp(-abs(off) / s)
            n = e / (s * (1 + e) ** 2) / math.tanh(math.pi / (2 * s))
        value += a[p] * m(cosine_i * cosine / v, sine_i * sine / v, v) * n
    return value


def mitsuba_value(mi, bsdf, context, sine_o, h, wi):
    """Mitsuba's y runs along the strand and its z is the normal; its wi is the viewer."""
    cosine_o, gamma = math.sqrt(1 - sine_o**2), math.asin(h)
    interaction = mi.SurfaceInteraction3f()
    interaction.wi = [-cosine_o * h, sine_o, cosine_o * math.cos(gamma)]
    cosine_i, azimuth = math.hypot(wi[1], wi[2]), math.atan2(wi[2], wi[1]) + gamma
    light = [cosine_i * math.cos(azimuth), wi[0], cosine_i * math.sin(azimuth)]
    return bsdf.eval(context, interaction, light)[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--each", type=int, default=1000, help="values a setting")
    each = parser.parse_args().each
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    print(f"# Mitsuba {mi.__version__}, scalar_rgb, by mitsuba_hair.py --each {each}")
    print("# beta_m, beta_n, tilt, sigma_a, eta, sine_o, h, wi_x, wi_y, wi_z, mitsuba, exact, bessel")
    draw = random.Random(1)
    for setting in SETTINGS:
        setting = tuple(single(x) for x in setting)
        beta_m, beta_n, tilt, sigma_a, eta = setting
        bsdf = mi.load_dict({
            "type": "hair",
            "longitudinal_roughness": beta_m,
            "azimuthal_roughness": beta_n,
            # Mitsuba's tilt is about an axis that runs from tip to root.
            "scale_tilt": -math.degrees(tilt),
            "int_ior": eta,
            "ext_ior": 1.0,
            "sigma_a": {"type": "rgb", "value": [sigma_a] * 3},
        })
        for _ in range(each):
            sine_o = single(math.sin(draw.uniform(-1.4, 1.4)))
            h = single(draw.uniform(-0.999, 0.999))
            # Half the lights anywhere, half near the cone of the highlights.
            # Not along the strand: there azimuths are all rounding.
            x, near = draw.uniform(-0.98, 0.98), -sine_o + draw.gauss(0, beta_m)
            if abs(near) < 0.98 and draw.random() < 0.5:
                x = near
            azimuth = draw.uniform(-math.pi, math.pi)
            r = math.sqrt(1 - x * x)
            wi = [single(x), single(r * math.cos(azimuth)), single(r * math.sin(azimuth))]
            numbers = [*setting, sine_o, h, *wi,
                       mitsuba_value(mi, bsdf, mi.BSDFContext(), sine_o, h, wi),
                       exact(setting, sine_o, h, wi),
                       exact(setting, sine_o, h, wi, mitsuba_longitudinal)]
            print(",".join(f"{x:.9g}" for x in numbers))


if __name__ == "__main__":
    sys.exit(main())
