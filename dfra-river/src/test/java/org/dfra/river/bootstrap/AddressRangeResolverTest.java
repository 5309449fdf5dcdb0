package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.util.List;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription.AdministrationDescription;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.access.AddressRange;
import org.junit.jupiter.api.Test;

class AddressRangeResolverTest {

  private static AdministrationDescription from(String... texts) {
    return new AdministrationDescription(List.of(texts), new SourceLocation("robot.xml", 4));
  }

  @Test
  void addressesAndRangesStayAndNamesBecomeAddresses() throws Exception {
    assertThat(AddressRangeResolver.resolve(from())).isEmpty();
    assertThat(AddressRangeResolver.resolve(from("10.0.0.7", "10.1.0.0/16", "fd00::/8")))
        .containsExactly(
            AddressRange.of("10.0.0.7"),
            AddressRange.of("10.1.0.0/16"),
            AddressRange.of("fd00::/8"));
    assertThat(AddressRangeResolver.resolve(from("localhost")))
        .contains(AddressRange.only(InetAddress.getByName("localhost")));
  }

  @Test
  void aNameThatIsNotKnownIsReportedWithItsPlace() {
    assertThatThrownBy(() -> AddressRangeResolver.resolve(from("operator.invalid")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "robot.xml:4: the administrator's host operator.invalid is not known; write its"
                + " address, or correct the name in <administration from=\"…\">");
  }

  @Test
  void aModuleHostThatIsNotKnownIsReportedWithItsPlace() {
    RegistrarDescription registrar =
        new RegistrarDescription(
            4160,
            0,
            true,
            List.of("10.0.0.8", "second.invalid"),
            new SourceLocation("robot.xml", 6));
    assertThatThrownBy(() -> AddressRangeResolver.resolve(registrar))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "robot.xml:6: the registrar's module host second.invalid is not known; write its"
                + " address, or correct the name in <registrar module-hosts=\"…\">");
  }
}
