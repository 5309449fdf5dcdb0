package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ParametersTest {

  private static Parameters parameters(String name, String text) {
    return new Parameters(
        "atrv1/gps", Map.of(name, new Parameters.Value(text, new SourceLocation("robot.xml", 9))));
  }

  @Test
  void aTextIsGivenAsWritten() {
    assertThat(parameters("link", " sim: ").text("link")).isEqualTo(" sim: ");
    assertThat(parameters("link", "sim:").find("link")).contains("sim:");
    assertThat(parameters("link", "sim:").find("rate")).isEmpty();
  }

  @Test
  void aMissingTextIsAskedForByName() {
    assertThatThrownBy(() -> parameters("rate", "1").text("link"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "atrv1/gps: parameter link is not set; write parameter.link=… in the module's"
                + " properties or <parameter name=\"link\"> in the robot's XML");
  }

  @Test
  void numbersMayHaveSignPointAndExponent() {
    assertThat(parameters("x", " -1.5e1 ").number("x", 0, -20, 20)).isEqualTo(-15);
    assertThat(parameters("x", "20").number("x", 0, -20, 20)).isEqualTo(20);
    assertThat(parameters("x", "1").number("y", 7, 0, 10)).isEqualTo(7);
  }

  @ParameterizedTest
  @ValueSource(strings = {"fast", "", "NaN", "Infinity", "0x1p3", "9f", "1,5", "10.01", "-0.1"})
  void whatIsNoNumberInRangeIsRefusedWithTheRange(String text) {
    assertThatThrownBy(() -> parameters("rate", text).number("rate", 1, 0, 10))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "robot.xml:9: atrv1/gps: parameter rate is \""
                + text
                + "\", which is not a number from 0 to 10");
  }

  @Test
  void timeSpansAreInSeconds() {
    Duration second = Duration.ofSeconds(1);
    assertThat(parameters("timeout", "0.25").seconds("timeout", second, Duration.ZERO, second))
        .isEqualTo(Duration.ofMillis(250));
    assertThat(parameters("x", "9").seconds("timeout", second, Duration.ZERO, second))
        .isEqualTo(second);
    assertThatThrownBy(
            () ->
                parameters("timeout", "2")
                    .seconds("timeout", second, Duration.ofMillis(100), second))
        .hasMessage(
            "robot.xml:9: atrv1/gps: parameter timeout is \"2\","
                + " which is not a number of seconds from 0.1 to 1");
  }

  @Test
  void aDriverCanRefuseWhatOnlyItCanJudge() {
    Throwable cause = new IllegalArgumentException("scheme");

    assertThat(parameters("link", "ftp:x").fault("link", "a link", cause))
        .hasMessage("robot.xml:9: atrv1/gps: parameter link is \"ftp:x\", which is not a link")
        .hasCause(cause);
  }

  @Test
  void allAreInAlphabeticalOrderAndCannotBeChanged() {
    Parameters parameters = Parameters.of("a/b", Map.of("c", "3", "a", "1", "b", "2"));

    assertThat(parameters.all().keySet()).containsExactly("a", "b", "c");
    assertThatThrownBy(() -> parameters.all().clear())
        .isInstanceOf(UnsupportedOperationException.class);
    assertThat(parameters.all().get("a")).isEqualTo(new Parameters.Value("1", SourceLocation.CODE));
  }

  @Test
  void theyAreEqualByWhatIsWritten() {
    assertThat(parameters("link", "sim:"))
        .isEqualTo(parameters("link", "sim:"))
        .hasSameHashCodeAs(parameters("link", "sim:"))
        .isNotEqualTo(parameters("link", "sim:other"))
        .hasToString("atrv1/gps {link=sim:}");
  }
}
