"""The digits that people see of a value, and how far two values may be apart."""

import math
import unittest

from lineage.values import distance

from common import finding


class Values(unittest.TestCase):
    def test_a_number_shows_the_digits_that_its_error_allows(self):
        for f, shown in [
                (finding(1.6242247200089819e-11, 4e-20), "1.62422e-11"), (finding(-7.5714e-08, 1e-10), "-7.57e-8"),
                (finding(0.00091771471, 1.17e-06), "0.000918"), (finding(1.4978440800419035, 0.0057), "1.498"),
                (finding(24934.60966977202, 0.104), "24934.6"), (finding(2.0000000000000004, 5e-17), "2.00000"),
                (finding(7e-15, 4e-14), "7e-15"), (finding(500, 200), "5e2"), (finding(14), "14"), (finding(-3), "-3"),
                (finding(0), "0"), (finding(1.5), "1.5"), (finding(1.0009999999999999), "1.001"),
                (finding(1753921.9), "1.75392e6"), (finding(1.75e19), "1.75e19"), (finding(math.nan, 1), "nan"),
                (finding(1, math.nan), "1")]:
            self.assertEqual(f.shown, shown)
        self.assertEqual([finding(1, e).shown_error for e in (3.7e-9, 0)], ["4e-9", "exact"])

    def test_as_many_digits_as_are_typed_and_certain(self):
        for f, typed, shown in [
                (finding(0.0650178, 4e-8), "0.0650", "0.0650"), (finding(0.0650178, 4e-8), "", "0.0650"),
                (finding(2.113, 1e-3), "2.1130 ± 0.01", "2.113 ± 0.001"), (finding(2.113, 1e-6), "2.11 ± 0.01", "2.11"),
                (finding(2.113, 1e-3), "2.113", "2.11"), (finding(0.13, 0.02), "0.13", "0.13 ± 0.02"),
                (finding(2e-5, 2e-4), "2e-5", "0 ± 0.0002"), (finding(180339.2, 0.5), "1.80e5", "1.80e5"),
                (finding(4.45177e-6, 4e-10), "4.4518e-6", "4.452e-6"), (finding(5.445e-4, 1e-9), "5.4e-4", "5.4e-4"),
                (finding(0, 2.2e-308), "0", "0"), (finding(11.0), "11.0", "11"), (finding(1 / 3), "0.333", "0.333"),
                (finding(0), "", "0"), (finding(0.5, 2), "to", "(-1.5 to 2.5)"), (finding(math.nan, 1), "1", "nan")]:
            self.assertEqual(f.shown_like(typed), shown)

    def test_both_ends_of_what_is_enclosed_are_rounded_outwards(self):
        for f, shown in [
                (finding(0.18083351357990812, 6.4137584132595309e-12), "0.1808335135(734 to 864)"),
                (finding(-7.1352642666967339e-10, 1.2229813864603386e-17), "-7.135264(39 to 14)e-10"),
                (finding(4.8529766130678276e-06, 5.9396940287775363e-15), "4.8529766(071 to 191)e-6"),
                (finding(2, 0.25), "(1.75 to 2.25)"), (finding(0.5, 2), "(-1.5 to 2.5)"), (finding(3), "3"),
                (finding(1, math.nan), "1")]:
            self.assertEqual(f.shown_as_interval, shown)

    def test_two_agree_within_the_sum_of_the_errors(self):
        for locked, fresh, agrees in [
                (finding(1, 1e-3), finding(1.0019, 1e-3), True), (finding(1, 1e-3), finding(1.0021, 1e-3), False),
                (finding(1.62e-11, 1e-20), finding(1.77e-11, 1e-20), False), (finding(1), finding(1 + 5e-16), True),
                (finding(1), finding(1 + 1e-11), False), (finding(1, 0, "m"), finding(1), False),
                (finding(1, 1), finding(math.nan, 1), False), (finding(1, 1), finding(1.5, math.nan), False),
                (finding(math.nan, 1), finding(math.nan, 1), True)]:
            self.assertEqual(distance(locked, fresh) <= 1, agrees, (locked, fresh))
