package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ChargeCurveTest {

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "23.6, 0",
    "23.9, 0.125",
    "24.2, 0.25",
    "24.7, 0.5",
    "25.45, 0.875",
    "25.7, 1",
    "29, 1",
  })
  void goesAlongALineThroughItsPoints(double voltage, double remaining) {
    assertThat(ChargeCurve.LEAD_ACID_24.remaining(voltage)).isCloseTo(remaining, within(1e-9));
  }

  @Test
  void mayBeFlatAndBeginAboveEmpty() {
    ChargeCurve curve = ChargeCurve.parse(" 22:0.1  23:0.1 24:0.9 ");
    assertThat(curve.remaining(10)).isEqualTo(0.1);
    assertThat(curve.remaining(22.5)).isCloseTo(0.1, within(1e-12));
    assertThat(curve.remaining(23.5)).isCloseTo(0.5, within(1e-12));
    assertThat(curve.remaining(30)).isEqualTo(0.9);
    assertThat(ChargeCurve.parse(curve.toString())).isEqualTo(curve);
  }
}
