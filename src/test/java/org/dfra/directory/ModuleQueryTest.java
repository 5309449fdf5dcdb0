package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;

class ModuleQueryTest {

  private static final ModuleQuery<GPSSensor> ANY = ModuleQuery.of(GPSSensor.class);

  @Test
  void refusesAnUnknownComponentAndNamesThoseThereAre() {
    assertThatThrownBy(() -> ANY.where(SensorAttributes.class, "maximumRate", Condition.atLeast(1)))
        .hasMessage(
            "SensorAttributes has no component \"maximumRate\"; it has reading, modes, minRate,"
                + " maxRate, power, preconditions");
  }

  @Test
  void refusesWhatAComponentsTypeCannotMeet() {
    assertThatThrownBy(() -> ANY.where(ModuleAttributes.class, "author", Condition.atLeast(1)))
        .hasMessage("ModuleAttributes.author is a String and has no range; only numbers do");
    assertThatThrownBy(() -> ANY.where(SensorAttributes.class, "maxRate", Condition.contains("1")))
        .hasMessage(
            "SensorAttributes.maxRate is a Double and contains nothing; only texts and lists do");
    assertThatThrownBy(() -> ANY.where(ModuleAttributes.class, "state", Condition.equalTo("READY")))
        .hasMessage("ModuleAttributes.state is a Readiness and never equals the String READY");
    assertThatThrownBy(() -> Condition.between(5, 1))
        .hasMessage("no number is at least 5.0 and at most 1.0; exchange the two");
    assertThatThrownBy(() -> Condition.atLeast(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> ANY.within(-1, new GeoPosition(0, 0, 0)))
        .hasMessage("no module is within -1.0 m; ask for 0 m or more");
    assertThatThrownBy(() -> ANY.where(Attributes.class, "x", Condition.contains("1")))
        .hasMessage("org.dfra.persona.Attributes is not a record; name a record of attributes");
  }

  @Test
  void refusesATypeThatDoesNotExistOrIsNoModule() {
    assertThatThrownBy(() -> ModuleQuery.ofKind("org.dfra.flow.sensor.GPSSensr"))
        .hasMessage(
            "there is no module type \"org.dfra.flow.sensor.GPSSensr\"; write the full name of an"
                + " interface, such as org.dfra.flow.sensor.GPSSensor");
    assertThatThrownBy(() -> ModuleQuery.ofKind("java.lang.String"))
        .hasMessage(
            "java.lang.String is no kind of module; name an interface that extends"
                + " org.dfra.module.Module");
    assertThatThrownBy(() -> ModuleQuery.of(ListedGps.class))
        .hasMessageContaining("ask for an interface");
    assertThat(ModuleQuery.ofKind(GPSSensor.class.getName()).kind()).isEqualTo(GPSSensor.class);
  }

  @Test
  void saysInWordsWhatItAsks() {
    assertThat(
            ANY.robot("atrv1")
                .where(SensorAttributes.class, "maxRate", Condition.atLeast(1))
                .where(SensorAttributes.class, "modes", Condition.contains("night"))
                .within(50, new GeoPosition(1, 2, 3)))
        .hasToString(
            "GPSSensor on atrv1 with SensorAttributes.maxRate ≥ 1.0 and SensorAttributes.modes"
                + " contains \"night\" within 50.0 m of 1.0°, 2.0°");
  }
}
