"""Logarithm and exponential without branches, so that a compiled loop over lanes becomes vector instructions.

The C library's versions are called once per number; these are straight arithmetic, four or eight numbers at a time.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any, cast

from llvmlite import ir
from numba import config, types
from numba.extending import intrinsic

from sweetspot.numerics.kernel_cache import compiled


def _bits_of(typing_context: Any, value: Any) -> Any:  # noqa: ARG001 - numba's signature
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ARG001
        return builder.bitcast(arguments[0], ir.IntType(64))

    return types.int64(types.float64), generate


def _float_of(typing_context: Any, bits: Any) -> Any:  # noqa: ARG001 - numba's signature
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ARG001
        return builder.bitcast(arguments[0], ir.DoubleType())

    return types.float64(types.int64), generate


bits_of: Callable[[float], int]
"""The 64 bits of a float as an integer (in compiled code only, unless NUMBA_DISABLE_JIT is set)."""
float_of: Callable[[int], float]
"""The float that has these 64 bits (in compiled code only, unless NUMBA_DISABLE_JIT is set)."""
if config.DISABLE_JIT:  # type: ignore[attr-defined]  # numba's switch, set as it is imported
    bits_of = lambda value: int(struct.unpack("<q", struct.pack("<d", value))[0])  # noqa: E731
    float_of = lambda bits: float(struct.unpack("<d", struct.pack("<q", bits))[0])  # noqa: E731
else:
    bits_of = cast("Callable[[float], int]", intrinsic(_bits_of))
    float_of = cast("Callable[[int], float]", intrinsic(_float_of))

ROOT_HALF_BITS = 0x3FE6A09E667F3BCD
MAGIC = 6755399441055744.0  # 1.5 * 2^52: adding it leaves the nearest integer in the low bits
MAGIC_BITS = 0x4338000000000000
LN2_HIGH, LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10  # ln 2 in two parts, the first short
LOG2_E = 1.4426950408889634
LOWEST = -700.0


@compiled(inline="always")
def log(value: float) -> float:
    """Return the natural logarithm of a positive normal number; relative error about 1e-15.

    value = 2^e m with m in [sqrt(1/2), sqrt(2)); log m = 2 atanh(s), s = (m - 1) / (m + 1), summed to s^21.
    """
    bits = bits_of(value)
    exponent = (bits - ROOT_HALF_BITS) >> 52
    mantissa = float_of(bits - (exponent << 52))
    number = float_of(exponent + MAGIC_BITS) - MAGIC
    ratio = (mantissa - 1.0) / (mantissa + 1.0)
    square = ratio * ratio
    fourth = square * square
    eighth = fourth * fourth
    low = (2.0 + square * (2 / 3)) + fourth * (2 / 5 + square * (2 / 7))
    middle = (2 / 9 + square * (2 / 11)) + fourth * (2 / 13 + square * (2 / 15))
    high = (2 / 17 + square * (2 / 19)) + fourth * (2 / 21)
    return number * LN2_HIGH + (number * LN2_LOW + ratio * (low + eighth * (middle + eighth * high)))


@compiled(inline="always")
def exp(value: float) -> float:
    """Return the exponential of a number below 700; relative error about 1e-15; cut off at exp(-700).

    value = n ln 2 + r, |r| <= ln(2) / 2; Taylor's series of e^r to r^13, times 2^n.
    """
    value = max(value, LOWEST)
    shifted = value * LOG2_E + MAGIC
    number = shifted - MAGIC
    rest = (value - number * LN2_HIGH) - number * LN2_LOW
    square = rest * rest
    fourth = square * square
    low = (1.0 + rest) + square * (1 / 2 + rest * (1 / 6))
    middle = (1 / 24 + rest * (1 / 120)) + square * (1 / 720 + rest * (1 / 5040))
    high = (1 / 40320 + rest * (1 / 362880)) + square * (1 / 3628800 + rest * (1 / 39916800))
    top = 1 / 479001600 + rest * (1 / 6227020800)
    total = (low + fourth * middle) + (fourth * fourth) * (high + fourth * top)
    return total * float_of((bits_of(shifted) - MAGIC_BITS + 1023) << 52)


@compiled(inline="always")
def sine_and_cosine(angle: float) -> tuple[float, float]:
    """Return sine and cosine of an angle up to 1.3 rad either way; error about 1e-16.

    Taylor's series to angle^19 and angle^18.
    """
    square = angle * angle
    fourth = square * square
    eighth = fourth * fourth
    low = (1.0 - square * (1 / 6)) + fourth * (1 / 120 - square * (1 / 5040))
    high = (1 / 362880 - square * (1 / 39916800)) + fourth * (1 / 6227020800 - square * (1 / 1307674368000))
    top = 1 / 355687428096000 - square * (1 / 121645100408832000)
    sine = angle * (low + eighth * (high + eighth * top))
    low = (1.0 - square * (1 / 2)) + fourth * (1 / 24 - square * (1 / 720))
    high = (1 / 40320 - square * (1 / 3628800)) + fourth * (1 / 479001600 - square * (1 / 87178291200))
    top = 1 / 20922789888000 - square * (1 / 6402373705728000)
    return sine, low + eighth * (high + eighth * top)
