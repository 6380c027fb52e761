"""A value with its error, and the digits that people see of it: the same in prose, paper and book."""

import math
import re
import sys
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal, localcontext
from os.path import commonprefix


def with_digits(x, digits):
    """`x` with so many significant digits, trailing zeros kept, and an exponent without plus and zeros."""
    mantissa, _, exponent = f"{x:#.{digits}g}".partition("e")
    return mantissa.rstrip(".") + (f"e{int(exponent)}" if exponent else "")


def like(x, digits, typed):
    """The same with an exponent if the typed text has one."""
    mantissa, _, exponent = f"{x:.{digits - 1}e}".partition("e")
    return f"{mantissa}e{int(exponent)}" if re.match(r"[-.\d]*e", typed) else with_digits(x, digits)


def without_zeros(text):
    """Without the zeros at the end of the decimals: for values that are exact."""
    mantissa, e, exponent = text.partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + e + exponent


@dataclass(frozen=True)
class Finding:
    """One value of one program: a cell of a table, the answer to a statement, or how many of its comparisons fail."""
    program: str
    id: str
    value: float
    error: float = 0.0
    unit: str = ""
    what: str = "cell"  # or answer, failures

    @property
    def key(self):
        return self.program, self.what, self.id

    @property
    def name(self):
        """What others call it: a statement has a name of its own."""
        return f"{self.program}/{self.id}" if self.what == "cell" else self.id

    @property
    def shown(self):
        """The last digit is that of the error's leading one, six digits at most. Whole numbers without an error
        are counts; other values without one are shown as they are."""
        if not math.isfinite(self.value):
            return str(self.value)
        if self.value == 0:
            return "0"
        if self.error == 0:
            whole = self.value == math.floor(self.value) and abs(self.value) < 1e9
            return str(int(self.value)) if whole else without_zeros(with_digits(self.value, 6))
        if not math.isfinite(self.error):
            return with_digits(self.value, 1)
        places = math.floor(math.log10(abs(self.value))) - math.floor(math.log10(self.error))
        return with_digits(self.value, min(max(places + 1, 1), 6))

    @property
    def certain(self):
        """How many digits are certain: the error is at most half a unit of the last one."""
        return math.floor(math.log10(abs(self.value))) + 1 - math.ceil(math.log10(2 * self.error) - 1e-9) if self.value else 0

    def shown_like(self, typed):
        """With as many digits as the typed text has, three for none, but for uncertain ones. The error is shown where it was
        typed and the last digit is in doubt, or where fewer than two digits are certain."""
        digits = len(re.sub(r"[eE±(].*|\D", "", typed).lstrip("0")) or 3
        if " to " in typed or typed == "to":
            return self.shown_as_interval
        if self.error <= sys.float_info.min or not (math.isfinite(self.value) and math.isfinite(self.error)):
            is_whole = self.error > sys.float_info.min or self.value == math.floor(self.value)
            return self.shown if is_whole else without_zeros(like(self.value, digits, typed))
        if digits <= self.certain or self.certain > 1 and "±" not in typed:
            return like(self.value, min(digits, self.certain), typed)
        error = with_digits(self.error, 1)
        places = math.floor(math.log10(abs(self.value) or self.error)) - math.floor(math.log10(float(error)))
        return f"{like(self.value, places + 1, typed) if places >= 0 else 0} ± {error}"

    @property
    def shown_error(self):
        """One digit."""
        return "exact" if self.error == 0 else with_digits(self.error, 1)

    @property
    def shown_as_interval(self):
        """Both ends of an enclosed value, rounded outwards to two digits of its error: `0.1808335135(73 to 87)`, the digits
        that they share first."""
        if not (self.error > 0 and math.isfinite(self.value) and math.isfinite(self.error)):
            return self.shown
        value, error = Decimal(self.value), Decimal(self.error)
        power, ends = 0 if -5 < value.adjusted() < 6 else value.adjusted(), []
        for outwards, end in ((ROUND_FLOOR, -error), (ROUND_CEILING, error)):
            with localcontext() as context:
                context.prec, context.rounding = 60, outwards
                ends.append(f"{(value + end).quantize(Decimal(1).scaleb(error.adjusted() - 1)).scaleb(-power):f}")
        shared = commonprefix(ends)
        if "." not in shared or len(ends[0]) != len(ends[1]):
            shared = ""
        lower, upper = (end[len(shared):] for end in ends)
        return f"{shared}({lower} to {upper})" + (f"e{power}" if power else "")

    @property
    def shown_unit(self):
        return f" {self.unit}" if self.unit else ""


def distance(locked, fresh):
    """How far apart the two are, in units of what is allowed: up to one they agree. Where one of them is not a
    number, the other must not be one either."""
    if locked.unit != fresh.unit:
        return math.inf
    if math.isnan(locked.value) or math.isnan(fresh.value):
        return 0 if math.isnan(locked.value) and math.isnan(fresh.value) else math.inf
    if locked.value == fresh.value:
        return 0
    allowed = locked.error + fresh.error + 1e-12 * max(abs(locked.value), abs(fresh.value))
    apart = abs(fresh.value - locked.value) / allowed
    return math.inf if math.isnan(apart) else apart
