package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LmsSettingsTest {

  @Test
  void hasASpeedOfItsOwnOnASerialPortOnly() {
    assertThat(orders(Map.of("link", "serial:/dev/ttyS0")).baud()).contains(LmsBaud.B38400);
    assertThat(orders(Map.of()).baud()).as("a serial server's is its own").isEmpty();
    assertThat(orders(Map.of("baud", "500000")).baud()).contains(LmsBaud.B500000);
    assertThat(orders(Map.of("link", "serial:/dev/ttyS0", "baud", "keep")).baud()).isEmpty();
  }

  @Test
  void wantsMillimetresAndKeepsTheRest() {
    LmsSettings usual = orders(Map.of());
    assertThat(usual.unit()).contains(LmsUnit.MM);
    assertThat(usual.measuringMode()).isEmpty();
    assertThat(usual.variant()).isEqualTo(new LmsVariant(180, 50));
    assertThat(usual.isPolled()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "baud           | 57600 | 9600, 19200, 38400, 500000 or keep",
        "baud           | fast  | 9600, 19200, 38400, 500000 or keep",
        "units          | inch  | mm, cm or keep",
        "measuring_mode | 7     | 0 to 6, 15 or keep",
        "measuring_mode | 1.5   | 0 to 6, 15 or keep",
        "field_of_view  | 120   | 100 or 180, degrees",
        "field_of_view  | 360   | a number from 100 to 180",
        "resolution     | 0.25  | 0.25, 0.5 or 1, degrees; 0.25 only with field_of_view 100",
        "resolution     | 0.7   | 0.25, 0.5 or 1, degrees; 0.25 only with field_of_view 100",
        "mode           | often | continuous or polled",
        "period         | 0     | a number from 0.02 to 60",
        "idle_timeout     | -1    | a number of seconds from 0 to 3600"
      })
  void refusesWhatThereIsNotAndSaysWhereItStands(String name, String value, String allowed) {
    Map<String, Parameters.Value> written = new TreeMap<>();
    written.put("link", new Parameters.Value("tcp://127.0.0.1:4001", SourceLocation.CODE));
    written.put(name, new Parameters.Value(value, new SourceLocation("atrv1.xml", 12)));
    Parameters parameters = new Parameters("atrv1/laser", written);
    assertThatThrownBy(
            () -> {
              LmsSettings.from(parameters);
              LmsSettings.idleAfterIn(parameters);
            })
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("atrv1.xml:12: atrv1/laser: parameter " + name)
        .hasMessageContaining("which is not " + allowed);
  }

  @Test
  void anOrderCanBeChangedIfThereIsSuchAVariant() {
    LmsSettings orders = orders(Map.of());
    assertThatThrownBy(() -> orders.setResolution("0.25"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("0.25, 0.5 or 1, degrees; 0.25 only with field_of_view 100");
    orders.setField("100");
    orders.setResolution("0.25");
    assertThat(orders.variant()).isEqualTo(new LmsVariant(100, 25));
    assertThat(orders.fieldOfView() + " " + orders.resolution()).isEqualTo("100 0.25");
    assertThatThrownBy(() -> orders.setField("180")).hasMessageContaining("not with resolution");
    assertThatThrownBy(() -> orders.setMode("sometimes")).hasMessage("continuous or polled");
    orders.setMode("polled");
    assertThat(orders.isPolled()).isTrue();
  }

  private static LmsSettings orders(Map<String, String> some) {
    Map<String, String> all = new HashMap<>(Map.of("link", "tcp://127.0.0.1:4001"));
    all.putAll(some);
    return LmsSettings.from(Parameters.of("atrv1/laser", all));
  }
}
