package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class NumeralsTest {

  @Test
  void noLineEndsBetweenANumberAndItsUnit() {
    assertThat(Numerals.unbroken("It drove 341.64 m in 607 s, 0.5 m/s, 95 % of it"))
        .isEqualTo("It drove 341.64\u00a0m in 607\u00a0s, 0.5\u00a0m/s, 95\u00a0% of it");
    assertThat(Numerals.unbroken("+0.000 s ± 0.017 s"))
        .isEqualTo("+0.000\u00a0s ±\u00a00.017\u00a0s");
    assertThat(Numerals.unbroken("2 robots, 14 waypoints, 3 servers"))
        .isEqualTo("2 robots, 14 waypoints, 3 servers");
  }

  @Test
  void aColumnOfNumbersIsKnown() {
    assertThat(Numerals.areNumbers(List.of("0.54 m", "-", "95.3 %", "yes"))).isTrue();
    assertThat(Numerals.areNumbers(List.of("≤ 0.3 m", "≤ 0", ""))).isTrue();
    assertThat(Numerals.areNumbers(List.of("+0.000 s ± 0.017 s"))).isTrue();
    assertThat(Numerals.areNumbers(List.of("0.109 (0.085 to 0.147) m", "8.63 (-3.7 to 21)")))
        .as("with an interval")
        .isTrue();
    assertThat(Numerals.areNumbers(List.of("atrv1", "2 robots meet"))).isFalse();
    assertThat(Numerals.areNumbers(List.of())).isFalse();
  }
}
