package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.module.ModuleClassFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is reported of a driver that is not there, where this module is installed. */
class MissingDriverTest {

  @TempDir Path folder;

  @Test
  void aWrongNameIsNotTakenForAMissingModule() throws Exception {
    String wrong = MavlinkFlightImpl.class.getName() + "s";
    Files.writeString(
        folder.resolve("flight.properties"),
        "server=a.Server\nproxy=a.Proxy\nimplementation=" + wrong);
    Path xml =
        Files.writeString(
            folder.resolve("robot.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="uav" host="127.0.0.1">
              <group name="devices"><module name="flight" properties="flight.properties"/></group>
            </robot>
            """);
    ModuleDescription flight = RobotXml.read(xml).modules().get(0);
    assertThatThrownBy(() -> new ModuleClassFactory(flight).load("driver", flight.driverClass()))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageEndingWith(
            "driver class "
                + wrong
                + " is not on the group's class path; add its jar or correct the name");
  }
}
