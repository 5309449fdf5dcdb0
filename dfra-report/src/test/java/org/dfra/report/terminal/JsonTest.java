package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class JsonTest {

  record Motion(double speed, @Nullable Double course) {}

  @Test
  void aNumberThatIsNotKnownIsNull() {
    assertThat(Json.line(new Motion(Double.NaN, Double.NaN)))
        .isEqualTo("{\"speed\":null,\"course\":null}");
    assertThat(Json.line(new Motion(1.5, null))).isEqualTo("{\"speed\":1.5,\"course\":null}");
  }

  @Test
  void onALineForPeopleItIsLeftOut() {
    assertThat(InlineFormat.of(new Motion(1.5, Double.NaN))).isEqualTo("speed 1.5");
  }
}
